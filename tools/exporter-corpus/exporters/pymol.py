"""PyMOL: a small molecule as sticks and as spheres."""
import sys
from pathlib import Path

sys.path[:] = [p for p in sys.path if Path(p or ".").resolve() != Path(__file__).resolve().parent]
sys.path.append(str(Path(__file__).resolve().parent.parent))
import scene
import pymol

folder = scene.begin("PyMOL", pymol.cmd.get_version()[0] if hasattr(pymol, "cmd") else "")
pymol.finish_launching(["pymol", "-cqk"])
pymol.cmd.fragment("ala")
pymol.cmd.show_as("sticks")
pymol.cmd.show("spheres", "elem N+O")
pymol.cmd.set("sphere_scale", 0.4)
for ending in ("wrl", "dae", "obj", "stl", "gltf"):
    scene.attempt(ending, pymol.cmd.save, str(folder / ("sticks." + ending)))
pymol.cmd.show_as("surface")
for ending in ("wrl", "dae", "obj", "stl"):
    scene.attempt("surface." + ending, pymol.cmd.save, str(folder / ("surface." + ending)))
print("lacks names, pictures: a molecule has none")
