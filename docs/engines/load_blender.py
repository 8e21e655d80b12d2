"""Makes a cloth object in Blender 4.5 from a settings file of `limber --solver blender`.

In Blender's text editor, or with the bpy package:

    settings = json.load(open("flag.settings.json"))
    cloth = add_blender_cloth(settings)

Cloth counts time in frames: 31.6 of them, one over sqrt(0.001) s, are a second of real motion, whatever the scene says.
"""

import math

import bpy


def add_blender_cloth(settings, index=0):
    """The object of one body of the file, linked to the scene. Its vertices are those of the body's `mesh`, in metres, with the
    file's axes; the object turns their y up, to Blender's z, as importers do.

    Raises ValueError where the file is of another solver."""
    if settings["solver"] != "blender":
        raise ValueError(f"this settings file is for {settings['solver']}: write one with --solver blender")
    body = settings["bodies"][index]
    unit = body.get("unit", 1)
    triple = lambda list_, scale: [tuple(scale * x for x in list_[k : k + 3]) for k in range(0, len(list_), 3)]
    mesh = bpy.data.meshes.new(body.get("name", "cloth"))
    mesh.from_pydata(triple(body["mesh"]["positions"], unit), [], triple(body["mesh"]["triangles"], 1))
    cloth = bpy.data.objects.new(mesh.name, mesh)
    cloth.rotation_euler = (math.pi / 2, 0, 0)
    bpy.context.collection.objects.link(cloth)
    modifier = cloth.modifiers.new("Cloth", "CLOTH")
    set_material(modifier.settings, body)
    set_contacts(modifier.collision_settings, body)
    set_maps(cloth, modifier.settings, body.get("vertex"))
    if body["pins"]:
        group = cloth.vertex_groups.new(name="pins")
        group.add(list(body["pins"]), 1.0, "REPLACE")
        modifier.settings.vertex_group_mass = group.name
    return cloth


def set_material(settings, body):
    engine = body["engine"]
    settings.bending_model = "ANGULAR"
    # With compression as tension, springs resist both ways alike. `mass` is that of every vertex.
    settings.mass = engine["mass"]
    settings.tension_stiffness = settings.compression_stiffness = engine["tension"]
    settings.bending_stiffness = engine["bending"]
    settings.tension_damping = settings.compression_damping = engine.get("tension_damping", 0)
    settings.bending_damping = engine.get("bending_damping", 0)
    settings.air_damping = engine.get("air", 0)
    settings.quality = int(body["substeps"])


def set_contacts(contacts, body):
    contacts.distance_min = body.get("collisionThickness", contacts.distance_min)
    contacts.self_distance_min = body.get("selfCollisionDistance", contacts.self_distance_min)
    contacts.friction = body.get("friction", contacts.friction)


def set_maps(cloth, settings, maps):
    """Factors per vertex (--tune vertex): Blender goes from its stiffness to a maximum by the weights of a group."""
    if not maps:
        return
    least, most = min(maps["stretch"]), max(maps["stretch"])
    settings.vertex_group_structural_stiffness = weighted_group(cloth, "stretch", maps["stretch"])
    settings.tension_stiffness_max = settings.compression_stiffness_max = most * settings.tension_stiffness
    settings.tension_stiffness = settings.compression_stiffness = least * settings.tension_stiffness
    least, most = min(maps["bend"]), max(maps["bend"])
    settings.vertex_group_bending = weighted_group(cloth, "bend", maps["bend"])
    settings.bending_stiffness_max = most * settings.bending_stiffness
    settings.bending_stiffness = least * settings.bending_stiffness


def weighted_group(cloth, name, values):
    """The name of a new group with weights from 0 at the least value to 1 at the largest."""
    least, range_ = min(values), (max(values) - min(values)) or 1
    group = cloth.vertex_groups.new(name=name)
    for vertex, value in enumerate(values):
        group.add([vertex], (value - least) / range_, "REPLACE")
    return group.name
