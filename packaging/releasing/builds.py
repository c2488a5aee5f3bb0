"""Two builds of one commit, in places as unlike as two machines."""

import datetime
import os
import re
import shutil

from . import Refusal, files, packages
from .commands import HOME, asked, git, run, say

JARS = ("selective-renderer.jar", "x3d-sai.jar")
SBOM = "bom.json"
LIBRARIES = "selective-renderer-libraries-{}.zip"
# Scenes to begin with, which the packages leave out for their size.
EXAMPLES = "selective-renderer-examples-{}.zip"
EXAMPLE_FOLDERS = ("scenes", "inlineNodes", "docs/examples")
LIBRARIES_USED = "packaging/libraries/check"
# Nothing that differs between two machines may show in the bytes.
PLACES = (
    ("one", {"TZ": "UTC", "LC_ALL": "C.UTF-8"}, 0o022),
    ("another place", {"TZ": "Asia/Kathmandu", "LC_ALL": "C", "MAVEN_OPTS": "-Duser.language=tr -Duser.region=TR"}, 0o027),
)


def add(work, commit):
    """The first place's folder, with a commit's files."""
    folder = work / PLACES[0][0]
    git("worktree", "add", "--quiet", "--detach", str(folder), commit)
    return folder


def remove(work):
    """Takes away the places' folders."""
    if work.exists():
        for place, _, _ in PLACES:
            asked("worktree", "remove", "--force", str(work / place))
        shutil.rmtree(work, ignore_errors=True)
    asked("worktree", "prune")


def twice(work, commit, version):
    """Builds in both places, and refuses what has other bytes in the second; returns their folders."""
    one, other = (_build(work, commit, *place) for place in PLACES)
    for name in (*JARS, SBOM, LIBRARIES.format(version)):
        difference = files.difference(one / "target" / name, other / "target" / name)
        if difference:
            raise Refusal(f"two builds differ, so there is no release: {difference}")
    say("using the libraries as other projects do")
    run(LIBRARIES_USED, cwd=one)
    return one, other


def recipe(version, tag, commit, platforms=()):
    """How to make the same bytes again."""
    time = datetime.datetime.fromtimestamp(int(git("log", "-1", "--format=%ct", commit)), datetime.timezone.utc)
    maven = run("mvn", "-B", "--version", env=os.environ | {"MAVEN_ARGS": ""})
    maven = re.sub(r"\x1b\[[0-9;]*m", "", maven)  # Maven 3 writes bold letters wherever it runs.
    programs = [line for line in maven.splitlines() if line.startswith(("Apache Maven", "Java version"))]
    programs = [line.split(", runtime:")[0].split(" (")[0] for line in programs]
    return (
        f"selective-renderer {version}\n\nCommit {commit}\nof {time:%Y-%m-%d %H:%M:%S} UTC, built twice with the same bytes by\n"
        + "".join(f"  {line}\n" for line in programs)
        + f"\nWith the same Java one gets these bytes again:\n\n  git checkout {tag}\n"
        + "  mvn -Plibraries -DskipTests clean package\n"
        + "  sha256sum " + " ".join(f"target/{file}" for file in (*JARS, LIBRARIES.format(version))) + "\n"
        + (_packages(platforms) if platforms else "")
    )


def _packages(platforms):
    """How to make the packages again."""
    return (
        "\nPackages were made twice with the same bytes. They hold a list of the classes that a start loads, which is\n"
        "another one each time; with that of a package (app/classes.list of one for Linux) as target/classes-pinned.list,\n"
        "and with the same versions of the programs that pack, one gets their bytes again:\n\n"
        + "".join(f"  # {line}\n" for line in packages.packers(platforms))
        + "".join(f"  packaging/package --for {platform} {' '.join(packages.TYPES[platform])}\n" for platform in platforms)
    )


def _build(work, commit, place, environment, umask):
    folder = work / place
    if not folder.exists():
        git("worktree", "add", "--quiet", "--detach", str(folder), commit)
    say(f"building in {folder.relative_to(HOME)}")
    run(
        "mvn", "-q", "-B", "-ntp", "-Psbom,libraries", "-Dmaven.test.skip=true", "package",
        cwd=folder, env=os.environ | environment, umask=umask,
    )
    return folder
