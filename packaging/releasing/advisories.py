"""Known vulnerabilities of what the jar holds, as OSV (https://osv.dev) knows them.

Asked by the SBOM's package URLs, and for native parts by the commits that LWJGL's jars name, of which a package
URL says nothing. OSV joins GitHub's advisories, which name Maven packages by their coordinates, with CVEs by commit.
OWASP dependency-check guesses products (CPE) from names, which finds things that are not there, and first loads the
whole National Vulnerability Database, some gigabytes, for which one needs a key.
"""

import datetime
import json
import os
import re
import urllib.error
import urllib.request
import zipfile

from . import Refusal

ACCEPTED = "packaging/advisories-accepted.txt"
# Another server that answers as OSV does, such as a mirror.
VARIABLE = "SELECTIVE_RENDERER_OSV"
SECONDS = 30
# The most that OSV takes at a time; the program has some forty.
MOST = 1000
# The program's modules, which are no third party's.
_OWN = "org.selectiverenderer"
_NATIVE = re.compile(r"META-INF/.*/([\w.-]+)\.git")
_LINE = re.compile(r"(\S+) +(\S+) +until (\d{4}-\d{2}-\d{2}): (\S.*)")


def queries(bom, jar):
    """What OSV is asked: a component's name to its query."""
    asked = {}
    for component in bom["components"]:
        if component["group"] != _OWN:
            name = f"{component['group']}:{component['name']}"
            url = component.get("purl") or f"pkg:maven/{component['group']}/{component['name']}@{component['version']}"
            # A classifier's jar has a URL of its own; advisories name the library.
            asked[name] = {"package": {"purl": url.split("?")[0]}}
    with zipfile.ZipFile(jar) as archive:
        for entry in archive.namelist():
            native = _NATIVE.fullmatch(entry)
            if native:
                commit = archive.read(entry).decode("ascii").strip()
                asked.setdefault(f"{native[1]}@{commit[:9]}", {"commit": commit})
    return asked


def found(asked):
    """The identifiers of advisories for each name that has any; names and queries as queries() gives them."""
    said = {}
    waiting = list(asked.items())
    while waiting:
        batch, waiting = waiting[:MOST], waiting[MOST:]
        answers = _ask([query for _, query in batch])
        if len(answers) != len(batch):
            raise Refusal(f"OSV has answered {len(answers)} of {len(batch)} questions about known vulnerabilities")
        for (name, query), answer in zip(batch, answers):
            said.setdefault(name, set()).update(each["id"] for each in answer.get("vulns", []))
            if answer.get("next_page_token"):
                waiting.append((name, query | {"page_token": answer["next_page_token"]}))
    return {name: sorted(ids) for name, ids in said.items() if ids}


def _ask(questions):
    address = os.environ.get(VARIABLE) or "https://api.osv.dev"
    request = urllib.request.Request(
        f"{address}/v1/querybatch", json.dumps({"queries": questions}).encode("utf-8"), {"Content-Type": "application/json"}
    )
    try:
        with urllib.request.urlopen(request, timeout=SECONDS) as answer:
            return json.load(answer)["results"]
    except (OSError, ValueError, KeyError, TypeError) as fault:
        raise Refusal(
            f"OSV could not be asked for known vulnerabilities ({address}: {fault}): try again with a network, "
            "or give --without-advisories and say so in the notes"
        ) from None


def accepted(text):
    """The accepted ones of a file's text: (component, identifier) to the day until which, and the reason."""
    known = {}
    for number, line in enumerate(text.splitlines(), 1):
        if line.strip() and not line.startswith("#"):
            parts = _LINE.fullmatch(line.strip())
            try:
                day = datetime.date.fromisoformat(parts[3])
            except (TypeError, ValueError):
                raise Refusal(f"{ACCEPTED}:{number}: a line is 'COMPONENT ID until YYYY-MM-DD: reason'") from None
            known[parts[1], parts[2]] = (day, parts[4])
    return known


def faults(advisories, known, today):
    """What keeps a release from being made, a line each."""
    lines = []
    for name, ids in sorted(advisories.items()):
        for each in ids:
            component = name.split("@")[0]
            day, reason = known.get((component, each), (None, None))
            where = f"{name}: {each} (https://osv.dev/{each})"
            if day is None:
                lines.append(where)
            elif day < today:
                lines.append(f"{where}, accepted until {day} because: {reason}")
    return lines


def unaccepted(asked, home):
    """As faults(), of what OSV says now and what the project's file accepts."""
    file = home / ACCEPTED
    known = accepted(file.read_text(encoding="utf-8") if file.exists() else "")
    return faults(found(asked), known, datetime.date.today())


def check(bom, jar, home):
    """Refuses what has advisories that nobody has accepted."""
    lines = unaccepted(queries(bom, jar), home)
    if lines:
        raise Refusal(
            "what the jar holds has known vulnerabilities; take versions without them, or accept each "
            f"with a reason in {ACCEPTED}:\n" + "\n".join(lines)
        )
