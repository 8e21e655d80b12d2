"""Compares our model of each engine with the engine itself: the frequency of the first mode of a free or clamped body.

Usage: python tests/bench/engines/verify.py [mujoco] [newton] [jolt] [blender]      prints a Markdown table
Exits with 1 where an engine is off by more than its limit: MuJoCo and Newton 1 %, Blender 5 %, Jolt 2 %
at 20 iterations; its difference at 10 is told too.
Engines that are not installed are told and left out.
"""

import importlib
import sys
from functools import partial

import numpy as np
from scipy.linalg import eig

from engine_motion import Motion, frequency_of
from meshes import bent_strip, bumpy_sphere, low_pins
from models import membrane
from tables import table

PINNED_PERCENT = 20
LIMITS = {"mujoco": 1, "newton": 1, "jolt": 2, "blender": 5}
PARAMETERS = {
    "mujoco": {"young": 1e4, "poisson": 0.3, "thickness": 0.02, "mass": 1},
    "newton": {"tri_ke": 80, "tri_ka": 70, "edge_ke": 10, "density": 1},
    "jolt": {"compliance": 1 / 50, "bendCompliance": 1, "mass": 1},
    "blender": {"tension": 5000, "bending": 1000, "mass": 300},
}
STEPS = {"mujoco": 400, "newton": 400, "jolt": 100}
# Of the diagonal; Jolt keeps positions as floats, and smaller motions drown in their rounding.
AMPLITUDE = {"mujoco": 2e-3, "newton": 2e-3, "jolt": 1e-2}
MESHES = {"bumpy sphere": lambda: bumpy_sphere(6), "bent strip": lambda: bent_strip((4, 8))}


def measured_frequency(engine, mesh, pins, **options):
    """(ours, the engine's) frequency of the first mode, Hz: started at its largest swing, both ways, half the difference."""
    parameters, steps = PARAMETERS[engine.NAME], STEPS[engine.NAME]
    body = engine.body(mesh, parameters)
    eigenvalues, phi = body.modes(1, pins)
    frequency = np.sqrt(eigenvalues[0]) / (2 * np.pi)
    shape = phi[:, 0].reshape(-1, 3)
    shape = shape * AMPLITUDE[engine.NAME] * mesh.diagonal / np.abs(shape).max()
    step = 1 / frequency / steps
    both = []
    for sign in (1, -1):
        motion = Motion(mesh.positions + sign * shape, np.zeros_like(shape), step, 2 * steps, 1, pins)
        both.append(engine.simulate(mesh, parameters, motion, **options))
    weight = body.masses[:, None] * shape
    signal = np.einsum("fvc,vc->f", (both[0] - both[1]) / 2, weight)
    return frequency, frequency_of(signal, step)


def jolt_frequency(engine, mesh, pins):
    ours, ten = measured_frequency(engine, mesh, pins, iterations=10)
    twenty = measured_frequency(engine, mesh, pins, iterations=20)[1]
    print(f"jolt: ours over its own {100 * (ours / ten - 1):+.2f} % at 10 iterations", file=sys.stderr)
    return ours, twenty


def blender_frequency(engine, mesh, pins):
    """(ours, Blender's): gravity sets in at once, and the first turning point is half a period away."""
    parameters = PARAMETERS["blender"]
    body = engine.body(mesh, parameters)
    free = np.setdiff1d(np.arange(len(mesh.positions)), pins)
    unknown = (3 * free[:, None] + np.arange(3)).ravel()
    stiffness = (body.stretch + engine.bending_at_rest(mesh, parameters["bending"])).toarray()
    eigenvalues, vectors = eig(stiffness[np.ix_(unknown, unknown)] / parameters["mass"])
    first = int(np.argmin(eigenvalues.real))
    omega = np.sqrt(eigenvalues[first].real)
    shape = np.zeros(3 * len(mesh.positions))
    shape[unknown] = vectors[:, first].real
    shape = shape.reshape(-1, 3) / np.abs(shape).max()
    down = shape.sum(axis=0)
    down /= np.linalg.norm(down)
    gravity = 0.01 * omega**2 * (shape**2).sum() / (shape @ down).sum()
    frames = int(1.2 * np.pi / omega / engine.FRAME)
    positions = engine.hang(mesh, parameters, pins, gravity * down, frames, 20)
    signal = np.einsum("fvc,vc->f", positions - mesh.positions, shape)
    k = int(np.argmax(signal[1:-1])) + 1
    before, at, after = signal[k - 1 : k + 2]
    # Half a frame: positions are those after a step whose velocity had the whole gravity.
    top = k + 0.5 * (before - after) / (before - 2 * at + after) - 0.5
    return omega / (2 * np.pi), 1 / (2 * top * engine.FRAME)


def compare_stiffness(engine):
    """The relative difference of MuJoCo's stiffness at rest from our formulas, in a row of the table."""
    mesh, parameters = bumpy_sphere(4), PARAMETERS["mujoco"]
    shear, lame, bend = engine.plate_constants(parameters)
    ours = (membrane(mesh, shear, lame) + engine.bending_at_rest(mesh, bend)).toarray()
    theirs = engine.stiffness_by_differences(mesh, parameters)
    difference = np.linalg.norm(ours - theirs) / np.linalg.norm(theirs)
    return ["mujoco", "bumpy sphere, K at rest", "", "", f"{difference:.1e}"], difference < 1e-6


def check(name, engine):
    rows, isWithin = [], True
    if name == "mujoco":
        row, isWithin = compare_stiffness(engine)
        rows.append(row)
    for mesh_name, generate in MESHES.items():
        mesh = generate()
        clamped = low_pins(mesh, PINNED_PERCENT)
        for pins, words in ((np.zeros(0, int), "free"), (clamped, "clamped")):
            if name == "blender" and len(pins) == 0:
                continue
            special = {
                "blender": blender_frequency,
                "jolt": jolt_frequency,
                "mujoco": partial(measured_frequency, substeps=1),
                "newton": partial(measured_frequency, iterations=20, substeps=1),
            }
            compare = special.get(name, measured_frequency)
            ours, theirs = compare(engine, mesh, pins)
            error = 100 * (ours / theirs - 1)
            isWithin = isWithin and abs(error) <= LIMITS[name]
            rows.append([name, f"{mesh_name}, {words}", f"{ours:.4g}", f"{theirs:.4g}", f"{error:+.2f} %"])
    return rows, isWithin


def main():
    rows, failed = [], []
    for name in sys.argv[1:] or list(LIMITS):
        try:
            engine = importlib.import_module(f"{name}_engine")
        except ImportError as error:
            print(f"skipped: {name} ({error})", file=sys.stderr)
            continue
        found, isWithin = check(name, engine)
        rows += found
        if not isWithin:
            failed.append(name)
    print(table(["engine", "body", "our model, Hz", "the engine, Hz", "difference"], rows))
    if failed:
        print(f"Off by more than the limit: {', '.join(failed)}.", file=sys.stderr)
        sys.exit(1)


if __name__ == "__main__":
    main()
