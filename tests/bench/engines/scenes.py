"""Motions of scenes.json on any mesh of the same shape."""

import json
from functools import partial
from pathlib import Path

import numpy as np

from engine_motion import Motion
from meshes import largest_component, low_pins, read_obj, unit_scale

GRAVITY = 9.81
PINNED_PERCENT = 6
SWAY_SPEED = 0.6
# Of each start.
TWIST_DEGREES = (30, 22.5, 15, -22.5, -15)
HANG_DEGREES = (0, 20, 40, 10, 30)
GUST_PHASES = (0, 0.2, 0.4, 0.1, 0.3)
# Of the small motions, in which thin shells do not buckle.
SMALL = 1 / 3

definition = json.loads(Path(__file__).with_name("scenes.json").read_text(encoding="utf-8"))


def load(entry, folder):
    """The original of scenes.json: its largest component, at a diagonal of 1 m."""
    return unit_scale(largest_component(read_obj(Path(folder) / entry["file"])))


class Frame:
    """Axes of the original's bounding box: `long` from the pins on, `across` the thinnest, and heights from 0 to 1."""

    def __init__(self, original):
        size = np.ptp(original.positions, axis=0)
        self.long, self.thin = int(np.argmax(size)), int(np.argmin(size))
        self.middle = 3 - self.long - self.thin if self.long != self.thin else (self.long + 1) % 3
        self.low, self.size = original.positions[:, self.long].min(), size[self.long]
        self.centre = original.positions.mean(axis=0)
        self.area = original.areas.sum()

    def height(self, positions):
        return np.clip((positions[:, self.long] - self.low) / self.size, 0, 1)

    def direction(self, axis):
        return np.eye(3)[axis]


def motion(name, start, original, mesh, pins, steps_per_frame=None):
    """The Motion of `mesh` (the original or a coarse mesh of it) in scene `name`, start number `start`."""
    frame = Frame(original)
    per_frame = steps_per_frame or definition["stepsPerFrame"]
    step = 1 / (definition["framesPerSecond"] * per_frame)
    frames = round(definition["seconds"] * definition["framesPerSecond"])
    result = Motion(mesh.positions.copy(), np.zeros_like(mesh.positions), step, frames, per_frame, pins)
    _starts[name](result, start, frame, mesh)
    result.start[pins] = mesh.positions[pins]
    result.velocity[pins] = 0
    return result


def _sway(result, start, frame, mesh, size=1):
    angle = np.radians(72 * start)
    direction = np.cos(angle) * frame.direction(frame.thin) + np.sin(angle) * frame.direction(frame.middle)
    result.velocity[:] = size * SWAY_SPEED * frame.height(mesh.positions)[:, None] ** 2 * direction


def _release(result, start, frame, mesh, size=1):
    angle = size * np.radians(TWIST_DEGREES[start]) * frame.height(mesh.positions)
    a, b = (frame.long + 1) % 3, (frame.long + 2) % 3
    x, y = mesh.positions[:, a] - frame.centre[a], mesh.positions[:, b] - frame.centre[b]
    result.start[:, a] = frame.centre[a] + np.cos(angle) * x - np.sin(angle) * y
    result.start[:, b] = frame.centre[b] + np.sin(angle) * x + np.cos(angle) * y


def _hang(result, start, frame, mesh):
    angle = np.radians(HANG_DEGREES[start])
    down = GRAVITY * (np.cos(angle) * frame.direction(frame.thin) + np.sin(angle) * frame.direction(frame.long))
    result.force = lambda time, masses: masses[:, None] * down
    result.gravity = down


def _wind(result, start, frame, mesh):
    down = GRAVITY * frame.direction(frame.long)
    # By area, whatever the masses are: the force of a gust does not know them.
    push = 0.5 * GRAVITY * mesh.vertex_areas[:, None] / frame.area * frame.direction(frame.thin)
    phase = GUST_PHASES[start]
    result.force = lambda time, masses: masses[:, None] * down + np.sin(np.pi * (time + phase)) ** 2 * push


_starts = {
    "sway": _sway,
    "release": _release,
    "small sway": partial(_sway, size=SMALL),
    "small release": partial(_release, size=SMALL),
    "hang": _hang,
    "wind": _wind,
}


def pins_of(original):
    return low_pins(original, PINNED_PERCENT)


def surface_points(original, count):
    """(triangles, weights) of area-uniform points, the same in every run."""
    random = np.random.default_rng(20)
    share = original.areas / original.areas.sum()
    triangle = np.searchsorted(np.cumsum(share), (np.arange(count) + random.random(count)) / count)
    u, v = random.random((2, count))
    flip = u + v > 1
    u[flip], v[flip] = 1 - u[flip], 1 - v[flip]
    return np.minimum(triangle, len(share) - 1), np.column_stack([1 - u - v, u, v])


def at_points(frames, triangles, points):
    triangle, weights = points
    return np.einsum("fpkc,pk->fpc", frames[:, triangles[triangle]], weights)
