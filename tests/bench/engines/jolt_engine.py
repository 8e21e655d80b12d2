"""Jolt Physics 5 (npm jolt-physics 1.1, run in Node): edges and dihedral bends with compliances, and masses."""

import json
import subprocess
import tempfile
from pathlib import Path

import numpy as np

from models import Body, hinge_areas, hinge_lengths, hinges_stiffness, springs

NAME = "jolt"
SCRIPT = Path(__file__).with_name("jolt_run.mjs")
# Substeps of a step of 1 / (60 x stepsPerFrame) s. Jolt keeps positions as floats: of Spot's small sway 80 are 0.04 % of its
# size away from 160, but 320 are 0.10 % away from both.
ITERATIONS = 80

if subprocess.run(["node", "-e", "import(process.env.LIMBER_JOLT ? require('url').pathToFileURL(process.env.LIMBER_JOLT)"
                   ".href : 'jolt-physics').catch(() => process.exit(1))"], cwd=SCRIPT.parent).returncode:
    raise ImportError("the package jolt-physics is not installed: npm install")


def body(mesh, parameters, masses=None):
    """Springs 1/2 (|d| - L)^2 / compliance and hinges 1/2 (theta - theta0)^2 / bendCompliance."""
    edges, hinges = mesh.edges()
    if masses is None:
        masses = np.full(len(mesh.positions), parameters["mass"] / len(mesh.positions))
    stretch = springs(mesh, edges, 1 / parameters["compliance"])
    return Body(stretch, hinges_stiffness(mesh, hinges, 1 / parameters["bendCompliance"]), masses)


def settings_body(mesh, parameters, masses, pins):
    """The body of a settings file (limber-settings/1) for these parameters."""
    edges, hinges = mesh.edges()
    return {
        "name": "body", "level": 0, "unit": 1,
        "mesh": {"positions": mesh.positions.ravel().tolist(), "triangles": mesh.triangles.ravel().tolist()},
        "mass": {"rule": "vertex", "perVertex": np.asarray(masses).tolist()},
        "stretch": {"constant": 1 / parameters["compliance"], "pairs": edges.ravel().tolist()},
        "bend": {"constant": 1 / parameters["bendCompliance"], "hinges": hinges.ravel().tolist()},
        "pins": [int(pin) for pin in pins], "substeps": ITERATIONS,
    }


def simulate(mesh, parameters, motion, masses=None, iterations=ITERATIONS):
    if masses is None:
        masses = np.full(len(mesh.positions), parameters["mass"] / len(mesh.positions))
    steps = motion.frames * motion.steps_per_frame
    forces = None
    if motion.force is not None:
        forces = [motion.force(k * motion.step, masses).ravel().tolist() for k in range(steps)]
    job = {
        "body": settings_body(mesh, parameters, masses, motion.pins), "start": motion.start.ravel().tolist(),
        "velocity": motion.velocity.ravel().tolist(), "step": motion.step, "frames": steps,
        "iterations": iterations, "forces": forces,
    }
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder) / "job.json", Path(folder) / "result.bin"
        source.write_text(json.dumps(job))
        subprocess.run(["node", str(SCRIPT), str(source), str(target)], check=True)
        frames = np.fromfile(target, np.float32).reshape(steps, -1, 3)[motion.steps_per_frame - 1 :: motion.steps_per_frame]
    return frames.astype(float) if np.isfinite(frames).all() else None


def parameters_of(original, material):
    """What the user types for the original: the net of springs and hinges that is this plate on an even mesh."""
    _, hinges = original.edges()
    young, poisson, thickness = (material[key] for key in ("young", "poisson", "thickness"))
    plate = young * thickness**3 / (12 * (1 - poisson**2))
    stiffness = plate * float(np.mean(3 * hinge_lengths(original, hinges) ** 2 / hinge_areas(original, hinges)))
    spring = np.sqrt(3) / 2 * young * thickness
    return {"compliance": 1 / spring, "bendCompliance": 1 / stiffness, "mass": material["mass"]}
