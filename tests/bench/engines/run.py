"""How far coarse meshes move from their original in the engines themselves.

Usage: python tests/bench/engines/run.py [--engines mujoco,newton] [--meshes spot,bowl] [--methods limber;pymeshlab]
       [--scenes sway,hang] [--starts 1,2] [--floors] [--finer 2] [--seconds 100] [--frequencies] [--tables] [--write]
Needs numpy, scipy, pymeshlab, fast-simplification and the engines (docs/motions.md says how to install them), `npm run
build`, and the meshes of ../shared/meshes or $LIMBER_SHARED/meshes. Every simulation is kept in build/bench/engines, so
that a run that was stopped, also by --seconds, goes on where it was. --starts: which ones, counted from 1; all without it.
--floors measures noise instead: the first of these starts, renumbered and with half the step. --finer simulates everything
with shorter steps, to see whether a comparison depends on them. --frequencies tunes alone, --tables only prints what is
there. --write adds it to record.json and makes the tables of docs/motions.md and docs/engines.md from what was ever
recorded.
"""

import argparse
import hashlib
import importlib
import json
import os
import sys
import time
from pathlib import Path

import numpy as np

import product
import scenes
from meshes import carried_pins, closest_points, renumbered
from models import frequency_error
from record import Record
from simplifiers import DOCUMENTED, METHODS, ROOT, mesh_file, simplified
from tables import FLOORS, summary, tables

CACHE = ROOT / "build" / "bench" / "engines"
SHARED = Path(os.environ.get("LIMBER_SHARED", ROOT.parent / "shared")) / "meshes"
ENGINES = ("mujoco", "newton", "blender", "jolt")
MODES = 10
DOCUMENT, SUMMARY = ROOT / "docs" / "motions.md", ROOT / "docs" / "engines.md"


class OutOfTime(Exception):
    pass


def load_engines(names):
    """{name: module} of those that are installed; the others are told."""
    found = {}
    for name in names:
        try:
            found[name] = importlib.import_module(f"{name}_engine")
        except (ImportError, OSError, RuntimeError) as error:
            print(f"skipped: {name} ({error})", file=sys.stderr)
    return found


class Case:
    """One original in one engine: its body, pins, targets, and whatever is computed once for all results."""

    def __init__(self, engine, entry):
        self.engine, self.entry = engine, entry
        self.original = scenes.load(entry, SHARED)
        self.pins = scenes.pins_of(self.original)
        self.parameters = engine.parameters_of(self.original, scenes.definition["material"])
        self.body = engine.body(self.original, self.parameters)
        self.points = scenes.surface_points(self.original, scenes.definition["points"])
        self.points_at_rest = scenes.at_points(self.original.positions[None], self.original.triangles, self.points)
        self._goal = None

    @property
    def goal(self):
        """The first eigenvalues of the free original."""
        if self._goal is None:
            self._goal = self.body.modes(MODES)[0]
        return self._goal

    def paths(self, scene, start, mesh=None, pins=None, points=None, parameters=None, masses=None, halved=False):
        """Positions of the sample points (frames x points x 3) of the original or of `mesh`; None if it diverged."""
        mesh = self.original if mesh is None else mesh
        pins = self.pins if pins is None else pins
        per_frame = scenes.definition["stepsPerFrame"] * (2 if halved else 1)
        motion = scenes.motion(scene, start, self.original, mesh, pins, per_frame)
        frames = self.engine.simulate(mesh, parameters or self.parameters, motion, masses)
        return None if frames is None else scenes.at_points(frames, mesh.triangles, points or self.points)


def deviation(reference, paths):
    """Mean distance over all points and frames, % of the diagonal (1 m), the distance at rest included."""
    return None if paths is None else float(100 * np.linalg.norm(paths - reference, axis=2).mean())


def at_rest(case, mesh, points):
    """The part of a deviation that is there before anything moves, % of the diagonal."""
    return deviation(case.points_at_rest, scenes.at_points(mesh.positions[None], mesh.triangles, points))


