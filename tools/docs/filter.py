#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints what Doxygen reads in place of a header or a page.

usage: filter.py FILE
"""

import sys
from pathlib import Path

import headers
import names
import pages

ROOT = Path(__file__).resolve().parents[2]


def main(file):
    path = Path(file).resolve().relative_to(ROOT)
    text = (ROOT / path).read_text(encoding="utf-8")
    site = names.read(ROOT)
    turned = headers.for_doxygen(text, path.stem, site) if path.suffix == ".h" else pages.for_doxygen(text, path.as_posix(), site)
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write(turned)


if __name__ == "__main__":
    main(sys.argv[1])
