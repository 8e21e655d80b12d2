"""Film strips of one motion: the original, the best other tool's untouched mesh, and ours with its settings.

Usage: python tests/bench/engines/film.py ENGINE MESH SCENE PEER OUT.png
       e.g. jolt ribbon hang "update + Regularize" docs/images/engines/jolt.png
Needs pillow besides what run.py needs, and the results of run.py for this mesh, whose settings it takes. Behind coarse
meshes stands the original of the same moment in grey.
"""

import importlib
import sys

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import run
import scenes
from meshes import carried_pins
from simplifiers import simplified

MOMENTS = 6
CELL, MARGIN, LABEL = 230, 10, 34  # the longer side of a moment, and what is around; pixels
SMOOTH = 3  # pixels drawn for each pixel of the picture
COLOURS = {"original": (120, 134, 156), "peer": (201, 116, 79), "ours": (56, 118, 201)}
GREY = (214, 219, 226)
LIGHT = np.array([0.35, -0.5, 0.8]) / np.linalg.norm([0.35, -0.5, 0.8])


def simulated(case, scene, mesh, parameters, masses=None):
    """Positions of the mesh at every frame of the first start of the scene."""
    pins = case.pins if mesh is case.original else carried_pins(case.original, case.pins, mesh)
    motion = scenes.motion(scene, 0, case.original, mesh, pins)
    frames = case.engine.simulate(mesh, parameters, motion, masses)
    if frames is None:
        raise RuntimeError("the motion diverges")
    return frames


class View:
    """A camera without perspective that looks along the original's middle axis, from a little above and aside."""

    def __init__(self, original, frames):
        frame = scenes.Frame(original)
        long, up, aside = (np.eye(3)[axis] for axis in (frame.long, frame.thin, frame.middle))
        ahead = aside - 0.35 * up - 0.3 * long
        self.depth = ahead / np.linalg.norm(ahead)
        right = np.cross(self.depth, up)
        self.right = right / np.linalg.norm(right)
        self.up = np.cross(self.right, self.depth)
        flat = self.flat(frames.reshape(-1, 3))
        self.low, extent = flat.min(axis=0), np.ptp(flat, axis=0)
        self.scale = CELL / extent.max() / 1.08
        # Width and height of a cell, and where the drawing begins in it.
        self.cell = np.ceil(extent * self.scale + 0.08 * CELL).astype(int)
        self.offset = (self.cell - extent * self.scale) / 2

    def flat(self, points):
        # Gravity pulls along the thin axis' positive direction: it is down in the picture.
        return np.column_stack([points @ self.right, points @ self.up])

    def pixels(self, points):
        return ((self.flat(points) - self.low) * self.scale + self.offset) * SMOOTH

    def draw(self, draw, origin, positions, triangles, colour, shaded=True):
        """Triangles from far to near; `origin` in pixels of the drawing."""
        corners = positions[triangles]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-30)[:, None]
        bright = 0.55 + 0.45 * np.abs(normals @ (LIGHT @ np.array([self.right, self.up, -self.depth])))
        place = self.pixels(positions) + origin
        for t in np.argsort(-(corners.mean(axis=1) @ self.depth)):
            fill = tuple(int(c * bright[t]) for c in colour) if shaded else colour
            edge = tuple(int(0.8 * c) for c in fill) if shaded else colour
            draw.polygon([tuple(p) for p in place[triangles[t]]], fill=fill, outline=edge)


PEERS = {"update + Regularize": "meshoptimizer (update, Regularize)", "pymeshlab, planar": "pymeshlab (planar)"}


def film(case, scene, peer):
    """(rows of (label, colour, mesh, frames)), the original first."""
    results = run.Store(run.CACHE, 0).results
    name, engine = case.entry["name"], case.engine.NAME
    tuned = results[f"{engine}|{name}|limber|tuning"]
    ours, other = (simplified(name, case.original, "low:6", method) for method in ("limber", peer))
    cell = f"{engine}|{name}|{scene}|0"
    percent = lambda method, state: f"{results[f'{cell}|{method}|{state}']:.2g} %"
    return [
        (f"original, {len(case.original.triangles)} faces", "original", case.original,
         simulated(case, scene, case.original, case.parameters)),
        (f"{PEERS.get(peer, peer)}, {len(other.triangles)} faces, the same numbers: {percent(peer, 'untouched')} away", "peer", other,
         simulated(case, scene, other, case.parameters)),
        (f"Limber, {len(ours.triangles)} faces, its settings: {percent('limber', 'tuned')} away", "ours", ours,
         simulated(case, scene, ours, tuned["native"], np.array(tuned["masses"]))),
    ]


def picture(rows, view):
    width, height = MOMENTS * view.cell[0] + 2 * MARGIN, len(rows) * (view.cell[1] + LABEL) + MARGIN
    image = Image.new("RGB", (width * SMOOTH, height * SMOOTH), (250, 251, 253))
    draw = ImageDraw.Draw(image)
    font = ImageFont.load_default(18 * SMOOTH)
    original = rows[0]
    for r, (label, kind, mesh, frames) in enumerate(rows):
        top = r * (view.cell[1] + LABEL) * SMOOTH
        draw.text((MARGIN * SMOOTH, top + 8 * SMOOTH), label, fill=(40, 46, 56), font=font)
        for m in range(MOMENTS):
            at = lambda one: one[round((m + 1) * len(one) / MOMENTS) - 1]
            origin = np.array([MARGIN * SMOOTH + m * view.cell[0] * SMOOTH, top + LABEL * SMOOTH])
            if r > 0:
                view.draw(draw, origin, at(original[3]), original[2].triangles, GREY, shaded=False)
            view.draw(draw, origin, at(frames), mesh.triangles, COLOURS[kind])
    return image.resize((width, height), Image.LANCZOS)


def main():
    engine, mesh, scene, peer, target = sys.argv[1:]
    entry = next(entry for entry in scenes.definition["meshes"] if entry["name"] == mesh)
    case = run.Case(importlib.import_module(f"{engine}_engine"), entry)
    rows = film(case, scene, peer)
    every = np.concatenate([frames.reshape(-1, 3) for *_, frames in rows])
    picture(rows, View(case.original, every)).save(target, optimize=True)


if __name__ == "__main__":
    main()
