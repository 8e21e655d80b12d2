"""Blender 4.5 (bpy), the cloth modifier with angular bending: tension, bending and one mass for every vertex.

Its cloth counts time in frames and takes gravity times 0.001, so that gravity is real where a frame lasts sqrt(0.001) s.
Stiffness in N/m is then 1000 times what is typed.
"""

import bpy
import numpy as np
from scipy.sparse import coo_matrix

from models import Body, angle_gradients, hinge_areas, hinge_lengths, hinges_stiffness, springs

NAME = "blender"
FRAME = 0.001**0.5
TIME = 1000


def mean_edge(mesh):
    edges, _ = mesh.edges()
    return float(np.linalg.norm(np.diff(mesh.positions[edges], axis=1), axis=2).mean())


def body(mesh, parameters, masses=None):
    """Springs of tension / (mean edge), and hinges of 0.1 bending (A1 + A2) / 3: see bending_at_rest. The mass of every
    vertex is a parameter: `masses` are not taken."""
    edges, hinges = mesh.edges()
    stretch = springs(mesh, edges, TIME * parameters["tension"] / mean_edge(mesh))
    bend = hinges_stiffness(mesh, hinges, TIME * 0.1 * parameters["bending"] * hinge_areas(mesh, hinges) / 3)
    return Body(stretch, bend, np.full(len(mesh.positions), parameters["mass"]))


def bending_at_rest(mesh, bending):
    """K of Blender's hinges (3n x 3n), which is not symmetric (SIM_mass_spring_force_spring_angular in
    implicit_blender.c): with f = 0.1 bending l (theta - theta0), each corner of a triangle gets f / 3 along its normal, and
    each end of the edge loses half of both sums. The corner opposite so has f / 3 at the arm h, as a hinge of f h / 3 has."""
    _, hinges = mesh.edges()
    gradient, _ = angle_gradients(mesh.positions, hinges)
    unit = lambda g: g / np.linalg.norm(g, axis=1)[:, None]
    a, b = unit(gradient[:, 2]), unit(gradient[:, 3])
    pattern = np.stack([-(a + b) / 6, -(a + b) / 6, a / 3, b / 3], 1)
    stiffness = TIME * 0.1 * bending * hinge_lengths(mesh, hinges)
    local = np.einsum("h,hi,hj->hij", stiffness, pattern.reshape(-1, 12), gradient.reshape(-1, 12))
    dofs = (3 * hinges[:, :, None] + np.arange(3)).reshape(len(hinges), 12)
    rows, columns = np.repeat(dofs, 12, axis=1).ravel(), np.tile(dofs, (1, 12)).ravel()
    return coo_matrix((local.ravel(), (rows, columns)), shape=(3 * len(mesh.positions),) * 2).tocsc()


def hang(mesh, parameters, pins, gravity, frames, quality):
    """Positions after every frame under a gravity (m/s2) that sets in with the first (frames + 1, n, 3)."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.gravity = tuple(gravity)
    scene.frame_end = frames + 1
    data = bpy.data.meshes.new("body")
    data.from_pydata([tuple(p) for p in mesh.positions], [], mesh.triangles.tolist())
    cloth = bpy.data.objects.new("body", data)
    bpy.context.collection.objects.link(cloth)
    modifier = cloth.modifiers.new("Cloth", "CLOTH")
    settings = modifier.settings
    settings.bending_model, settings.quality, settings.mass = "ANGULAR", quality, parameters["mass"]
    settings.tension_stiffness = settings.compression_stiffness = parameters["tension"]
    settings.bending_stiffness = parameters["bending"]
    settings.tension_damping = settings.compression_damping = settings.bending_damping = settings.air_damping = 0
    modifier.collision_settings.use_collision = False
    group = cloth.vertex_groups.new(name="pins")
    group.add([int(pin) for pin in pins], 1.0, "REPLACE")
    settings.vertex_group_mass = group.name
    modifier.point_cache.frame_end = frames + 1
    result = np.empty((frames + 1, len(mesh.positions), 3))
    for frame in range(1, frames + 2):
        scene.frame_set(frame)
        flat = np.empty(3 * len(mesh.positions))
        cloth.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices.foreach_get("co", flat)
        result[frame - 1] = flat.reshape(-1, 3)
    return result


# Steps in a frame. The hanging ribbon and cloth move by 0.1 to 0.2 % of their size with half the step, and by up to 2.2 %
# with that of quality 20.
QUALITY = 320


def simulate(mesh, parameters, motion, masses=None):
    """The body at rest under the motion's gravity, in Blender's own frames; shorter steps by a higher quality."""
    frames = round(motion.frames * motion.steps_per_frame * motion.step / FRAME)
    quality = round(QUALITY * motion.steps_per_frame / 3)
    return hang(mesh, parameters, motion.pins, motion.gravity, frames, quality)[1:]


def parameters_of(original, material):
    """What the user types for the original: the net of springs and hinges that is this plate on an even mesh."""
    _, hinges = original.edges()
    young, poisson, thickness = (material[key] for key in ("young", "poisson", "thickness"))
    plate = young * thickness**3 / (12 * (1 - poisson**2))
    areas = hinge_areas(original, hinges)
    stiffness = plate * float(np.mean(3 * hinge_lengths(original, hinges) ** 2 / areas))
    return {
        "tension": np.sqrt(3) / 2 * young * thickness * mean_edge(original) / TIME,
        "bending": 3 * stiffness / (0.1 * TIME * float(areas.mean())),
        "mass": material["mass"] / len(original.positions),
    }
