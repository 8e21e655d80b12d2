"""Runs a loader of docs/engines: flap.py mujoco|newton|blender SETTINGS.json VERTEX. Prints the frequency of a flap in Hz.

The first body of the settings is flat, in the plane z = 0, and only VERTEX is not pinned: it swings as the flap of one
hinge. In MuJoCo it is the last of several bodies, all in one model. Exits with 3 and a sentence where the engine is not installed.
"""

import importlib
import json
import os
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "docs" / "engines"))
LIFT = 0.002
STEP = 0.002
SECONDS = 2.0
# Blender's gravity is real where a frame lasts sqrt(0.001) s; its cloth counts time in frames.
BLENDER_FRAME = 0.001**0.5


def flap_in_mujoco(settings, vertex):
    import mujoco

    from load_mujoco import flexcomp, load_mujoco, set_values

    model = load_mujoco(settings, timestep=STEP)
    bodies = settings["bodies"]
    if len(bodies) > 1:
        flexes = "".join(flexcomp(body, f"flex {k}") for k, body in enumerate(bodies))
        option = f'<option timestep="{STEP}" integrator="discrete"><flag contact="disable"/></option>'
        model = mujoco.MjModel.from_xml_string(f"<mujoco>{option}<worldbody>{flexes}</worldbody></mujoco>")
        for k, body in enumerate(bodies):
            set_values(model, body, k)
        mujoco.mj_setConst(model, mujoco.MjData(model))
    model.opt.gravity[:] = 0
    data = mujoco.MjData(model)
    address = model.body_dofadr[model.flex_vertbodyid[model.flex_vertadr[-1] + vertex]]
    data.qpos[address + 2] = LIFT
    heights = []
    for _ in range(round(SECONDS / STEP)):
        mujoco.mj_step(model, data)
        heights.append(data.qpos[address + 2])
    return crossings(heights, STEP)


def flap_in_newton(settings, vertex):
    os.environ.setdefault("WARP_QUIET", "1")
    import newton
    import warp as wp

    from load_newton import add_newton_cloth

    wp.config.quiet = True
    builder = newton.ModelBuilder(gravity=wp.vec3(0.0))
    vertex += add_newton_cloth(builder, settings)
    builder.color(include_bending=True)
    model = builder.finalize(device="cpu")
    solver = newton.solvers.SolverVBD(model, iterations=10, particle_enable_self_contact=False)
    state, after, control = model.state(), model.state(), model.control()
    positions = state.particle_q.numpy()
    positions[vertex, 2] += LIFT
    state.particle_q.assign(positions)
    heights = []
    for _ in range(round(SECONDS / STEP)):
        solver.step(state, after, control, None, STEP)
        state, after = after, state
        heights.append(float(state.particle_q.numpy()[vertex, 2]))
    return crossings(heights, STEP)


def flap_in_blender(settings, vertex):
    import bpy

    from load_blender import add_blender_cloth

    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    # A step of gravity: the flap swings about its new balance, and its lowest point is half a period away.
    # The loader turns the file's z to Blender's -y.
    scene.gravity = (0, 0.05, 0)
    frames = round(SECONDS / BLENDER_FRAME)
    scene.frame_end = frames
    cloth = add_blender_cloth(settings)
    cloth.modifiers["Cloth"].point_cache.frame_end = frames
    heights = []
    for frame in range(1, frames + 1):
        scene.frame_set(frame)
        heights.append(cloth.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices[vertex].co.z)
    centre = (max(heights) + min(heights)) / 2
    return crossings(np.array(heights) - centre, BLENDER_FRAME)


def crossings(heights, step):
    heights = np.asarray(heights)
    at = np.flatnonzero(np.sign(heights[1:]) != np.sign(heights[:-1]))
    time = (at + heights[at] / (heights[at] - heights[at + 1])) * step
    return (len(time) - 1) / (2 * (time[-1] - time[0]))


def main():
    engine, file, vertex = sys.argv[1:]
    settings = json.loads(Path(file).read_text(encoding="utf-8"))
    try:
        importlib.import_module(f"load_{engine}")
    except ImportError as error:
        print(f"{engine} is not installed ({error})", file=sys.stderr)
        sys.exit(3)
    flap = {"mujoco": flap_in_mujoco, "newton": flap_in_newton, "blender": flap_in_blender}[engine]
    print(json.dumps({"frequency": flap(settings, int(vertex))}))


main()
