"""Optimizes mesh objects of Blender with limber, and brings mesh, UVs, weights of vertex groups and cloth settings back.

In Blender (Scripting), with objects selected:

    import sys; sys.path.append("/path/to/limber/docs/recipes"); import blender
    for thing in list(bpy.context.selected_objects): blender.optimize(thing, "--ratio 0.4")

or without a window, for every format that Blender imports and exports (FBX, USD, Alembic, VRM with its add-on):

    python blender.py IN.fbx OUT.fbx --ratio 0.4        # in a Python with the bpy package; blender --background --python blender.py -- ...

The original is kept, hidden; the result is added with "_limber" after its name. LIMBER is the command ("limber" if it is not set).
"""

import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

import bpy
import bmesh  # comes with bpy, which must be imported first

#: Attributes of glTF that start with an underscore are the user's own; limber interpolates them like UVs.
GROUP = "_group_"
#: Parameters of the cloth modifier, by their names in limber's profile of Blender.
CLOTH = {"tension": "tension_stiffness", "bending": "bending_stiffness", "mass": "mass", "air": "air_damping"}
CLOTH |= {"tension_damping": "tension_damping", "bending_damping": "bending_damping", "quality": "quality"}
#: Those of its collision settings, which have the same names.
CONTACTS = ("distance_min", "self_distance_min", "friction")


def optimize(thing, options=""):
    """The optimized copy of a mesh object. Raises RuntimeError with limber's message if it fails."""
    cloth = next((modifier for modifier in thing.modifiers if modifier.type == "CLOTH"), None)
    with tempfile.TemporaryDirectory() as folder:
        paths = {name: os.path.join(folder, name) for name in ("in.glb", "out.glb", "settings.json")}
        _export(thing, paths["in.glb"])
        words = [*shlex.split(options), *(_cloth_options(thing, cloth, paths["settings.json"]) if cloth else [])]
        _run(["optimize", paths["in.glb"], paths["out.glb"], *words])
        result = _import(paths["out.glb"], thing)
        _bring_groups(thing, result)
        if cloth:
            _bring_cloth(cloth, result, json.loads(pathlib.Path(paths["settings.json"]).read_text("utf-8")))
    thing.hide_set(True)
    return result


def _run(words):
    limber = shlex.split(os.environ.get("LIMBER", "limber"))
    run = subprocess.run([*limber, *words], capture_output=True, text=True, check=False)
    print(run.stdout.strip() or run.stderr.strip())
    if run.returncode not in (0, 2):
        raise RuntimeError(run.stderr.strip())


def _only(thing):
    bpy.ops.object.select_all(action="DESELECT")
    thing.select_set(True)
    bpy.context.view_layer.objects.active = thing


def _export(thing, path):
    """The mesh in its own space without its modifiers, with a float attribute for each vertex group."""
    copy = thing.copy()
    copy.data = thing.data.copy()
    bpy.context.collection.objects.link(copy)
    copy.parent = None
    copy.matrix_world.identity()
    copy.modifiers.clear()
    for group in copy.vertex_groups:
        attribute = copy.data.attributes.new(f"{GROUP}{group.index}", "FLOAT", "POINT")
        for vertex in copy.data.vertices:
            weights = [entry.weight for entry in vertex.groups if entry.group == group.index]
            attribute.data[vertex.index].value = weights[0] if weights else 0.0
    _only(copy)
    bpy.ops.export_scene.gltf(
        filepath=path, use_selection=True, export_attributes=True, export_yup=True, export_skins=False, export_animations=False
    )
    mesh = copy.data
    bpy.data.objects.remove(copy)
    bpy.data.meshes.remove(mesh)


def _import(path, thing):
    """A new object with the transform and the materials of `thing` and the mesh of the file."""
    before = set(bpy.data.objects)
    bpy.ops.import_scene.gltf(filepath=path, merge_vertices=True)
    added = [one for one in bpy.data.objects if one not in before]
    result = next(one for one in added if one.type == "MESH")
    for one in added:
        if one is not result:
            bpy.data.objects.remove(one)
    result.parent = thing.parent
    result.matrix_parent_inverse = thing.matrix_parent_inverse.copy()
    # The importer rotates objects if the file says so, and the mesh was exported in its own space.
    result.matrix_basis = thing.matrix_basis.copy()
    result.name = f"{thing.name}_limber"
    _weld(result.data, flat=not any(face.use_smooth for face in thing.data.polygons))
    result.data.materials.clear()
    for material in thing.data.materials:
        result.data.materials.append(material)
    return result


