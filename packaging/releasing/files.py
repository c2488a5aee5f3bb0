"""The files of a release: their sums, and what differs between two builds."""

import hashlib
import zipfile


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def sums(folder, paths):
    """SHA256SUMS of files in a folder, as `sha256sum --check` reads it."""
    lines = sorted((path.relative_to(folder).as_posix(), sha256(path)) for path in paths)
    return "".join(f"{digest}  {name}\n" for name, digest in lines)


def difference(one, other):
    """Nothing if two files have the same bytes; else where they differ, in a few words."""
    if one.read_bytes() == other.read_bytes():
        return None
    if one.suffix not in (".jar", ".zip"):
        return f"{one.name} differs"
    with zipfile.ZipFile(one) as first, zipfile.ZipFile(other) as second:
        names, others = first.namelist(), second.namelist()
        alone = sorted(set(names) ^ set(others))
        if alone:
            return f"{one.name}: only one has {_few(alone)}"
        unlike = [name for name in names if first.read(name) != second.read(name)]
        if unlike:
            return f"{one.name}: other content in {_few(unlike)}"
        if names != others:
            return f"{one.name}: the same files in another order"
        dated = [name for name in names if first.getinfo(name).date_time != second.getinfo(name).date_time]
        return f"{one.name}: other times of {_few(dated)}" if dated else f"{one.name}: otherwise packed"


def _few(names):
    return ", ".join(names[:5]) + (f" and {len(names) - 5} more" if len(names) > 5 else "")
