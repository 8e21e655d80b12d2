"""Newton 1.8 (SolverVBD): add_cloth_mesh with tri_ke, tri_ka, edge_ke and density."""

import os

os.environ.setdefault("WARP_QUIET", "1")
import newton
import numpy as np
import warp as wp

from models import Body, hinge_areas, hinge_lengths, hinges_stiffness, membrane

wp.config.quiet = True
NAME = "newton"
# VBD solves one vertex after the other, and converges slowly where stiffness x step^2 / mass is large: its steps are this
# many times shorter than the scene's. Half of that moves Spot by 0.03 % of its size in its small sway.
SUBSTEPS = 32
# Positions are floats. What a force adds to them in a step, g h^2, is lost in their rounding where steps are shorter: half the
# step moves the hanging ribbon by 0.26 % from here and by 1.60 % from 32, and the cloth by 0.24 and 0.83 %.
SUBSTEPS_UNDER_FORCE = 16
ITERATIONS = 4


def body(mesh, parameters, masses=None):
    """tri_ke, tri_ka are Lame's constants times the thickness (N/m); hinges 1/2 edge_ke L (theta - theta0)^2."""
    _, hinges = mesh.edges()
    if masses is None:
        masses = parameters["density"] * mesh.vertex_areas
    bend = hinges_stiffness(mesh, hinges, parameters["edge_ke"] * hinge_lengths(mesh, hinges))
    return Body(membrane(mesh, parameters["tri_ke"], parameters["tri_ka"]), bend, masses)


def simulate(mesh, parameters, motion, masses=None, iterations=ITERATIONS, substeps=None):
    substeps = substeps or (SUBSTEPS if motion.force is None else SUBSTEPS_UNDER_FORCE)
    builder = newton.ModelBuilder(gravity=wp.vec3(0.0))
    keys = ("tri_ke", "tri_ka", "edge_ke", "density")
    builder.add_cloth_mesh(
        pos=wp.vec3(0.0), rot=wp.quat_identity(), scale=1.0, vel=wp.vec3(0.0),
        vertices=[wp.vec3(*p) for p in mesh.positions], indices=mesh.triangles.ravel().tolist(),
        tri_kd=0.0, edge_kd=0.0, tri_drag=0.0, tri_lift=0.0, particle_radius=1e-4,
        **{key: parameters[key] for key in keys},
    )
    if masses is not None:
        builder.particle_mass = [float(mass) for mass in masses]
    for pin in motion.pins:
        builder.particle_mass[pin] = 0.0
        builder.particle_flags[pin] = builder.particle_flags[pin] & ~int(newton.ParticleFlags.ACTIVE)
    masses = np.array(builder.particle_mass)
    builder.color(include_bending=True)
    model = builder.finalize(device="cpu")
    solver = newton.solvers.SolverVBD(model, iterations=iterations, particle_enable_self_contact=False,
                                      particle_enable_tile_solve=False)
    state, after, control = model.state(), model.state(), model.control()
    state.particle_q.assign(motion.start.astype(np.float32))
    state.particle_qd.assign(motion.velocity.astype(np.float32))
    step = motion.step / substeps
    # One step from each state to the other.
    states = (state, after)
    graphs = [recorded(solver, *pair, control, step) for pair in (states, states[::-1])]
    frames, done = [], 0
    for frame in range(motion.frames):
        for _ in range(motion.steps_per_frame * substeps):
            if motion.force is not None:
                force = motion.force(done * step, masses)
                states[done % 2].particle_f.assign(force.astype(np.float32))
            wp.capture_launch(graphs[done % 2])
            done += 1
        positions = states[done % 2].particle_q.numpy().astype(float)
        if not np.isfinite(positions).all() or np.abs(positions).max() > 1e3:
            return None
        frames.append(positions)
    return np.array(frames)


def recorded(solver, before, after, control, step):
    """One step as a graph of Warp: the same kernels in the same order, without the time that Python takes to launch each."""
    with wp.ScopedCapture(device="cpu") as capture:
        solver.step(before, after, control, None, step)
    return capture.graph


def parameters_of(original, material):
    """What the user types for the original: the material's Lame constants times its thickness, its mass over the area,
    and the edge_ke of the same bending energy, D = E h^3 / (12 (1 - nu^2)), on this mesh."""
    _, hinges = original.edges()
    young, poisson, thickness = (material[key] for key in ("young", "poisson", "thickness"))
    plate = young * thickness**3 / (12 * (1 - poisson**2))
    return {
        "tri_ke": young * thickness / (2 * (1 + poisson)),
        "tri_ka": young * thickness * poisson / (1 - poisson**2),
        "edge_ke": plate * float(np.mean(hinge_lengths(original, hinges) / hinge_areas(original, hinges))),
        "density": material["mass"] / float(original.areas.sum()),
    }