class Store:
    """Results by key in one JSON file; paths of originals as compressed arrays."""

    def __init__(self, folder, deadline):
        self.folder, self.file = folder, folder / "results.json"
        self.results = json.loads(self.file.read_text()) if self.file.exists() else {}
        self.deadline = deadline

    def get(self, key, compute):
        if key not in self.results:
            if time.time() > self.deadline:
                raise OutOfTime
            self.results[key] = compute()
            self.folder.mkdir(parents=True, exist_ok=True)
            temporary = self.file.with_suffix(".new")
            temporary.write_text(json.dumps(self.results, indent=0))
            temporary.replace(self.file)
        return self.results[key]

    def paths(self, key, compute):
        name = hashlib.sha256(key.encode()).hexdigest()[:16]
        file = self.folder / "paths" / f"{name}.npz"
        if not file.exists():
            if time.time() > self.deadline:
                raise OutOfTime
            paths = compute()
            if paths is None:
                raise RuntimeError(f"the original diverges: {key}")
            file.parent.mkdir(parents=True, exist_ok=True)
            np.savez_compressed(file, paths=paths.astype(np.float32))
        return np.load(file)["paths"].astype(float)


def floors(store, case, scene, start, reference, key):
    """Deviation of the original itself, renumbered and with half the step."""
    def of_renumbered():
        mesh, place = renumbered(case.original)
        masses = np.empty_like(case.body.masses)
        masses[place] = case.body.masses
        # The same points on the renumbered mesh: through its closest points, which are exact there.
        points = closest_points(mesh, case.points_at_rest[0])
        return deviation(reference, case.paths(scene, start, mesh, np.sort(place[case.pins]), points, None, masses))

    store.get(f"{key}|{FLOORS[0]}", of_renumbered)
    store.get(f"{key}|{FLOORS[1]}", lambda: deviation(reference, case.paths(scene, start, halved=True)))


def tune(case, coarse, method):
    """What `limber tune` writes for the coarse mesh, and its frequencies in our model of the engine.

    Where it refuses, its sentence alone."""
    name, engine = case.entry["name"], case.engine.NAME
    try:
        found = product.tuned(engine, mesh_file(name), case.original, case.parameters, mesh_file(name, method), coarse)
    except product.Refused as refused:
        print(f"{engine}, {name}, {method}: {refused}", file=sys.stderr)
        return {"refused": str(refused)}
    body = case.engine.body(coarse, found.engine, found.masses)
    return {
        "faces": len(coarse.triangles),
        "native": found.engine,
        "masses": found.masses.tolist(),
        "motion": found.motion,
        "untouched": frequency_error(case.engine.body(coarse, case.parameters).modes(MODES)[0], case.goal),
        "tuned": frequency_error(body.modes(MODES)[0], case.goal),
    }


def coarse_of(case, method):
    return simplified(case.entry["name"], case.original, "low:6", method, scenes.definition["ratio"])


def tuning_of(store, case, coarse, method):
    key = f"{case.engine.NAME}|{case.entry['name']}|{method}|tuning"
    return store.get(key, lambda: tune(case, coarse, method))


def run_result(store, case, method, scene_starts, key):
    """Untouched and tuned deviations of one method's mesh in all scenes and starts."""
    coarse = coarse_of(case, method)
    pins = carried_pins(case.original, case.pins, coarse)
    points = closest_points(coarse, case.points_at_rest[0])
    store.get(f"{case.entry['name']}|{method}|at rest", lambda: at_rest(case, coarse, points))
    tuned = tuning_of(store, case, coarse, method)
    # Where tuning is refused, the user is left with the original's parameters.
    native = tuned.get("native", case.parameters)
    masses = np.array(tuned["masses"]) if "masses" in tuned else None
    for scene, start, reference in scene_starts:
        cell = f"{key}|{scene}|{start}|{method}"
        run = lambda parameters, own: deviation(
            reference, case.paths(scene, start, coarse, pins, points, parameters, own)
        )
        store.get(f"{cell}|untouched", lambda: run(case.parameters, None))
        store.get(f"{cell}|tuned", lambda: run(native, masses))


def cases(engines, options):
    """(key, case) of every engine and mesh that was asked for; of Blender sheets alone."""
    for entry in scenes.definition["meshes"]:
        if options.meshes and entry["name"] not in options.meshes:
            continue
        for name, engine in engines.items():
            if name != "blender" or entry["kind"] == "sheet":
                yield f"{name}|{entry['name']}", Case(engine, entry)


