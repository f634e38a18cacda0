#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Copies the files of the tree that pages lead to and that are no pages themselves.

usage: copy_files.py FOLDER
"""

import shutil
import sys
from pathlib import Path

import names
import pages

ROOT = Path(__file__).resolve().parents[2]


def main(folder):
    site = names.read(ROOT)
    for page in site.titles:
        for path in sorted(pages.linked_files((ROOT / page).read_text(encoding="utf-8"), page, site)):
            source, copy = ROOT / path, folder / path
            copy.parent.mkdir(parents=True, exist_ok=True)
            if source.is_dir():
                shutil.copytree(source, copy, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
            else:
                shutil.copyfile(source, copy)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
