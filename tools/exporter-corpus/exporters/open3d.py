"""Open3D: meshes with vertex colours, and a cloud of points."""
import sys
from pathlib import Path

sys.path[:] = [p for p in sys.path if Path(p or ".").resolve() != Path(__file__).resolve().parent]
sys.path.append(str(Path(__file__).resolve().parent.parent))
import numpy
import scene
import open3d

folder = scene.begin("Open3D", open3d.__version__)


def mesh(points, triangles, colours=None):
    made = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(numpy.array(points, float)),
                                        open3d.utility.Vector3iVector(numpy.array(triangles)))
    if colours is not None:
        made.vertex_colors = open3d.utility.Vector3dVector(numpy.array(colours))
    made.compute_vertex_normals()
    return made


points, colours, triangles = scene.sphere(scene.SPHERE_AT)
sphere = mesh(points, triangles, colours)
points, triangles = scene.cylinder(scene.CYLINDER_AT)
whole = sphere + mesh(points, triangles, [scene.BLUE] * len(points))
for ending in ("glb", "gltf", "obj", "ply", "stl"):
    scene.attempt(ending, open3d.io.write_triangle_mesh, str(folder / ("scene." + ending)), whole)
scene.attempt("ply", open3d.io.write_triangle_mesh, str(folder / "ascii.ply"), whole, write_ascii=True)
points, coordinates, triangles = scene.box(scene.BOX_AT)
box = mesh(points, triangles)
box.triangle_uvs = open3d.utility.Vector2dVector(
    numpy.array([coordinates[index] for triangle in triangles for index in triangle]))
box.textures = [open3d.io.read_image(str(scene.picture(folder)))]
box.triangle_material_ids = open3d.utility.IntVector([0] * len(triangles))
for ending in ("glb", "gltf", "obj"):
    scene.attempt("box." + ending, open3d.io.write_triangle_mesh, str(folder / ("box." + ending)), box)
cloud = open3d.geometry.PointCloud(sphere.vertices)
cloud.colors = sphere.vertex_colors
scene.attempt("cloud.ply", open3d.io.write_point_cloud, str(folder / "cloud.ply"), cloud)
print("lacks names, hierarchy, transparency, cameras: meshes have none")
