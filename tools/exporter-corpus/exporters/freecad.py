"""FreeCAD without its window: solids as meshes, and as documents in glTF and COLLADA."""
import os
import sys
from pathlib import Path

sys.path.append(os.environ["EXPORTER_CORPUS"])
sys.argv = [os.environ["EXPORTER_CORPUS_OUT"]]
import FreeCAD
import Part
import Mesh
import scene

folder = scene.begin("FreeCAD", ".".join(FreeCAD.Version()[:3]))
document = FreeCAD.newDocument("room")
M = 1000  # millimetres


def solid(label, shape, at):
    made = document.addObject("Part::Feature", "Solid")
    made.Label = label
    shape.translate(FreeCAD.Vector(*(M * a for a in at)))
    made.Shape = shape
    return made


solids = [solid(scene.BOX, Part.makeBox(M, M, M, FreeCAD.Vector(-M / 2, -M / 2, -M / 2)), scene.BOX_AT),
          solid(scene.SPHERE, Part.makeSphere(M * scene.RADIUS), scene.SPHERE_AT),
          solid(scene.CYLINDER, Part.makeCylinder(M * scene.CYLINDER_RADIUS, M * scene.HEIGHT), scene.CYLINDER_AT)]
document.recompute()
for ending in ("x3d", "wrl", "obj", "stl", "ply", "x3dz", "wrz"):
    scene.attempt(ending, Mesh.export, solids, str(folder / ("scene." + ending)))


def of_document(ending):
    import Import
    Import.export(solids, str(folder / ("scene." + ending)))


for ending in ("gltf", "glb"):
    scene.attempt(ending, of_document, ending)


def collada():
    import importDAE
    importDAE.export(solids, str(folder / "scene.dae"))


scene.attempt("dae", collada)
print("lacks pictures, colours, cameras: without its window FreeCAD has none")
