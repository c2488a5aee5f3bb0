"""The Web3D Consortium's X3D package for Python (x3d.py): XML, ClassicVRML, VRML97 and JSON."""
import importlib.metadata
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent))
import scene
import x3d.x3d as x3d

folder = scene.begin("x3d.py", importlib.metadata.version("x3d"))
scene.picture(folder)


def flat(rows):
    return [number for row in rows for number in row]


def transform(name, at, shape):
    return x3d.Transform(DEF=name, translation=at, children=[shape])


points, colours, triangles = scene.sphere()
whole = x3d.X3D(profile="Immersive", version="4.0", head=x3d.head(children=[
    x3d.meta(name="title", content=scene.ROOM)]), Scene=x3d.Scene(children=[
        x3d.WorldInfo(title=scene.ROOM, info=["it's a test"]),
        x3d.Viewpoint(DEF="Camera", description=scene.CAMERA, position=scene.CAMERA_AT),
        x3d.PointLight(DEF="Lamp", location=scene.LIGHT_AT),
        x3d.Group(DEF="Room", children=[
            transform("Box", scene.BOX_AT, x3d.Shape(
                geometry=x3d.Box(size=(1, 1, 1)), appearance=x3d.Appearance(
                    material=x3d.Material(), texture=x3d.ImageTexture(url=["checker.png"])))),
            transform("Sphere", scene.SPHERE_AT, x3d.Shape(geometry=x3d.IndexedTriangleSet(
                index=flat(triangles), coord=x3d.Coordinate(point=points), color=x3d.Color(color=colours)),
                appearance=x3d.Appearance(material=x3d.Material()))),
            transform("Cylinder", scene.CYLINDER_AT, x3d.Shape(
                geometry=x3d.Cylinder(radius=scene.CYLINDER_RADIUS, height=scene.HEIGHT),
                appearance=x3d.Appearance(material=x3d.Material(
                    diffuseColor=scene.BLUE, transparency=1 - scene.ALPHA))))]),
        x3d.TimeSensor(DEF="Clock", loop=True, cycleInterval=4),
        x3d.OrientationInterpolator(DEF="Turn", key=[0, 0.5, 1],
                                    keyValue=[(0, 1, 0, 0), (0, 1, 0, 3.14), (0, 1, 0, 6.28)]),
        x3d.ROUTE(fromNode="Clock", fromField="fraction_changed", toNode="Turn", toField="set_fraction"),
        x3d.ROUTE(fromNode="Turn", fromField="value_changed", toNode="Sphere", toField="set_rotation")]))
for ending, method in (("x3d", "XML"), ("x3dv", "VRML"), ("wrl", "VRML97"), ("json", "JSON")):
    def write():
        (folder / ("scene." + ending)).write_text(getattr(whole, method)(), encoding="utf-8")
    scene.attempt(ending, write)
print("lacks names that are not ASCII: they are refused")