def cells_of(store, case, start, key, options):
    """(scene, start, the original's paths) of the scenes of the case; Blender's own wind is no force by area."""
    for scene, about in scenes.definition["scenes"].items():
        if options.scenes and scene not in options.scenes:
            continue
        if about["kind"] == case.entry["kind"] and (case.engine.NAME != "blender" or scene == "hang"):
            path_key = f"{key}|{scene}|{start}|original"
            yield scene, start, store.paths(path_key, lambda: case.paths(scene, start))


def run(store, engines, options):
    for start in options.starts:
        for key, case in cases(engines, options):
            cells = list(cells_of(store, case, start, key, options))
            for method in options.methods if cells else ():
                run_result(store, case, method, cells, key)


def run_floors(store, engines, options):
    for key, case in cases(engines, options):
        for scene, start, reference in cells_of(store, case, options.starts[0], key, options):
            floors(store, case, scene, start, reference, f"{key}|{scene}|{start}")


def run_tunings(store, engines, options):
    for _, case in cases(engines, options):
        for method in options.methods:
            tuning_of(store, case, coarse_of(case, method), method)


def put_between(file, begin, end, text):
    """Replaces what stands between two marks of a file."""
    before, rest = file.read_text(encoding="utf-8").split(begin)
    after = rest.split(end)[1]
    file.write_text(f"{before}{begin}\n\n{text}\n\n{end}{after}", encoding="utf-8")


def write_documents(record):
    put_between(DOCUMENT, "<!-- tables -->", "<!-- end of tables -->", tables(record, only_complete=True))
    put_between(SUMMARY, "<!-- summary -->", "<!-- end of summary -->", summary(record))


def starts_of(text):
    """Which starts, counted from 0, of a list of numbers that counts from 1."""
    starts = [int(word) - 1 for word in text.split(",")]
    if not all(0 <= start < scenes.definition["starts"] for start in starts):
        raise argparse.ArgumentTypeError(f"starts are 1 to {scenes.definition['starts']}")
    return starts


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    words = lambda text: [word.strip() for word in text.split(";" if ";" in text else ",") if word.strip()]
    parser.add_argument("--engines", type=words, default=list(ENGINES))
    parser.add_argument("--meshes", type=words, default=[])
    parser.add_argument("--methods", type=lambda text: text.split(";"), default=list(DOCUMENTED),
                        help=f"separated by ; of: {'; '.join(METHODS)}")
    parser.add_argument("--scenes", type=words, default=[])
    parser.add_argument("--starts", type=starts_of, default=list(range(scenes.definition["starts"])), help="as 1,2")
    parser.add_argument("--floors", action="store_true", help="measure the noise of the originals alone")
    parser.add_argument("--seconds", type=float, default=1e9, help="stop after about this time; run again to go on")
    parser.add_argument("--frequencies", action="store_true", help="tune alone, simulate nothing")
    parser.add_argument("--tables", action="store_true", help="print what is there, simulate nothing")
    parser.add_argument("--finer", type=int, default=1, metavar="N", help="steps of an Nth, kept apart; not with --write")
    parser.add_argument("--write", action="store_true", help="put what is there into record.json and the documents")
    options = parser.parse_args()
    if options.finer > 1 and options.write:
        parser.error("--write records the steps of scenes.json: leave out --finer.")
    scenes.definition["stepsPerFrame"] *= options.finer
    folder = CACHE if options.finer == 1 else CACHE / f"finer-{options.finer}"
    store, finished = Store(folder, time.time() + options.seconds), True
    if not options.tables:
        work = run_tunings if options.frequencies else run_floors if options.floors else run
        try:
            work(store, load_engines(options.engines), options)
        except OutOfTime:
            finished = False
    found, record = Record(), Record.load()
    found.add(store.results)
    print(tables(found))
    if options.write:
        record.add(store.results)
        record.save()
        write_documents(record)
    if not finished:
        print("\nStopped by --seconds; run again to go on.", file=sys.stderr)


if __name__ == "__main__":
    main()
