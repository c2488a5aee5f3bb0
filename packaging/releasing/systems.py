"""What was tried on which system: the table of docs/install.md, which is written from packaging/systems.tsv."""

import re

from . import Refusal

PAGE = "docs/install.md"
_TABLE = re.compile(r"<!-- The table is written from packaging/systems\.tsv[^\n]*-->\n(.*?)<!-- End of the table -->", re.DOTALL)


def tried(page, version):
    """A section of the release's notes, with the names that the packages of a version have."""
    table = _TABLE.search(page)
    if not table:
        raise Refusal(f"{PAGE} has no table of the systems: write it by the test SystemsTableTest")
    return f"### What was tried on which system\n\n{table.group(1).strip().replace('VERSION', version)}\n"
