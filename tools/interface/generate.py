#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes all that follows from the C headers, or with --check tells which of it is not what they say now.

usage: generate.py root [--check]
"""

import shutil
import sys
from pathlib import Path

import absent
import bad_input
import csharp
import header
import layout
import lua
import node
import python
import rust
import symbols

NOTICE = "Made by scripts/interface from the headers in include/abut, where each name is described. Do not edit."
WRITERS = (absent, layout, symbols, bad_input, csharp, lua, node, python, rust)


def made(root):
    interface = header.read(root)
    return {path: text for writer in WRITERS for path, text in writer.files(interface, NOTICE).items()}


def main(root, *options):
    if not shutil.which(header.COMPILER):
        print(f"skipped: {header.COMPILER} is missing; scripts/setup installs it")
        return 77
    is_old = False
    for path, text in made(root).items():
        place = Path(root, path)
        if place.is_file() and place.read_text(encoding="utf-8") == text:
            continue
        if "--check" in options:
            is_old = True
            print(f"{path} is not that of the headers: run scripts/interface")
        else:
            place.write_text(text, encoding="utf-8")
            print(path)
    return 1 if is_old else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
