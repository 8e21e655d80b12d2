"""Adds cloth to a ModelBuilder of Newton 1.8 from a settings file of `limber --solver newton`.

    settings = json.load(open("horse.settings.json"))
    bodies = [body for body in settings["bodies"] if body["level"] == 0]
    builder = newton.ModelBuilder(up_axis=newton.Axis.Y)
    for index in range(len(bodies)):  # those of the first level come first in the file
        add_newton_cloth(builder, settings, index)
    builder.color(include_bending=True)
    model = builder.finalize()
    model.soft_contact_mu = bodies[0]["friction"]
    substeps = substeps_for(bodies)
    iterations = max(int(body["engine"]["iterations"]) for body in bodies)
    solver = newton.solvers.SolverVBD(model, iterations=iterations, particle_enable_self_contact=False)

Then, for a frame of 1/60 s, call solver.step `substeps` times with 1 / 60 / substeps s: with longer steps VBD makes cloth far too
soft. The file has none where no number is enough, as where a triangle has no area; 64 are then a start, not a bound. Friction and the
distance of contact with itself are one number for the whole model.

For contact with itself pass particle_enable_self_contact=True, particle_self_contact_margin=d and particle_self_contact_gap=d / 2,
where d is body["selfCollisionDistance"], but well below the shortest edge: neighbours that are nearer push each other apart.
"""

import newton
import numpy as np
import warp as wp


def add_newton_cloth(builder, settings, index=0):
    """Adds one body of the file; returns the index of its first particle. Vertex v of its `mesh` is particle first + v, in metres,
    with the axes of the file, where y is up.

    Raises ValueError where the file is of another solver."""
    if settings["solver"] != "newton":
        raise ValueError(f"this settings file is for {settings['solver']}: write one with --solver newton")
    body = settings["bodies"][index]
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
    scale_triangles(builder, body, first, first_triangle)
    scale_hinges(builder, body, first, first_edge)
    return first


def substeps_for(bodies):
    """Substeps of a step of 1/60 s: those of the file, but not so many that gravity is lost. Positions are floats, and where gravity
    changes one by less than its rounding, a body at rest never falls: here by at least 16 units in the last place."""
    farthest = max(body.get("unit", 1) * np.abs(body["mesh"]["positions"]).max() for body in bodies)
    most = int(1 / 60 / np.sqrt(16 * 2.0**-23 * farthest / 9.81))
    return max(1, min(most, max(body.get("substeps", 64) for body in bodies)))


def scale_triangles(builder, body, first, first_triangle):
    """Factors of single triangles, where the file has them (--tune constraint or vertex). The builder leaves out triangles without
    area, so that the others are found by their vertices."""
    triangles = np.array(body["mesh"]["triangles"]).reshape(-1, 3)
    factors = factors_of(body, "stretch", triangles)
    if factors is None:
        return
    factor = {tuple(sorted(three)): value for three, value in zip((triangles + first).tolist(), factors.tolist())}
    for t in range(first_triangle, builder.tri_count):
        ke, ka, *others = builder.tri_materials[t]
        own = factor[tuple(sorted(int(v) for v in builder.tri_indices[t]))]
        builder.tri_materials[t] = (ke * own, ka * own, *others)


def scale_hinges(builder, body, first, first_edge):
    """Factors of single hinges, likewise."""
    hinges = np.array(body["bend"]["hinges"]).reshape(-1, 4)
    factors = factors_of(body, "bend", hinges)
    if factors is None:
        return
    factor = {tuple(sorted(pair)): value for pair, value in zip((hinges[:, :2] + first).tolist(), factors.tolist())}
    for e in range(first_edge, builder.edge_count):
        ke, kd = builder.edge_bending_properties[e]
        own = factor.get(tuple(sorted(int(v) for v in builder.edge_indices[e][2:4])), 1.0)
        builder.edge_bending_properties[e] = (ke * own, kd)


def factors_of(body, kind, vertices):
    """A factor for each constraint on its `vertices`: its own, or the mean of its vertices'. None where there are none."""
    if body[kind].get("factors"):
        return np.array(body[kind]["factors"])
    field = body.get("vertex", {}).get(kind)
    return np.array(field)[vertices].mean(axis=1) if field else None
