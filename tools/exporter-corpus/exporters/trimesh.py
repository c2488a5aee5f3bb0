"""trimesh: a scene with a graph of names, in all formats that it writes."""
import sys
from pathlib import Path

sys.path[:] = [p for p in sys.path if Path(p or ".").resolve() != Path(__file__).resolve().parent]
sys.path.append(str(Path(__file__).resolve().parent.parent))
import numpy
import scene
import trimesh
from PIL import Image

folder = scene.begin("trimesh", trimesh.__version__)
points, coordinates, triangles = scene.box()
box = trimesh.Trimesh(points, triangles, process=False, visual=trimesh.visual.TextureVisuals(
    uv=numpy.array(coordinates), image=Image.open(scene.picture(folder))))
points, colours, triangles = scene.sphere()
sphere = trimesh.Trimesh(points, triangles, process=False, vertex_colors=(numpy.array(colours) * 255).astype("uint8"))
cylinder = trimesh.Trimesh(*scene.cylinder(), process=False)
cylinder.visual = trimesh.visual.TextureVisuals(material=trimesh.visual.material.PBRMaterial(
    baseColorFactor=[*scene.BLUE, scene.ALPHA], alphaMode="BLEND", metallicFactor=0.0))
whole = trimesh.Scene(base_frame="world")
whole.graph.update(frame_from="world", frame_to=scene.ROOM, matrix=numpy.eye(4))
for name, mesh, at in ((scene.BOX, box, scene.BOX_AT), (scene.SPHERE, sphere, scene.SPHERE_AT),
                       (scene.CYLINDER, cylinder, scene.CYLINDER_AT)):
    whole.add_geometry(mesh, node_name=name, geom_name=name, parent_node_name=scene.ROOM,
                       transform=trimesh.transformations.translation_matrix(at))
whole.camera = trimesh.scene.Camera(name=scene.CAMERA, fov=(60, 45))
whole.camera_transform = trimesh.transformations.translation_matrix(scene.CAMERA_AT)
for name in ("scene.glb", "scene.obj", "scene.ply", "scene.stl", "scene.dae"):
    scene.attempt(name, whole.export, str(folder / name))
scene.attempt("scene.gltf", lambda: [(folder / name).write_bytes(data) for name, data in
              trimesh.exchange.gltf.export_gltf(whole).items()])
if (folder / "model.gltf").exists():
    (folder / "model.gltf").rename(folder / "scene.gltf")
scene.attempt("sphere.ply", sphere.export, str(folder / "sphere.ply"), encoding="ascii")
scene.attempt("sphere.stl", sphere.export, str(folder / "sphere.stl"), file_type="stl_ascii")
scene.attempt("box.obj", box.export, str(folder / "box.obj"))
scene.attempt("box.dae", box.export, str(folder / "box.dae"))
