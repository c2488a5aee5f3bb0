"""The scene that every exporter writes, as far as it can: numbers, names and a picture.

A box with a picture on it, a sphere with colours at its vertices, a cylinder that is half transparent,
side by side on the x axis, in metres, with y up; names are Greek, German, Chinese and Russian.
An exporter is a program beside this one. It is called with a folder to write into, and prints

    exporter NAME VERSION      once, before it writes
    lacks WHAT                 for each thing of the scene, or each format, that it leaves out
"""
import math
import struct
import sys
import zlib
from pathlib import Path

ROOM, BOX, SPHERE, CYLINDER = "Δωμάτιο", "Kiste mit Ä", "球", "Цилиндр"
CAMERA, LIGHT = "Caméra", "Lampe"
BOX_AT, SPHERE_AT, CYLINDER_AT = (-1.5, 0, 0), (0, 0, 0), (1.5, 0, 0)
BLUE = (0.1, 0.3, 0.9)
ALPHA = 0.5
RADIUS, CYLINDER_RADIUS, HEIGHT = 0.5, 0.4, 1.0
CAMERA_AT, LIGHT_AT = (0, 0, 5), (2, 4, 3)


def begin(name, version):
    """Tells which exporter this is, and returns the folder to write into."""
    print("exporter", name, version, flush=True)
    folder = Path(sys.argv[-1])
    folder.mkdir(parents=True, exist_ok=True)
    return folder


def attempt(what, function, *arguments, **named):
    """Calls what may fail, and tells what is lacking if it does."""
    try:
        return function(*arguments, **named)
    except Exception as e:  # whatever an exporter throws, the others go on
        print("lacks", what + ":", " ".join(str(e).split())[:200] or type(e).__name__, flush=True)
        return None


def picture(folder, name="checker.png", size=32):
    """Writes a picture of 4 by 4 squares, orange and green, and returns its path."""
    rows = b""
    for y in range(size):
        rows += b"\0" + b"".join(
            bytes((230, 130, 30) if (x * 4 // size + y * 4 // size) % 2 else (40, 150, 60)) for x in range(size))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    path = Path(folder) / name
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", size, size, 8, 2, 0, 0, 0))
                     + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
    return path


def box(at=(0, 0, 0), half=0.5):
    """Returns points (24), texture coordinates and triangles of the box, counter-clockwise from outside."""
    points, coordinates, triangles = [], [], []
    for axis in range(3):
        for sign in (-1, 1):
            first = len(points)
            for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                point = [0.0] * 3
                point[axis] = sign * half
                point[(axis + 1) % 3] = u * half * sign
                point[(axis + 2) % 3] = v * half
                points.append(tuple(p + a for p, a in zip(point, at)))
                coordinates.append(((u + 1) / 2, (v + 1) / 2))
            triangles += [(first, first + 1, first + 2), (first, first + 2, first + 3)]
    return points, coordinates, triangles


def sphere(at=(0, 0, 0), rings=12, sectors=24):
    """Returns points, colours (red, green, blue of 0 to 1) and triangles of the sphere."""
    points, colours, triangles = [], [], []
    for i in range(rings + 1):
        polar = math.pi * i / rings
        for j in range(sectors):
            around = 2 * math.pi * j / sectors
            unit = (math.sin(polar) * math.cos(around), math.cos(polar), -math.sin(polar) * math.sin(around))
            points.append(tuple(RADIUS * u + a for u, a in zip(unit, at)))
            colours.append(tuple((u + 1) / 2 for u in unit))
    for i in range(rings):
        for j in range(sectors):
            a, b = i * sectors + j, i * sectors + (j + 1) % sectors
            if i > 0:
                triangles.append((a, b + sectors, b))
            if i < rings - 1:
                triangles.append((a, a + sectors, b + sectors))
    return points, colours, triangles


def cylinder(at=(0, 0, 0), sectors=24):
    """Returns points and triangles of the cylinder, which stands along y."""
    points, triangles = [], []
    for y in (-HEIGHT / 2, HEIGHT / 2):
        points.append((at[0], y + at[1], at[2]))
        for j in range(sectors):
            around = 2 * math.pi * j / sectors
            points.append((CYLINDER_RADIUS * math.cos(around) + at[0], y + at[1],
                           -CYLINDER_RADIUS * math.sin(around) + at[2]))
    top = sectors + 1
    for j in range(sectors):
        a, b = 1 + j, 1 + (j + 1) % sectors
        triangles += [(0, b, a), (top, top + a, top + b), (a, b, top + b), (a, top + b, top + a)]
    return points, triangles