def _weld(mesh, flat):
    """Merges vertices at the same position. In glTF flat faces share none, and the importer merges only those whose normals agree."""
    normals = [tuple(normal.vector) for normal in mesh.corner_normals]
    welded = bmesh.new()
    welded.from_mesh(mesh)
    bmesh.ops.remove_doubles(welded, verts=welded.verts, dist=0)
    welded.to_mesh(mesh)
    welded.free()
    if flat:
        mesh.shade_flat()
        mesh.attributes.remove(mesh.attributes["custom_normal"])
    elif len(mesh.loops) == len(normals):
        mesh.normals_split_custom_set(normals)


def _bring_groups(thing, result):
    attributes = {attribute.name.lower(): attribute for attribute in result.data.attributes}
    for group in thing.vertex_groups:
        attribute = attributes[f"{GROUP}{group.index}"]
        own = result.vertex_groups.new(name=group.name)
        for index, entry in enumerate(attribute.data):
            if entry.value > 1e-6:
                own.add([index], min(1.0, entry.value), "REPLACE")
    for group in thing.vertex_groups:
        attribute = next(one for one in result.data.attributes if one.name.lower() == f"{GROUP}{group.index}")
        result.data.attributes.remove(attribute)


def _cloth_options(thing, cloth, path):
    """Options with which limber finds the parameters for the result, from those of the original at its size in the scene."""
    values = {name: getattr(cloth.settings, property_) for name, property_ in CLOTH.items()}
    values |= {name: getattr(cloth.collision_settings, name) for name in CONTACTS}
    # Blender's numbers are floats: with more digits the largest that it accepts would be beyond limber's limits.
    words = ",".join(f"{name}={value:.7g}" for name, value in values.items())
    scale = sum(abs(axis) for axis in thing.matrix_world.to_scale()) / 3
    return ["--solver", "blender", "--engine", words, "--settings", path, "--unit", f"{scale:.9g}", *_pins(thing, cloth)]


def _pins(thing, cloth):
    """--pins with the vertices whose weight in the cloth's pin group is more than a half; nothing if there are none."""
    group = thing.vertex_groups.get(cloth.settings.vertex_group_mass)
    if group is None:
        return []
    weights = (entry.weight for vertex in thing.data.vertices for entry in vertex.groups if entry.group == group.index)
    # Blender writes names of attributes in capitals.
    return ["--pins", f"attribute:{GROUP.upper()}{group.index}"] if any(weight > 0.5 for weight in weights) else []


def _copy_properties(source, target):
    for property_ in source.bl_rna.properties:
        if not property_.is_readonly and property_.identifier != "rest_shape_key":
            setattr(target, property_.identifier, getattr(source, property_.identifier))


def _bring_cloth(cloth, result, settings):
    """Copies the modifier with all its values, and sets the parameters that were found."""
    modifier = result.modifiers.new(cloth.name, "CLOTH")
    _copy_properties(cloth.settings, modifier.settings)
    _copy_properties(cloth.settings.effector_weights, modifier.settings.effector_weights)
    _copy_properties(cloth.collision_settings, modifier.collision_settings)
    engine = settings["bodies"][0]["engine"]
    for name, property_ in CLOTH.items():
        if name in engine and name != "quality":
            setattr(modifier.settings, property_, engine[name])
    for name in CONTACTS:
        setattr(modifier.collision_settings, name, engine[name])
    # limber treats compression like tension, and bending by angles.
    modifier.settings.compression_stiffness = modifier.settings.tension_stiffness
    modifier.settings.bending_model = "ANGULAR"
    modifier.settings.quality = int(settings["bodies"][0]["substeps"])
    return modifier


FILES = {
    ".fbx": (lambda path: bpy.ops.import_scene.fbx(filepath=path), lambda path: bpy.ops.export_scene.fbx(filepath=path, use_visible=True)),
    ".abc": (
        lambda path: bpy.ops.wm.alembic_import(filepath=path, as_background_job=False),
        lambda path: bpy.ops.wm.alembic_export(filepath=path, as_background_job=False, visible_objects_only=True),
    ),
    **{
        ending: (
            lambda path: bpy.ops.wm.usd_import(filepath=path),
            lambda path: bpy.ops.wm.usd_export(filepath=path, visible_objects_only=True),
        )
        for ending in (".usd", ".usda", ".usdc", ".usdz")
    },
    ".vrm": (lambda path: bpy.ops.import_scene.vrm(filepath=path), lambda path: bpy.ops.export_scene.vrm(filepath=path)),
}


def optimize_file(source, target, options):
    """All meshes of a file, each in place of its original."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    FILES[pathlib.Path(source).suffix.lower()][0](source)
    for thing in [one for one in bpy.data.objects if one.type == "MESH"]:
        result = optimize(thing, options)
        name = thing.name
        bpy.data.objects.remove(thing)
        result.name = name
    FILES[pathlib.Path(target).suffix.lower()][1](target)


if __name__ == "__main__":
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]
    optimize_file(words[0], words[1], shlex.join(words[2:]))
