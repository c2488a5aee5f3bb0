"""FreeCAD with its window: VRML and glTF of documents, with colours and transparency."""
import os
import sys

sys.path.append(os.environ["EXPORTER_CORPUS"])
sys.argv = [os.environ["EXPORTER_CORPUS_OUT"]]
import FreeCAD
import FreeCADGui
import Part
import scene

try:
    folder = scene.begin("FreeCAD window", ".".join(FreeCAD.Version()[:3]))
    document = FreeCAD.newDocument("room")
    M = 1000  # millimetres

    def solid(label, shape, at, colour, transparency=0):
        made = document.addObject("Part::Feature", "Solid")
        made.Label = label
        shape.translate(FreeCAD.Vector(*(M * a for a in at)))
        made.Shape = shape
        made.ViewObject.ShapeColor = colour
        made.ViewObject.Transparency = transparency
        return made

    solids = [
        solid(scene.BOX, Part.makeBox(M, M, M, FreeCAD.Vector(-M / 2, -M / 2, -M / 2)), scene.BOX_AT, (.9, .5, .1)),
        solid(scene.SPHERE, Part.makeSphere(M * scene.RADIUS), scene.SPHERE_AT, (.2, .6, .3)),
        solid(scene.CYLINDER, Part.makeCylinder(M * scene.CYLINDER_RADIUS, M * scene.HEIGHT), scene.CYLINDER_AT,
              scene.BLUE, 50)]
    document.recompute()
    FreeCADGui.updateGui()
    for ending in ("wrl", "x3d", "wrz", "x3dz"):
        scene.attempt(ending, FreeCADGui.export, solids, str(folder / ("scene." + ending)))

    def of_document(ending):
        import ImportGui
        ImportGui.export(solids, str(folder / ("scene." + ending)))

    for ending in ("gltf", "glb"):
        scene.attempt(ending, of_document, ending)

    def collada():
        import importDAE
        importDAE.export(solids, str(folder / "scene.dae"))

    scene.attempt("dae", collada)

    def wavefront():
        import importOBJ
        importOBJ.export(solids, str(folder / "scene.obj"))

    scene.attempt("obj", wavefront)
finally:
    sys.stdout.flush()
    os._exit(0)
