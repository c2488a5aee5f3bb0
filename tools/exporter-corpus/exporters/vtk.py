"""VTK: its exporters of scenes, and its writers of surfaces."""
import sys
from pathlib import Path

sys.path[:] = [p for p in sys.path if Path(p or ".").resolve() != Path(__file__).resolve().parent]
sys.path.append(str(Path(__file__).resolve().parent.parent))
import scene
import vtk

folder = scene.begin("VTK", vtk.VTK_VERSION)


def surface(points, triangles, colours=None, coordinates=None):
    data, places, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    for point in points:
        places.InsertNextPoint(point)
    for triangle in triangles:
        cells.InsertNextCell(3, triangle)
    data.SetPoints(places)
    data.SetPolys(cells)
    if colours:
        bytes_ = vtk.vtkUnsignedCharArray()
        bytes_.SetNumberOfComponents(3)
        bytes_.SetName("Colors")
        for colour in colours:
            bytes_.InsertNextTuple([int(255 * c) for c in colour])
        data.GetPointData().SetScalars(bytes_)
    if coordinates:
        numbers = vtk.vtkFloatArray()
        numbers.SetNumberOfComponents(2)
        numbers.SetName("TCoords")
        for pair in coordinates:
            numbers.InsertNextTuple(pair)
        data.GetPointData().SetTCoords(numbers)
    return data


def actor(data, at):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    made = vtk.vtkActor()
    made.SetMapper(mapper)
    made.SetPosition(at)
    return made


points, coordinates, triangles = scene.box()
box = actor(surface(points, triangles, coordinates=coordinates), scene.BOX_AT)
reader = vtk.vtkPNGReader()
reader.SetFileName(str(scene.picture(folder)))
texture = vtk.vtkTexture()
texture.SetInputConnection(reader.GetOutputPort())
box.SetTexture(texture)
points, colours, triangles = scene.sphere()
ball = surface(points, triangles, colours)
sphere = actor(ball, scene.SPHERE_AT)
cylinder = actor(surface(*scene.cylinder()), scene.CYLINDER_AT)
cylinder.GetProperty().SetColor(scene.BLUE)
cylinder.GetProperty().SetOpacity(scene.ALPHA)
renderer = vtk.vtkRenderer()
for part in (box, sphere, cylinder):
    renderer.AddActor(part)
light = vtk.vtkLight()
light.SetPosition(scene.LIGHT_AT)
light.SetPositional(True)
renderer.AddLight(light)
window = vtk.vtkRenderWindow()
window.SetOffScreenRendering(True)
window.AddRenderer(renderer)
renderer.GetActiveCamera().SetPosition(scene.CAMERA_AT)
renderer.GetActiveCamera().SetFocalPoint(0, 0, 0)
renderer.ResetCameraClippingRange()
window.Render()


def export(exporter, name, **options):
    exporter.SetRenderWindow(window)
    if hasattr(exporter, "SetFilePrefix"):
        exporter.SetFilePrefix(str(folder / Path(name).stem))
    else:
        exporter.SetFileName(str(folder / name))
    for option, value in options.items():
        getattr(exporter, option)(value)
    exporter.Write()


scene.attempt("x3d", export, vtk.vtkX3DExporter(), "scene.x3d")
scene.attempt("wrl", export, vtk.vtkVRMLExporter(), "scene.wrl")
scene.attempt("gltf", export, vtk.vtkGLTFExporter(), "scene.gltf", SetInlineData=True, SetSaveNormal=True)
scene.attempt("glb", export, vtk.vtkGLTFExporter(), "scene.glb", SetInlineData=True, SetSaveNormal=True)
scene.attempt("obj", export, vtk.vtkOBJExporter(), "scene.obj")
for writer, name in ((vtk.vtkPLYWriter(), "sphere.ply"), (vtk.vtkSTLWriter(), "sphere.stl"),
                     (vtk.vtkOBJWriter(), "sphere.obj")):
    writer.SetInputData(ball)
    writer.SetFileName(str(folder / name))
    if name.endswith("ply"):
        writer.SetArrayName("Colors")
    if name.endswith("stl"):
        writer.SetFileTypeToBinary()
    scene.attempt(name, writer.Write)
print("lacks names: VTK has none")
