# SPDX-License-Identifier: Apache-2.0
"""Tables of the documents, for pictures that show their figures."""

from pathlib import Path

DOCS = Path(__file__).resolve().parents[2] / "docs"


def _cells(line):
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def table_under(page, heading):
    """The rows of the first table under a heading of a page, the one with the names of the columns first."""
    lines = (DOCS / page).read_text(encoding="utf-8").split("\n")
    rows = []
    for line in lines[lines.index(heading) :]:
        if line.startswith("|"):
            rows.append(_cells(line))
        elif rows:
            break
    return rows[:1] + rows[2:]
