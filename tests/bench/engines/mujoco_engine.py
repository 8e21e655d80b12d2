"""MuJoCo 4.0: a flex of dimension 2, as user parameters young, poisson, thickness and total mass describe it."""

import mujoco
import numpy as np
from scipy.sparse import coo_matrix

from models import Body, hinge_areas, hinge_lengths, hinges_stiffness, membrane

NAME = "mujoco"
# Its implicit steps damp: they are this many times shorter than the scene's. Of goathead's large sway a quarter of what the
# scene's own steps are off is left.
SUBSTEPS = 4


def xml(mesh, parameters, timestep, pins=()):
    numbers = lambda array, form: " ".join(form % x for x in np.ravel(array))
    pin = f'<pin id="{numbers(pins, "%d")}"/>' if len(pins) else ""
    return f"""<mujoco><option timestep="{timestep:.17g}" gravity="0 0 0" integrator="discrete"/><size memory="1G"/><worldbody>
<flexcomp name="body" type="direct" dim="2" mass="{parameters['mass']:.17g}" radius="1e-4"
 point="{numbers(mesh.positions, '%.17g')}" element="{numbers(mesh.triangles, '%d')}">
<contact selfcollide="none" contype="0" conaffinity="0"/><edge equality="false"/>{pin}
<elasticity young="{parameters['young']:.17g}" poisson="{parameters['poisson']:.17g}"
 thickness="{parameters['thickness']:.17g}" elastic2d="both"/></flexcomp></worldbody></mujoco>"""


def plate_constants(parameters):
    """(shear modulus x thickness, plane-stress lambda x thickness, D)."""
    young, poisson, thickness = (parameters[key] for key in ("young", "poisson", "thickness"))
    shear = young * thickness / (2 * (1 + poisson))
    return shear, young * thickness * poisson / (1 - poisson**2), young * thickness**3 / (12 * (1 - poisson**2))


def bending_at_rest(mesh, bend_constant):
    """K of MuJoCo's bending at the rest shape (3n x 3n), from its very energy: with s = D / (A1 + A2), rest angle theta, c the cotangent vector,
    1/2 s cos(theta) |sum c_i x_i|^2 + s sin(theta) (c01 + c03)(c02 + c04) / L det(x1 - x0, x2 - x0, x3 - x0).

    user_mesh.cc, ComputeBending: Wardetzky et al. 2007, and the curved reference of Garg et al. 2007, Cubic Shells. For
    rest angles near 0 it is 1/2 s L^2 (theta - theta0)^2. At larger ones the rest shape is no equilibrium; around the
    equilibrium nearby it moves as 1/2 s L^2 (theta - theta0)^2 does, which `body` therefore has (verify.py).
    """
    _, hinges = mesh.edges()
    p = mesh.positions
    x0, x1, x2, x3 = (p[hinges[:, k]] for k in range(4))

    def cot(apex, a, b):
        u, v = a - apex, b - apex
        return (u * v).sum(1) / np.linalg.norm(np.cross(u, v), axis=1)

    c01, c02, c03, c04 = cot(x0, x1, x2), cot(x0, x3, x1), cot(x1, x2, x0), cot(x1, x0, x3)
    c = np.stack([c03 + c04, c01 + c02, -(c01 + c03), -(c02 + c04)], 1)
    length = hinge_lengths(mesh, hinges)
    s = bend_constant / hinge_areas(mesh, hinges)
    n1, n2 = np.cross(x1 - x0, x2 - x0), np.cross(x3 - x0, x1 - x0)
    n1 /= np.linalg.norm(n1, axis=1)[:, None]
    n2 /= np.linalg.norm(n2, axis=1)[:, None]
    cosine = (n1 * n2).sum(1)
    sine = (np.cross(n1, n2) * (x1 - x0)).sum(1) / length
    local = np.einsum("h,hi,hj,xy->hixjy", s * cosine, c, c, np.eye(3))
    local += (s * sine * (c01 + c03) * (c02 + c04) / length)[:, None, None, None, None] * _triple_hessian(
        x1 - x0, x2 - x0, x3 - x0
    )
    dofs = (3 * hinges[:, :, None] + np.arange(3)).reshape(len(hinges), 12)
    rows, columns = np.repeat(dofs, 12, axis=1).ravel(), np.tile(dofs, (1, 12)).ravel()
    return coo_matrix((local.reshape(-1), (rows, columns)), shape=(3 * len(p),) * 2).tocsc()


