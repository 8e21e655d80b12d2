"""Adds cloth to a ModelBuilder of Newton 1.8 from a settings file of `limber --solver newton`.

    settings = json.load(open("horse.settings.json"))
    builder = newton.ModelBuilder()
    add_newton_cloth(builder, settings["bodies"][0])
    builder.color(include_bending=True)
    model = builder.finalize()
    solver = newton.solvers.SolverVBD(model, iterations=20)
"""

import newton
import numpy as np
import warp as wp


def add_newton_cloth(builder, body):
    """Adds one body of the file; returns the index of its first particle. Vertex v is particle first + v."""
    unit, engine = body.get("unit", 1), body["engine"]
    positions = unit * np.array(body["mesh"]["positions"]).reshape(-1, 3)
    first, first_triangle, first_edge = builder.particle_count, builder.tri_count, builder.edge_count
    builder.add_cloth_mesh(
        pos=wp.vec3(0.0), rot=wp.quat_identity(), scale=1.0, vel=wp.vec3(0.0),
        vertices=[wp.vec3(*p) for p in positions], indices=body["mesh"]["triangles"],
        density=engine["density"], tri_ke=engine["tri_ke"], tri_ka=engine["tri_ka"], edge_ke=engine["edge_ke"],
        tri_kd=engine.get("tri_kd", 0.0), edge_kd=engine.get("edge_kd", 0.0), tri_drag=engine.get("tri_drag", 0.0),
        tri_lift=engine.get("tri_lift", 0.0), particle_radius=body.get("collisionThickness", 0.001),
    )
    # Masses carried over from the original; add_cloth_mesh has given those of `density`.
    for v, mass in enumerate(body["mass"]["perVertex"]):
        builder.particle_mass[first + v] = mass
    for v in body["pins"]:
        builder.particle_mass[first + v] = 0.0
        builder.particle_flags[first + v] &= ~int(newton.ParticleFlags.ACTIVE)
    scale_constraints(builder, body, first, first_triangle, first_edge)
    return first


def scale_constraints(builder, body, first, first_triangle, first_edge):
    """Factors of single triangles and hinges, where the file has them (--tune constraint)."""
    for t, factor in enumerate(body["stretch"].get("factors", [])):
        ke, ka, *others = builder.tri_materials[first_triangle + t]
        builder.tri_materials[first_triangle + t] = (ke * factor, ka * factor, *others)
    if not body["bend"].get("factors"):
        return
    ends = np.array(body["bend"]["hinges"]).reshape(-1, 4)[:, :2] + first
    factor = {tuple(sorted(pair)): value for pair, value in zip(ends.tolist(), body["bend"]["factors"])}
    for e in range(first_edge, builder.edge_count):
        ke, kd = builder.edge_bending_properties[e]
        own = factor.get(tuple(sorted(int(v) for v in builder.edge_indices[e][2:4])), 1.0)
        builder.edge_bending_properties[e] = (ke * own, kd)
