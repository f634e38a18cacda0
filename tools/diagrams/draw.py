#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the pictures of the documents. The same sources give the same bytes.

usage: draw.py [--check]

--check writes nothing, and fails where a picture in docs/images is not what would be drawn.
"""

import importlib
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "docs" / "images"
PICTURES = ("camera", "elements", "events", "filters", "focus", "frames", "holes", "layers", "manifold", "measures", "pairs", "queries", "rectangle",
            "settling", "sides", "signs", "speed", "springs", "step", "tolerance")


def drawn():
    """(file, its text) of every picture."""
    for name in PICTURES:
        yield FOLDER / f"{name}.svg", importlib.import_module(name).draw().svg()


def stale(pictures):
    """The files that differ from what is drawn, and those that nobody draws."""
    texts = dict(pictures)
    differing = [path for path, text in texts.items() if not path.exists() or path.read_text(encoding="utf-8") != text]
    return differing + [path for path in sorted(FOLDER.glob("*.svg")) if path not in texts]


def main(arguments):
    if arguments not in ([], ["--check"]):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    if not arguments:
        for path, text in drawn():
            path.write_text(text, encoding="utf-8")
        return 0
    wrong = stale(drawn())
    for path in wrong:
        print(f"{path.relative_to(ROOT)} is not what scripts/draw draws; run it and commit the result")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
