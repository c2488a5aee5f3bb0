"""Python's ElementTree and minidom: X3D as scripts write it, with and without what is optional."""
import platform
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent))
import xml.etree.ElementTree as Xml
from xml.dom import minidom

import scene

folder = scene.begin("ElementTree", platform.python_version())
scene.picture(folder)
SCHEMA = "http://www.w3.org/2001/XMLSchema-instance"


def numbers(rows):
    return str([tuple(row) for row in rows]).translate({ord(c): None for c in "[]()"})


def build():
    Xml.register_namespace("xsd", SCHEMA)
    root = Xml.Element("X3D", {"version": "3.3", "profile": "Interchange", "{%s}noNamespaceSchemaLocation" % SCHEMA:
                               "http://www.web3d.org/specifications/x3d-3.3.xsd"})
    top = Xml.SubElement(root, "Scene")
    Xml.SubElement(top, "Viewpoint", position=" ".join(map(str, scene.CAMERA_AT)), description=scene.CAMERA)
    Xml.SubElement(top, "PointLight", location=" ".join(map(str, scene.LIGHT_AT)))
    room = Xml.SubElement(top, "Group", DEF=scene.ROOM)

    def part(name, at):
        place = Xml.SubElement(room, "Transform", DEF=name.replace(" ", "_"), translation=" ".join(map(str, at)))
        shape = Xml.SubElement(place, "Shape")
        return shape, Xml.SubElement(shape, "Appearance")

    shape, look = part(scene.BOX, scene.BOX_AT)
    Xml.SubElement(look, "Material")
    Xml.SubElement(look, "ImageTexture", url="checker.png")
    Xml.SubElement(shape, "Box", size="1 1 1")
    shape, look = part(scene.SPHERE, scene.SPHERE_AT)
    points, colours, triangles = scene.sphere()
    mesh = Xml.SubElement(shape, "IndexedFaceSet", coordIndex=numbers([(*t, -1) for t in triangles]))
    Xml.SubElement(mesh, "Coordinate", point=numbers(points))
    Xml.SubElement(mesh, "Color", color=numbers(colours))
    shape, look = part(scene.CYLINDER, scene.CYLINDER_AT)
    Xml.SubElement(look, "Material", diffuseColor=" ".join(map(str, scene.BLUE)), transparency=str(1 - scene.ALPHA))
    Xml.SubElement(shape, "Cylinder", radius=str(scene.CYLINDER_RADIUS), height=str(scene.HEIGHT))
    return root


tree = Xml.ElementTree(build())
tree.write(folder / "plain.x3d")  # US-ASCII with references to characters, without a declaration
tree.write(folder / "utf-8.x3d", encoding="utf-8", xml_declaration=True)
tree.write(folder / "utf-16.x3d", encoding="utf-16")
latin = build()
for element in latin.iter():
    element.attrib.pop("DEF", None)
Xml.ElementTree(latin).write(folder / "latin-1.x3d", encoding="iso-8859-1")
(folder / "minidom.x3d").write_text(
    minidom.parseString(Xml.tostring(tree.getroot())).toprettyxml(indent="\t"), encoding="utf-8")
spaced = build()
spaced.set("xmlns", "http://www.web3d.org/specifications/x3d-namespace")
Xml.ElementTree(spaced).write(folder / "namespace.x3d", encoding="utf-8-sig")
