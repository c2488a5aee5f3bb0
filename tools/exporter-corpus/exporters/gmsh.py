"""Gmsh: a mesh of solids, in the formats of surfaces that it writes."""
import sys
from pathlib import Path

sys.path[:] = [p for p in sys.path if Path(p or ".").resolve() != Path(__file__).resolve().parent]
sys.path.append(str(Path(__file__).resolve().parent.parent))
import scene
import gmsh

folder = scene.begin("Gmsh", gmsh.GMSH_API_VERSION)
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.option.setNumber("Mesh.MeshSizeMax", 0.2)
model = gmsh.model.occ
model.addBox(-2, -0.5, -0.5, 1, 1, 1)
model.addSphere(*scene.SPHERE_AT, scene.RADIUS)
model.addCylinder(1.5, -0.5, 0, 0, 1, 0, scene.CYLINDER_RADIUS)
model.synchronize()
for number, name in enumerate((scene.BOX, scene.SPHERE, scene.CYLINDER), 1):
    faces = [tag for _, tag in gmsh.model.getBoundary([(3, number)], oriented=False)]
    gmsh.model.addPhysicalGroup(2, faces, name=name)
gmsh.model.mesh.generate(2)
for ending in ("x3d", "wrl", "obj", "stl", "ply2", "ply"):
    scene.attempt(ending, gmsh.write, str(folder / ("scene." + ending)))
print("lacks pictures, colours, cameras: Gmsh writes surfaces only")
