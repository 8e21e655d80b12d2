"""Runs docs/recipes/blender.py: weights, UVs, cloth settings and place come back; FBX, USD and Alembic go through.

    python tests/bench/recipes_blender.py        in a Python with the bpy package; needs `npm run build`
"""

import os
import pathlib
import subprocess
import sys
import tempfile

import bpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
os.environ.setdefault("LIMBER", f"node {ROOT / 'dist' / 'cli' / 'limber.mjs'}")
sys.path.insert(0, str(ROOT / "docs" / "recipes"))
import blender  # noqa: E402


def cloth_sheet(cells=24):
    """A sheet of 2 by 2 with UVs, whose group "pins" falls off linearly along x, turned, moved and scaled by a half."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.mesh.primitive_grid_add(x_subdivisions=cells, y_subdivisions=cells, size=2)
    sheet = bpy.context.active_object
    group = sheet.vertex_groups.new(name="pins")
    for vertex in sheet.data.vertices:
        group.add([vertex.index], (vertex.co.x + 1) / 2, "REPLACE")
    sheet.location, sheet.rotation_euler, sheet.scale = (1, 2, 3), (0.3, 0.2, 0.1), (0.5, 0.5, 0.5)
    cloth = sheet.modifiers.new("Cloth", "CLOTH")
    cloth.settings.tension_stiffness, cloth.settings.mass = 20, 0.02
    cloth.settings.vertex_group_mass = "pins"
    cloth.settings.effector_weights.gravity = 0.3
    contacts = cloth.collision_settings
    contacts.use_self_collision, contacts.collision_quality, contacts.friction = True, 5, 20
    contacts.distance_min, contacts.self_distance_min = 0.01, 0.02
    bpy.context.view_layer.update()
    return sheet


def check(condition, words):
    print(("ok      " if condition else "FAILED  ") + words)
    return bool(condition)


def check_object():
    sheet = cloth_sheet()
    found = []
    bring = blender._bring_cloth
    blender._bring_cloth = lambda cloth, thing, settings: found.append(settings) or bring(cloth, thing, settings)
    result = blender.optimize(sheet, "--ratio 0.4")
    mesh, group = result.data, result.vertex_groups["pins"]
    weights = {v.index: next((g.weight for g in v.groups if g.group == group.index), 0.0) for v in mesh.vertices}
    weight_error = max(abs(weights[v.index] - (v.co.x + 1) / 2) for v in mesh.vertices)
    uvs = mesh.uv_layers[0].data
    uv_error = max(abs(uvs[loop.index].uv.x - (mesh.vertices[loop.vertex_index].co.x + 1) / 2) for loop in mesh.loops)
    modifier = result.modifiers["Cloth"]
    cloth, contacts = modifier.settings, modifier.collision_settings
    same = (contacts.use_self_collision, contacts.collision_quality, round(cloth.effector_weights.gravity, 6))
    grown = contacts.distance_min / 0.01
    bpy.context.view_layer.update()
    offset = max(abs(a - b) for p, q in zip(result.matrix_world, sheet.matrix_world) for a, b in zip(p, q))
    faces = len(mesh.polygons)
    body = found[0]["bodies"][0]
    engine, positions = body["engine"], body["mesh"]["positions"]
    held = [positions[3 * pin] for pin in body["pins"]]
    values = [(engine[name], getattr(cloth, to)) for name, to in blender.CLOTH.items() if name in engine and name != "quality"]
    values += [(engine[name], getattr(contacts, name)) for name in blender.CONTACTS]
    engine_error = max(abs(a - b) / max(1e-9, abs(a)) for a, b in values)
    return [
        check(0 < faces <= 0.4 * 2 * 24 * 24, f"{faces} faces of {2 * 24 * 24}"),
        check(weight_error < 0.02, f"weights are within {weight_error:.4f} of the linear field"),
        check(uv_error < 0.02, f"UVs are within {uv_error:.4f} of the linear field"),
        check(offset < 1e-6, "the result is where the original is"),
        check(cloth.vertex_group_mass == "pins", "pins are the group"),
        check(cloth.mass > 0.02, f"the mass of a vertex grew from 0.02 to {cloth.mass:.4f}, as there are fewer"),
        check(abs(body["unit"] - 0.5) < 1e-6, f"a unit of the settings is {body['unit']} m"),
        check(held and min(held) > 0, f"{len(held)} vertices are tuned as held, where the group is above a half"),
        check(engine_error < 1e-5, "tension, bending, mass, dampings, distances and friction are those of the settings file"),
        check(same == (True, 5, 0.3), "self-collision, quality of collision and the weight of gravity came back"),
        check(abs(contacts.friction - 20) < 1e-4, f"friction is {contacts.friction:.4g}, as it was"),
        check(grown > 1.2 and abs(contacts.self_distance_min / 0.02 - grown) < 1e-3, f"distances grew with the edges, {grown:.2f} times"),
    ]


def check_shading():
    """A closed ball stays closed, and the corners of its faces keep the normals of the file."""
    passed, found = [], []
    weld = blender._weld
    normals = lambda mesh: [normal.vector.copy() for normal in mesh.corner_normals]
    blender._weld = lambda mesh, flat: found.append((normals(mesh), weld(mesh, flat), normals(mesh)))
    smooth_above = {"flat": 2, "smooth": -2, "half of both": 0}
    for shading, height in smooth_above.items():
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4)
        ball = bpy.context.active_object
        for face in ball.data.polygons:
            face.use_smooth = face.center.z > height
        mesh = blender.optimize(ball, "--ratio 0.3").data
        faces, vertices = len(mesh.polygons), len(mesh.vertices)
        passed.append(check(vertices == faces // 2 + 2, f"{shading}: a closed ball of {faces} faces has {vertices} vertices"))
        before, _, after = found.pop()
        change = max((a - b).length for a, b in zip(before, after, strict=True))
        passed.append(check(change < 0.001, f"{shading}: normals of corners are within {change:.1e} of those of the file"))
        is_flat = all(face.normal.dot(after[corner]) > 0.9999 for face in mesh.polygons for corner in face.loop_indices)
        passed.append(check(is_flat == (shading == "flat"), f"{shading}: all faces are {'flat' if is_flat else 'not flat'}"))
    blender._weld = weld
    return passed


def check_files():
    passed = []
    for ending in (".fbx", ".usdc", ".abc"):
        with tempfile.TemporaryDirectory() as folder:
            source, target = (os.path.join(folder, f"{name}{ending}") for name in ("in", "out"))
            sheet = cloth_sheet()
            sheet.modifiers.clear()
            blender.FILES[ending][1](source)
            script = ROOT / "docs" / "recipes" / "blender.py"
            run = subprocess.run([sys.executable, script, source, target, "--ratio", "0.4"], capture_output=True, text=True, check=False)
            bpy.ops.wm.read_factory_settings(use_empty=True)
            if run.returncode == 0:
                blender.FILES[ending][0](target)
            meshes = [one for one in bpy.data.objects if one.type == "MESH"]
            faces = sum(len(one.data.polygons) for one in meshes)
            passed.append(check(len(meshes) == 1 and 0 < faces <= 0.4 * 1152, f"{ending}: {faces} faces {run.stderr[-300:]}"))
    return passed


if __name__ == "__main__":
    sys.exit(0 if all(check_object() + check_shading() + check_files()) else 1)
