"""The packages of a release: which there are, what making them takes, and that two builds make the same bytes."""

import importlib.util
import os
import re
import shutil

from . import Refusal, files
from .commands import HOME, run, say

# What packaging/package makes for each platform on any Linux.
TYPES = {
    "linux-x64": ("deb", "rpm", "tar"),
    "linux-arm64": ("deb", "rpm", "tar"),
    "windows-x64": ("nsis", "zip"),
    "macos-x64": ("app",),
    "macos-arm64": ("app",),
}
_MINGW = (
    ("x86_64-w64-mingw32-gcc", "gcc-mingw-w64-x86-64"),
    ("x86_64-w64-mingw32-windres", "binutils-mingw-w64-x86-64"),
)
# The programs that each type takes, with the package of Debian that has them.
_PROGRAMS = {
    "deb": (("dpkg-deb", "dpkg"), ("readelf", "binutils")),
    "rpm": (("rpmbuild", "rpm"), ("readelf", "binutils")),
    "tar": (),
    "nsis": (("makensis", "nsis"), *_MINGW),
    "zip": (*_MINGW, ("zip", "zip")),
    "app": (("zip", "zip"),),
}
_CLASSES = "target/classes-pinned.list"
_RUNTIMES = "packaging/runtimes.tsv"
# It names the libraries that a package for Debian asks for; which package of Debian has one, it finds out on this
# system, so they must be here.
_LINUX = "packaging/parts/linux"


def chosen(text):
    """The platforms of a list with commas; all of them by default, and none for 'none'."""
    names = list(TYPES) if text is None else [name for name in text.split(",") if name and name != "none"]
    for name in names:
        if name not in TYPES:
            raise Refusal(f"there are no packages for '{name}': --packages takes none, or some of {','.join(TYPES)}")
    return names


def check(platforms):
    """Refuses, before anything is built, to begin what cannot be ended on this machine."""
    missing = {}
    for platform in platforms:
        for kind in TYPES[platform]:
            for program, package in _PROGRAMS[kind]:
                if not shutil.which(program):
                    missing.setdefault(program, (package, []))[1].append(f"{platform} {kind}")
    if platforms and not (shutil.which("pip3") or importlib.util.find_spec("pip")) and _unfetched(platforms):
        missing["pip"] = ("python3-pip", [f"the Java of {', '.join(_unfetched(platforms))}"])
    debs = [f"{platform} deb" for platform in platforms if "deb" in TYPES[platform]]
    for library in _unknown_libraries() if debs else ():
        # As Debian names packages of libraries: libX11.so.6 is in libx11-6, libGL.so.1 in libgl1.
        name, number = library.lower().split(".so.")
        missing[library] = (f"{name}-{number}" if name[-1].isdigit() else name + number, debs)
    if missing:
        together = {}
        for name, (_, uses) in missing.items():
            together.setdefault(", ".join(uses), []).append(name)
        lacks = "; ".join(f"{', '.join(names)} for {uses}" for uses, names in together.items())
        install = " ".join(sorted({package for package, _ in missing.values()}))
        raise Refusal(f"packages need what is not installed: {lacks}: install Debian's {install}, or leave some out by --packages")


def make(platforms, one, other):
    """Makes packages in both places of two builds, refuses what has other bytes in the second, and returns the first's
    folder of them."""
    environment = os.environ | {"RUNTIMES": str(_folder())}
    for place in (one, other):
        for platform in platforms:
            say(f"making packages in {place.relative_to(HOME)} for {platform}: {', '.join(TYPES[platform])}")
            run("packaging/package", "--for", platform, *TYPES[platform], cwd=place, env=environment)
        # Java loads not quite the same classes twice: which is data that both builds share.
        if place is one and (one / _CLASSES).exists():
            shutil.copyfile(one / _CLASSES, other / _CLASSES)
    made = one / "target" / "packages"
    for path in sorted(made.iterdir()):
        difference = files.difference(path, other / "target" / "packages" / path.name)
        if difference:
            raise Refusal(f"two builds differ, so there is no release: {difference}")
    return made


def packers(platforms):
    """What has packed, a line for each program, since another version packs to other bytes."""
    programs = {program for platform in platforms for kind in TYPES[platform] for program, _ in _PROGRAMS[kind]}
    said = [(program, run(program, "-VERSION" if program == "makensis" else "--version")) for program in sorted(programs)]
    # zip says it in the second line.
    return [f"{program}: {text.splitlines()[1 if program == 'zip' else 0].strip()}" for program, text in said if text]


def _folder():
    """Where the pinned archives of Java are kept between releases."""
    return (HOME / os.environ.get("RUNTIMES", "target/runtimes")).absolute()


def _unknown_libraries():
    """Those named libraries of packages for Debian that this system does not have."""
    named = set(re.findall(r"\blib\w+\.so\.\d+", (HOME / _LINUX).read_text(encoding="utf-8")))
    ldconfig = shutil.which("ldconfig", path=os.environ.get("PATH", "") + ":/sbin")
    known = set(re.findall(r"^\t(\S+) \(", run(ldconfig, "-p"), re.MULTILINE)) if ldconfig else set()
    return sorted(named - known)


def _unfetched(platforms):
    rows = [line.split("\t") for line in (HOME / _RUNTIMES).read_text(encoding="utf-8").splitlines()[1:]]
    return [platform for platform, archive, _ in rows if platform in platforms and not (_folder() / archive).exists()]
