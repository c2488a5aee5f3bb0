"""PyVista: a plotter's exporters, and meshes that are saved."""
import sys
from pathlib import Path

sys.path[:] = [p for p in sys.path if Path(p or ".").resolve() != Path(__file__).resolve().parent]
sys.path.append(str(Path(__file__).resolve().parent.parent))
import numpy
import scene
import pyvista

folder = scene.begin("PyVista", pyvista.__version__)


def mesh(points, triangles):
    return pyvista.PolyData(numpy.array(points, dtype=float),
                            numpy.array([(3, *triangle) for triangle in triangles]).ravel())


points, coordinates, triangles = scene.box(scene.BOX_AT)
box = mesh(points, triangles)
box.active_texture_coordinates = numpy.array(coordinates)
points, colours, triangles = scene.sphere(scene.SPHERE_AT)
sphere = mesh(points, triangles)
sphere["colours"] = (numpy.array(colours) * 255).astype("uint8")
cylinder = mesh(*scene.cylinder(scene.CYLINDER_AT))
plotter = pyvista.Plotter(off_screen=True)
plotter.add_mesh(box, texture=pyvista.read_texture(str(scene.picture(folder))), name=scene.BOX)
plotter.add_mesh(sphere, scalars="colours", rgb=True, name=scene.SPHERE)
plotter.add_mesh(cylinder, color=scene.BLUE, opacity=scene.ALPHA, name=scene.CYLINDER)
plotter.camera_position = [scene.CAMERA_AT, (0, 0, 0), (0, 1, 0)]
scene.attempt("wrl", plotter.export_vrml, str(folder / "scene.wrl"))
scene.attempt("gltf", plotter.export_gltf, str(folder / "scene.gltf"))
scene.attempt("obj", plotter.export_obj, str(folder / "scene.obj"))
# A height as the colour of a map, as most pictures of PyVista have it.
heights = pyvista.Plotter(off_screen=True)
sphere["height"] = sphere.points[:, 1]
heights.add_mesh(sphere, scalars="height", show_edges=True)
heights.add_mesh(pyvista.Line((-1, -1, 0), (1, -1, 0), resolution=8), color="red", line_width=4)
heights.add_points(numpy.array([(-1.0, 1, 0), (1.0, 1, 0)]), color="yellow", point_size=8)
scene.attempt("wrl of a colour map", heights.export_vrml, str(folder / "map.wrl"))
scene.attempt("gltf of a colour map", heights.export_gltf, str(folder / "map.gltf"))
for name in ("sphere.ply", "sphere.stl", "sphere.obj"):
    scene.attempt(name, sphere.save, str(folder / name), **({"texture": "colours"} if name.endswith("ply") else {}))
