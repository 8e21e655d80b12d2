"""`limber tune` on a coarse mesh: what its settings file tells the user to type."""

import json
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

ROOT = Path(__file__).resolve().parents[3]
CLI = os.environ.get("LIMBER_CLI", str(ROOT / "dist" / "cli" / "limber.mjs"))
# What the engines' own parameters are called in the profiles (web/engine/solvers); others keep their defaults.
TYPED = {
    "mujoco": ("young", "poisson", "thickness", "mass"),
    "newton": ("tri_ke", "tri_ka", "edge_ke", "density"),
    "jolt": ("compliance", "bendCompliance"),
    "blender": ("tension", "bending", "mass"),
}


class Refused(Exception):
    """`limber tune` could not tune the mesh; its sentence."""


@dataclass
class Settings:
    """`engine`: native parameters; `masses`: kg, of the coarse mesh's vertices; `frequencies` and `motion` as in the file."""

    engine: dict
    masses: np.ndarray
    frequencies: dict
    motion: dict


def typed(engine, mesh, parameters):
    """The text of --engine for the original."""
    values = {name: parameters[name] for name in TYPED[engine]}
    if engine == "jolt":
        values["invMass"] = len(mesh.positions) / parameters["mass"]
    return ",".join(f"{name}={value:.17g}" for name, value in values.items())


def tuned(engine, source, original, parameters, file, coarse):
    """Settings for `coarse` (stored in `file`), which is to move as `original` (stored in `source`) with `parameters`.

    Raises Refused where the product refuses."""
    target = file.with_suffix(f".{engine}.json")
    command = ["node", CLI, "tune", str(source), str(file), "--solver", engine, "--settings", str(target), "--pins", "low:6",
               "--engine", typed(engine, original, parameters), "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise Refused(done.stderr.strip())
    body = _only_body(json.loads(target.read_text(encoding="utf-8")))
    place = cKDTree(np.array(body["mesh"]["positions"]).reshape(-1, 3))
    distance, vertex = place.query(coarse.positions)
    if distance.max() > 1e-6:
        raise RuntimeError(f"{target} is not of the mesh in {file}")
    masses = np.array(body["mass"]["perVertex"])[vertex]
    native = {**parameters, **{name: body["engine"][name] for name in TYPED[engine]}}
    return Settings(native, masses, body["frequencies"], body.get("motion", {}))


def _only_body(settings):
    bodies = settings["bodies"]
    if len(bodies) != 1:
        raise RuntimeError(f"expected one body, not {len(bodies)}")
    return bodies[0]
