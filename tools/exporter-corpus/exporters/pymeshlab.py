"""MeshLab, by PyMeshLab: a sphere with colours and a box with a picture, in all formats."""
import sys
from pathlib import Path

sys.path[:] = [p for p in sys.path if Path(p or ".").resolve() != Path(__file__).resolve().parent]
sys.path.append(str(Path(__file__).resolve().parent.parent))
import importlib.metadata

import numpy
import scene
import pymeshlab

folder = scene.begin("MeshLab", importlib.metadata.version("pymeshlab"))
FORMATS = ("x3d", "wrl", "obj", "ply", "stl", "dae", "gltf", "glb")
points, colours, triangles = scene.sphere()
colours = numpy.c_[numpy.array(colours), numpy.ones(len(colours))]
meshes = pymeshlab.MeshSet()
meshes.add_mesh(pymeshlab.Mesh(vertex_matrix=numpy.array(points), face_matrix=numpy.array(triangles),
                               v_color_matrix=colours), scene.SPHERE)
for ending in FORMATS:
    scene.attempt(ending, meshes.save_current_mesh, str(folder / ("sphere." + ending)))
points, coordinates, triangles = scene.box()
obj = folder / "box-source.obj"
scene.picture(folder)
(folder / "box-source.mtl").write_text("newmtl picture\nKd 1 1 1\nmap_Kd checker.png\n")
obj.write_text("mtllib box-source.mtl\nusemtl picture\n" + "".join("v %g %g %g\n" % p for p in points)
               + "".join("vt %g %g\n" % c for c in coordinates)
               + "".join("f %s\n" % " ".join("%d/%d" % (i + 1, i + 1) for i in t) for t in triangles))
meshes = pymeshlab.MeshSet()
meshes.load_new_mesh(str(obj))
obj.unlink()
for ending in FORMATS:
    scene.attempt("box." + ending, meshes.save_current_mesh, str(folder / ("box." + ending)))
print("lacks names, transparency, cameras: a mesh is one file")
