"""Makes a cloth object in Blender 4.5 from a settings file of `limber --solver blender`.

In Blender's text editor, or with the bpy package:

    settings = json.load(open("flag.settings.json"))
    cloth = add_blender_cloth(settings["bodies"][0])
"""

import bpy


def add_blender_cloth(body):
    """The object, linked to the scene; its vertices are those of body["mesh"], in metres, with the file's axes."""
    unit, engine = body.get("unit", 1), body["engine"]
    triple = lambda list_, scale: [tuple(scale * x for x in list_[k : k + 3]) for k in range(0, len(list_), 3)]
    mesh = bpy.data.meshes.new(body.get("name", "cloth"))
    mesh.from_pydata(triple(body["mesh"]["positions"], unit), [], triple(body["mesh"]["triangles"], 1))
    cloth = bpy.data.objects.new(mesh.name, mesh)
    bpy.context.collection.objects.link(cloth)
    settings = cloth.modifiers.new("Cloth", "CLOTH").settings
    settings.bending_model = "ANGULAR"
    # With compression as tension, springs resist both ways alike. `mass` is that of every vertex.
    settings.mass = engine["mass"]
    settings.tension_stiffness = settings.compression_stiffness = engine["tension"]
    settings.bending_stiffness = engine["bending"]
    settings.tension_damping = settings.compression_damping = engine.get("tension_damping", 0)
    settings.bending_damping = engine.get("bending_damping", 0)
    settings.air_damping = engine.get("air", 0)
    settings.quality = int(body["substeps"])
    if body["pins"]:
        group = cloth.vertex_groups.new(name="pins")
        group.add(list(body["pins"]), 1.0, "REPLACE")
        settings.vertex_group_mass = group.name
    return cloth
