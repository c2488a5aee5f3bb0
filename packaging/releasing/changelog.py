"""The CHANGELOG's section of a version, as notes of its release (Keep a Changelog 1.1.0)."""

import re

from . import Refusal

UNRELEASED = "unreleased"


def _heading(text, version):
    """The match of a version's heading, or None; group 1 is what stands behind the dash."""
    return re.search(rf"^## \[{re.escape(version)}\](?: +- +(\S+))? *$", text, re.MULTILINE)


def section(text, version):
    """What stands below a version's heading, without the definitions of links at the end of the file."""
    heading = _heading(text, version)
    if heading is None:
        raise Refusal(
            f"CHANGELOG.md has no section for it: write what is new below a heading '## [{version}] - {UNRELEASED}'"
        )
    rest = text[heading.end() :]
    following = re.search(r"^## ", rest, re.MULTILINE)
    body = rest[: following.start()] if following else rest
    body = re.sub(r"^\[[^\]]+\]: \S+ *$\n?", "", body, flags=re.MULTILINE).strip("\n")
    if not re.search(r"^(?!#)\s*\S", body, re.MULTILINE):
        raise Refusal(f"the CHANGELOG's section for {version} says nothing: write what is new")
    return body + "\n"


def dated(text, version, day):
    """The text with the day in the version's heading, where none stands yet."""
    heading = _heading(text, version)
    if heading.group(1) not in (None, UNRELEASED):
        return text
    return f"{text[: heading.start()]}## [{version}] - {day}{text[heading.end() :]}"


def day_of(text, version):
    """The day in the version's heading, or None."""
    day = _heading(text, version).group(1)
    return None if day == UNRELEASED else day


def absolute(notes, base):
    """The notes with links into the repository made whole, since they are read away from it."""
    return re.sub(r"\]\((?![a-z]+:|#|/)([^)\s]+)\)", rf"]({base}/\1)", notes)
