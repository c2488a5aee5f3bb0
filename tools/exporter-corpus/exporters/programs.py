"""Programs with a command line: Assimp, tovrmlx3d, osgconv, OpenSCAD, Jmol and Graphviz.

    programs.py NAME SOURCE OUT      SOURCE is a folder with scene.glb, scene.wrl and so on to convert
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent))
import scene

NAME, SOURCE = sys.argv[1], Path(sys.argv[2])


def run(*command, **named):
    done = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300,
                          text=True, errors="replace", **named)
    return done.stdout


def version(*command):
    found = re.search(r"\d+\.\d+[\d.]*", run(*command))
    return found.group() if found else "?"


def convert(*command, out):
    said = run(*command)
    if not out.exists() or out.stat().st_size == 0:
        raise RuntimeError(said[-200:] or "nothing was written")


def assimp():
    folder = scene.begin("Assimp", re.search(r"Version ([\d.]+)", run("assimp", "version")).group(1))
    for kind, ending in (("x3d", "x3d"), ("gltf2", "gltf"), ("glb2", "glb"), ("obj", "obj"), ("stl", "stl"),
                         ("stlb", "binary.stl"), ("ply", "ply"), ("plyb", "binary.ply"), ("collada", "dae"),
                         ("fbx", "fbx"), ("fbxa", "ascii.fbx")):
        out = folder / ("scene." + ending)
        scene.attempt(ending, convert, "assimp", "export", SOURCE / "scene.glb", out, "-f" + kind, out=out)


def tovrmlx3d():
    folder = scene.begin("tovrmlx3d", version("tovrmlx3d", "--version"))
    for source in ("../vtk/scene.wrl", "../x3d_psail/scene.x3d", "../bpy/scene.glb", "../trimesh/scene.stl"):
        if not (SOURCE / source).exists():
            continue
        for encoding, ending in (("xml", "x3d"), ("classic", "x3dv")):
            out = folder / (Path(source).name.replace(".", "-") + "." + ending)

            def write():
                out.write_bytes(subprocess.run(["tovrmlx3d", str(SOURCE / source), "--encoding=" + encoding],
                                               check=True, capture_output=True, timeout=300).stdout)
            scene.attempt(out.name, write)


def osgconv():
    folder = scene.begin("OpenSceneGraph", version("osgversion" if shutil.which("osgversion") else "osgconv", "--version"))
    for ending in ("obj", "stl", "ply", "dae"):
        out = folder / ("scene." + ending)
        scene.attempt(ending, convert, "osgconv", SOURCE / "scene.obj", out, out=out)


def openscad():
    folder = scene.begin("OpenSCAD", version("openscad", "--version"))
    source = folder / "scene.scad"
    source.write_text("$fn = 24; translate([-1.5, 0, 0]) color(\"orange\") cube(1, center = true);\nsphere(0.5);\n"
                      "translate([1.5, 0, 0]) color([0.1, 0.3, 0.9, 0.5]) cylinder(r = 0.4, h = 1, center = true);\n")
    for ending in ("stl", "wrl", "obj"):
        out = folder / ("scene." + ending)
        scene.attempt(ending, convert, "openscad", "-o", out, source, out=out)
    print("lacks names, colours, cameras: STL has none")


def jmol():
    folder = scene.begin("Jmol", version("dpkg-query", "-W", "-f", "${Version}", "jmol"))
    script = folder / "ethanol.spt"
    (folder / "ethanol.xyz").write_text(
        "9\nethanol\nC -0.748 -0.015 0.024\nC 0.558 0.420 -0.278\nO 1.293 -0.202 -1.301\nH -1.263 0.754 0.600\n"
        "H -1.293 -0.202 -0.902\nH -0.699 -0.934 0.609\nH 0.716 1.404 0.137\nH 1.146 -0.280 0.420\nH 2.118 0.190 -1.46\n")
    kinds = (("VRML", "wrl"), ("X3D", "x3d"), ("OBJ", "obj"), ("STL", "stl"))
    script.write_text('load "%s"; connect;\n' % (folder / "ethanol.xyz") + "".join(
        'write %s "%s";\n' % (kind, folder / ("ethanol." + ending)) for kind, ending in kinds))
    said = run("jmol", "-onis", script)
    for _, ending in kinds:
        if not (folder / ("ethanol." + ending)).exists():
            print("lacks", ending + ":", " ".join(said.split())[-150:])


def graphviz():
    folder = scene.begin("Graphviz", version("dot", "-V"))
    out = folder / "graph.wrl"
    scene.attempt("wrl", lambda: out.write_bytes(subprocess.run(
        ["dot", "-Tvrml"], input="digraph g { a [z=0, label=\"Tür\"]; b [z=10 style=filled fillcolor=orange]; a -> b; b -> c }".encode(),
        check=True, capture_output=True, cwd=folder).stdout))


if __name__ == "__main__":
    globals()[NAME]()
