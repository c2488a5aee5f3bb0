"""Whether the SBOM and META-INF/THIRD-PARTY.txt name the same libraries, versions and licences."""

import re

THIRD_PARTY = "META-INF/THIRD-PARTY.txt"
# What the POMs of libraries call licences, where they give no SPDX identifier that the SBOM's maker knows.
_SPDX = {
    "BSD-2 License": "BSD-2-Clause",
    "FastDoubleParser License": "MIT",
    "ISC License": "ISC",
    "MIT License": "MIT",
    "Mozilla Public License, Version 2.0": "MPL-2.0",
}
_ROW = re.compile(r"^([\w.-]+:[\w.-]+) +(\S+) +(\S+) ", re.MULTILINE)


def table(text):
    """The rows of THIRD-PARTY.txt: a library's name to its version and licence."""
    return {name: (version, licence) for name, version, licence in _ROW.findall(text)}


def missing_texts(text, names):
    """The licences' files that THIRD-PARTY.txt points to and the jar, whose files are given, does not have."""
    return sorted(set(re.findall(r"(?:META-INF|org)/[\w./-]*\w", text)) - set(names))


def faults(text, bom):
    """What the two say differently, a line each; bom is the SBOM as read from JSON."""
    rows = table(text)
    said = {}
    for component in bom["components"]:
        name = f"{component['group']}:{component['name']}"
        licences = {
            _SPDX.get(found, found)
            for choice in component.get("licenses", [])
            for found in [choice.get("expression") or choice["license"].get("id") or choice["license"]["name"]]
        }
        said.setdefault(name, []).append((component["version"], licences))
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
