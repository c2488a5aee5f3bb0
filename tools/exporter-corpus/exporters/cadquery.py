"""CadQuery: an assembly of solids with colours and names."""
import importlib.metadata
import sys
from pathlib import Path

sys.path[:] = [p for p in sys.path if Path(p or ".").resolve() != Path(__file__).resolve().parent]
sys.path.append(str(Path(__file__).resolve().parent.parent))
import scene
import cadquery

folder = scene.begin("CadQuery", importlib.metadata.version("cadquery"))
whole = cadquery.Assembly(name=scene.ROOM)
box = cadquery.Workplane().box(1, 1, 1)
whole.add(box, name=scene.BOX, loc=cadquery.Location(cadquery.Vector(*scene.BOX_AT)),
          color=cadquery.Color(0.9, 0.5, 0.1))
whole.add(cadquery.Workplane().sphere(scene.RADIUS), name=scene.SPHERE, color=cadquery.Color(0.2, 0.6, 0.3))
whole.add(cadquery.Workplane().cylinder(scene.HEIGHT, scene.CYLINDER_RADIUS), name=scene.CYLINDER,
          loc=cadquery.Location(cadquery.Vector(*scene.CYLINDER_AT)), color=cadquery.Color(*scene.BLUE, scene.ALPHA))
for name in ("scene.gltf", "scene.glb", "scene.wrl", "scene.stl"):
    scene.attempt(name, whole.export if hasattr(whole, "export") else whole.save, str(folder / name))
for name in ("box.wrl", "box.stl"):
    scene.attempt(name, cadquery.exporters.export, box, str(folder / name))
print("lacks pictures, colours of vertices, cameras: solids have none")
