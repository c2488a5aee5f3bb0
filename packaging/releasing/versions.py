"""Versions (Semantic Versioning 2.0.0) and the files that state the program's."""

import re

from . import Refusal

SNAPSHOT = "-SNAPSHOT"
_RELEASE = re.compile(r"(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)(?:-([0-9A-Za-z]+(?:\.[0-9A-Za-z]+)*))?")
# The version of a POM, or that of its parent, which stands first.
_IN_POM = re.compile(r"^((?:  )?  <version>)(.*)(</version>)$", re.MULTILINE)
_IN_CITATION = re.compile(r"^version: *(.*)$", re.MULTILINE)
_DAY = re.compile(r"^date-released: .*\n", re.MULTILINE)


def checked(version):
    """The version, if it can be one of a release."""
    if not _RELEASE.fullmatch(version) or version.endswith("SNAPSHOT"):
        raise Refusal(f"'{version}' is no version of a release: three numbers, such as 1.2.0, or 1.2.0-rc.1")
    return version


def order(version):
    """What versions are compared by: 1.2.0-rc.2 < 1.2.0-rc.10 < 1.2.0 < 1.10.0."""
    major, minor, patch, early = _RELEASE.fullmatch(version).groups()
    parts = [(0, int(part), "") if part.isdigit() else (1, 0, part) for part in early.split(".")] if early else []
    return (int(major), int(minor), int(patch), not early, parts)


def released(tags):
    """The versions among names of tags."""
    return [tag[1:] for tag in tags if tag.startswith("v") and _RELEASE.fullmatch(tag[1:])]


def following(version):
    """What builds say after a release: the next patch, not released yet."""
    major, minor, patch, early = _RELEASE.fullmatch(version).groups()
    return f"{major}.{minor}.{int(patch) + (0 if early else 1)}{SNAPSHOT}"


def of_pom(pom):
    return _IN_POM.search(pom).group(2)


def in_pom(pom, version):
    return _IN_POM.sub(rf"\g<1>{version}\3", pom, count=1)


def of_citation(citation):
    return _IN_CITATION.search(citation).group(1)


def in_citation(citation, version, day):
    """CITATION.cff with the version and its day; a file without a day gets one."""
    return _IN_CITATION.sub(f"version: {version}\ndate-released: {day}", _DAY.sub("", citation), count=1)
