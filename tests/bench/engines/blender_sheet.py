"""Runs docs/engines/load_blender.py: blender_sheet.py SETTINGS.json. Prints how far the vertices of the first body go in 20 frames.

`rest` is the largest distance (m) under a millionth of Blender's gravity, which starts whatever grows by itself; `fall` is the mean
drop under all of it, where a free fall is 1.96 m.
"""

import json
import sys
from pathlib import Path

import bpy
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "docs" / "engines"))
from load_blender import add_blender_cloth  # noqa: E402

FRAMES = 20


def moved(settings, gravity):
    """The way of each vertex (n, 3) under a share of Blender's gravity, in metres along the axes of the file, y up."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.gravity *= gravity
    cloth = add_blender_cloth(settings)
    cloth.modifiers["Cloth"].point_cache.frame_end = scene.frame_end = FRAMES + 1
    for frame in range(1, FRAMES + 2):
        scene.frame_set(frame)
    vertices = cloth.evaluated_get(bpy.context.evaluated_depsgraph_get()).data.vertices
    body = settings["bodies"][0]
    places = body["unit"] * np.array(body["mesh"]["positions"]).reshape(-1, 3)
    return np.array([vertex.co[:] for vertex in vertices]) - places


def main():
    settings = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    rest = np.abs(moved(settings, 1e-6)).max()
    fall = -moved(settings, 1)[:, 1].mean()
    print(json.dumps({"rest": float(rest), "fall": float(fall)}))


main()
