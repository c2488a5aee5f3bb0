"""Whether the SBOM and META-INF/THIRD-PARTY.txt name the same libraries, versions and licences."""

import re

THIRD_PARTY = "META-INF/THIRD-PARTY.txt"
# Whose POM says "BSD", which the SBOM's maker reads as a licence of four clauses; its text has three. And whose
# POM names none; its sources do.
_GROUPS = {"com.miglayout": "BSD-3-Clause", "com.googlecode.soundlibs": "LGPL-2.0-or-later"}
# The program's modules, which are no third party's.
_OWN = "org.selectiverenderer"
_ROW = re.compile(r"^([\w.-]+:[\w.-]+) +(\S+) +(\S+) ", re.MULTILINE)


def table(text):
    """The rows of THIRD-PARTY.txt: a library's name to its version and licence."""
    return {name: (version, licence) for name, version, licence in _ROW.findall(text)}


def missing_texts(text, names):
    """The licences' files that THIRD-PARTY.txt points to and the jar, whose files are given, does not have."""
    return sorted(set(re.findall(r"(?<![\w.])(?:META-INF|org)/[\w./-]*\w", text)) - set(names))


def identified(bom):
    """The SBOM, with the licences of _GROUPS in the place of what its maker has read."""
    for component in bom["components"]:
        if component["group"] in _GROUPS:
            component["licenses"] = [{"license": {"id": _GROUPS[component["group"]]}}]
    return bom


def faults(text, bom):
    """What the two say differently, a line each; bom is the SBOM as identified() gives it."""
    rows = table(text)
    said = {}
    for component in bom["components"]:
        if component["group"] == _OWN:
            continue
        licences = {
            choice.get("expression") or choice["license"].get("id") or choice["license"]["name"]
            for choice in component.get("licenses", [])
        }
        said.setdefault(f"{component['group']}:{component['name']}", []).append((component["version"], licences))
    found = [f"{name}: in the SBOM, but not in {THIRD_PARTY}" for name in sorted(said.keys() - rows.keys())]
    found += [f"{name}: in {THIRD_PARTY}, but not in the SBOM" for name in sorted(rows.keys() - said.keys())]
    for name in sorted(rows.keys() & said.keys()):
        version, licence = rows[name]
        for component_version, licences in said[name]:
            if component_version != version:
                found.append(f"{name}: version {component_version} in the SBOM, {version} in {THIRD_PARTY}")
            if licence not in licences:
                found.append(f"{name}: {sorted(licences)} in the SBOM, {licence} in {THIRD_PARTY}")
    return list(dict.fromkeys(found))