def _triple_hessian(a, b, c):
    """Second derivatives of a . (b x c) by x0 .. x3 with a = x1 - x0, b = x2 - x0, c = x3 - x0 (h, 4, 3, 4, 3)."""
    def skew(v):
        zero = np.zeros(len(v))
        rows = [[zero, -v[:, 2], v[:, 1]], [v[:, 2], zero, -v[:, 0]], [-v[:, 1], v[:, 0], zero]]
        return np.moveaxis(np.array(rows), 2, 0)

    hessian = np.zeros((len(a), 4, 3, 4, 3))
    # The gradients are b x c, c x a and a x b.
    for i, j, matrix in ((1, 2, -skew(c)), (1, 3, skew(b)), (2, 3, -skew(a))):
        hessian[:, i, :, j] = matrix
        hessian[:, j, :, i] = np.moveaxis(matrix, 1, 2)
    hessian[:, 0] = -hessian[:, 1:].sum(axis=1)
    hessian[:, :, :, 0] = -hessian[:, :, :, 1:].sum(axis=3)
    return hessian


def body(mesh, parameters, masses=None):
    shear, lame, bend = plate_constants(parameters)
    if masses is None:
        masses = np.full(len(mesh.positions), parameters["mass"] / len(mesh.positions))
    _, hinges = mesh.edges()
    constants = bend * hinge_lengths(mesh, hinges) ** 2 / hinge_areas(mesh, hinges)
    return Body(membrane(mesh, shear, lame), hinges_stiffness(mesh, hinges, constants), masses)


def stiffness_by_differences(mesh, parameters, step=1e-6):
    """K at rest (3n x 3n) from MuJoCo's own spring forces, by central differences."""
    model = mujoco.MjModel.from_xml_string(xml(mesh, parameters, 1e-3))
    data = mujoco.MjData(model)

    def forces(dof, offset):
        data.qpos[:] = 0
        data.qpos[dof] = offset
        mujoco.mj_fwdPosition(model, data)
        mujoco.mj_fwdVelocity(model, data)
        return data.qfrc_spring.copy()

    return -np.array([forces(dof, step) - forces(dof, -step) for dof in range(model.nv)]).T / (2 * step)


def simulate(mesh, parameters, motion, masses=None, substeps=SUBSTEPS):
    """Positions after every frame (frames x n x 3); see engine_motion.Motion."""
    model = mujoco.MjModel.from_xml_string(xml(mesh, parameters, motion.step / substeps, motion.pins))
    bodies = model.flex_vertbodyid
    free = np.flatnonzero(bodies > 0)
    if masses is not None:
        model.body_mass[bodies[free]] = masses[free]
        model.body_inertia[bodies[free]] = masses[free, None] * 1e-6
        mujoco.mj_setConst(model, mujoco.MjData(model))
    masses = np.zeros(len(mesh.positions)) if masses is None else masses
    masses = np.where(bodies > 0, model.body_mass[bodies], 0)
    data = mujoco.MjData(model)
    dofs = (model.body_dofadr[bodies[free]][:, None] + np.arange(3)).ravel()
    rest = mesh.positions[free].ravel()
    data.qpos[dofs] = motion.start[free].ravel() - rest
    data.qvel[dofs] = motion.velocity[free].ravel()
    frames = []
    for frame in range(motion.frames):
        for _ in range(motion.steps_per_frame * substeps):
            if motion.force is not None:
                data.qfrc_applied[dofs] = motion.force(data.time, masses)[free].ravel()
            mujoco.mj_step(model, data)
        positions = motion.start.copy()
        positions[free] = (data.qpos[dofs] + rest).reshape(-1, 3)
        if not np.isfinite(positions).all() or np.abs(positions).max() > 1e3:
            return None
        frames.append(positions)
    return np.array(frames)


def parameters_of(original, material):
    """What the user types for the original."""
    return dict(material)
