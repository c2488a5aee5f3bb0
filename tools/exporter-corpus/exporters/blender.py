"""Blender, the program or the Python module bpy: a scene with an animation and an armature.

The armature bends a bar in 24 frames, and the sphere moves.
"""
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent))
import bpy
import scene
from mathutils import Vector

folder = scene.begin("Blender", bpy.app.version_string)
bpy.ops.wm.read_factory_settings(use_empty=True)
top = bpy.context.scene
top.frame_end = 24


def up(point):
    """Blender's z is up."""
    return point[0], -point[2], point[1]


def add(name, data, at=(0, 0, 0), parent=None):
    made = bpy.data.objects.new(name, data)
    made.location = up(at)
    made.parent = parent
    top.collection.objects.link(made)
    return made


def mesh(name, points, triangles):
    made = bpy.data.meshes.new(name)
    made.from_pydata([up(point) for point in points], [], triangles)
    return made


def material(name, colour, alpha=1.0, picture=None):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    made.diffuse_color = (*colour, alpha)
    surface = made.node_tree.nodes["Principled BSDF"]
    surface.inputs["Base Color"].default_value = (*colour, 1)
    surface.inputs["Alpha"].default_value = alpha
    if alpha < 1:
        made.blend_method = "BLEND"
    if picture:
        node = made.node_tree.nodes.new("ShaderNodeTexImage")
        node.image = bpy.data.images.load(str(picture))
        made.node_tree.links.new(surface.inputs["Base Color"], node.outputs["Color"])
    return made


room = add(scene.ROOM, None)
points, coordinates, triangles = scene.box()
data = mesh(scene.BOX, points, triangles)
layer = data.uv_layers.new(name="UVMap")
for loop in data.loops:
    layer.data[loop.index].uv = coordinates[loop.vertex_index]
data.materials.append(material("Bild", (1, 1, 1), picture=scene.picture(folder)))
add(scene.BOX, data, scene.BOX_AT, room)
points, colours, triangles = scene.sphere()
data = mesh(scene.SPHERE, points, triangles)
corners = data.color_attributes.new(name="Col", type="BYTE_COLOR", domain="CORNER")
for loop in data.loops:
    corners.data[loop.index].color = (*colours[loop.vertex_index], 1)
data.materials.append(material("Farben", (1, 1, 1)))
ball = add(scene.SPHERE, data, scene.SPHERE_AT, room)
for frame, height in ((1, 0), (12, 0.5), (24, 0)):
    ball.location = up((0, height, 0))
    ball.keyframe_insert("location", frame=frame)
data = mesh(scene.CYLINDER, *scene.cylinder())
data.materials.append(material("Glas", scene.BLUE, scene.ALPHA))
add(scene.CYLINDER, data, scene.CYLINDER_AT, room)

# A bar of four rings, bent by the second of two bones.
rings = [(x, y, z) for z in (0, 0.4, 0.8, 1.2) for x, y in ((-.1, -.1), (.1, -.1), (.1, .1), (-.1, .1))]
data = bpy.data.meshes.new("Bar")
data.from_pydata(rings, [], [(r * 4 + i, r * 4 + (i + 1) % 4, r * 4 + 4 + (i + 1) % 4, r * 4 + 4 + i)
                             for r in range(3) for i in range(4)] + [(3, 2, 1, 0), (12, 13, 14, 15)])
data.materials.append(material("Rot", (0.8, 0.1, 0.1)))
bar = add("Bar", data)
bones = bpy.data.armatures.new("Οστά")
armature = add("Οστά", bones, (0, -1.5, 0.8))
bpy.context.view_layer.objects.active = armature
bpy.ops.object.mode_set(mode="EDIT")
lower, upper = bones.edit_bones.new("unten"), bones.edit_bones.new("oben")
lower.head, lower.tail = Vector((0, 0, 0)), Vector((0, 0, 0.6))
upper.head, upper.tail = Vector((0, 0, 0.6)), Vector((0, 0, 1.2))
upper.parent = lower
bpy.ops.object.mode_set(mode="OBJECT")
bar.parent = armature
bar.modifiers.new("Armature", "ARMATURE").object = armature
for name, first, weights in (("unten", 0, (1, 1, 0, 0)), ("oben", 0, (0, 0, 1, 1))):
    group = bar.vertex_groups.new(name=name)
    for index in range(16):
        group.add([index], weights[index // 4], "REPLACE")
bone = armature.pose.bones["oben"]
bone.rotation_mode = "XYZ"
for frame, angle in ((1, 0), (12, 1.2), (24, 0)):
    bone.rotation_euler = (0, 0, 0) if not angle else (0, 0, angle)
    bone.rotation_euler = (0, angle, 0) if angle else (0, 0, 0)
    bone.keyframe_insert("rotation_euler", frame=frame)

camera = add(scene.CAMERA, bpy.data.cameras.new(scene.CAMERA), scene.CAMERA_AT)
camera.rotation_euler = (1.5708, 0, 0)
top.camera = camera
lamp = bpy.data.lights.new(scene.LIGHT, "POINT")
lamp.energy = 500
add(scene.LIGHT, lamp, scene.LIGHT_AT)
bpy.context.view_layer.update()


def export(name, operators, **options):
    """Calls the first of several operators that this Blender has."""
    for group, operator in operators:
        if operator in dir(getattr(bpy.ops, group)):
            getattr(getattr(bpy.ops, group), operator)(filepath=str(folder / name), **options)
            if not (folder / name).exists():
                raise RuntimeError("nothing was written")
            return
    raise RuntimeError("this Blender has no such exporter")


try:
    import addon_utils
    for addon in ("io_scene_x3d", "io_scene_gltf2", "io_scene_fbx", "io_scene_obj", "io_mesh_stl", "io_mesh_ply"):
        addon_utils.enable(addon)
except Exception:  # a module without these add-ons
    pass
scene.attempt("x3d", export, "scene.x3d", [("export_scene", "x3d")])
scene.attempt("glb", export, "scene.glb", [("export_scene", "gltf")], export_format="GLB",
              export_cameras=True, export_lights=True)
scene.attempt("gltf", export, "scene.gltf", [("export_scene", "gltf")], export_format="GLTF_SEPARATE",
              export_cameras=True, export_lights=True)
scene.attempt("fbx", export, "scene.fbx", [("export_scene", "fbx")], path_mode="COPY", embed_textures=False)
scene.attempt("obj", export, "scene.obj", [("wm", "obj_export")])
scene.attempt("obj of the older exporter", export, "older.obj", [("export_scene", "obj")])
scene.attempt("dae", export, "scene.dae", [("wm", "collada_export")])
scene.attempt("stl", export, "scene.stl", [("export_mesh", "stl"), ("wm", "stl_export")])
scene.attempt("ply", export, "scene.ply", [("export_mesh", "ply"), ("wm", "ply_export")])
