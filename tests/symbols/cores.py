# SPDX-License-Identifier: Apache-2.0
"""Searches are compiled for cores: none of their functions has a shape among its types that has the core of another
one. A sphere is a point with a radius, so a search that knows `Sphere` is there twice.

usage: cores.py nm library
"""

import re
import subprocess
import sys
from pathlib import Path

# As in mangled names: the length of a name comes before it.
ROOMS = ("apart", "convex", "cores", "fan", "points", "polytope", "warm")
SHAPES = ("5point5Point", "6sphere6Sphere", "9part_ball4Ball", "7segment7Segment", "7capsule7Capsule",
          "8triangle12FreeTriangle")


def main(nm, library):
    lines = subprocess.run([nm, "--defined-only", library], check=True, capture_output=True, text=True).stdout
    rooms = "|".join(f"{len(room)}{room}" for room in ROOMS)
    in_room = re.compile(rf"_ZN4abutW4abutW6narrowW(?:{rooms})W")
    searches = [name for name in (line.split()[-1] for line in lines.splitlines()) if in_room.match(name)]
    twice = [name for name in searches if any(shape in name for shape in SHAPES)]
    print(f"{Path(library).name}: {len(searches)} functions of searches")
    if not searches:
        print("no function of a search was found")
    for name in twice:
        print(f"known to a search: {name}")
    return 1 if twice or not searches else 0


sys.exit(main(*sys.argv[1:]))
