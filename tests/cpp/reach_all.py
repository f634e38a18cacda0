# SPDX-License-Identifier: Apache-2.0
"""Checks that the headers for C++ reach every function of the C headers.

usage: reach_all.py ROOT

A function is reached when its name stands in the code of the header for C++ that stands on its C header, or below
include/abut/cpp. Whoever adds a function to a C header adds a method there; the list of what is missing says which.
"""

import pathlib
import re
import sys

PROTOTYPE = re.compile(r"\bABUT_API\b[^;{}()]*?\b(abut_\w+)\s*\(")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def code_of(path):
    return COMMENT.sub(" ", path.read_text(encoding="utf-8"))


def main(root):
    include = root / "include" / "abut"
    rooms = {"abut.h": sorted((include / "cpp").glob("*.hpp")), "picking.h": [include / "picking.hpp"]}
    missing, count = [], 0
    for header, sources in rooms.items():
        declared = PROTOTYPE.findall(code_of(include / header))
        reached = set(re.findall(r"\babut_\w+", "\n".join(map(code_of, sources))))
        count += len(declared)
        missing += [f"{header} declares {name}; no header of {sources[0].parent.name} calls it" for name in declared if name not in reached]
    print(*missing, f"{count} functions, {len(missing)} not reached", sep="\n")
    return 1 if missing or not count else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
