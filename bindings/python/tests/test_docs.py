# SPDX-License-Identifier: Apache-2.0
"""The pages on Python: their code prints what stands below it, the examples run, and docs/porting.md names what exists."""

import contextlib
import functools
import importlib
import importlib.util
import io
import os
import pathlib
import re
import runpy
import unittest

import abut

ROOT = pathlib.Path(__file__).resolve().parents[3]
PAGES = ROOT / "docs"


@unittest.skipUnless(importlib.util.find_spec("numpy"), "NumPy is not installed")
class Page(unittest.TestCase):
    def test_examples_run(self):
        for example in sorted((ROOT / "examples" / "python").glob("*.py")):
            if example.stem == "arm_on_workers":  # cluster.py runs it
                continue
            printed = io.StringIO()
            with self.subTest(example.name), contextlib.redirect_stdout(printed):
                runpy.run_path(str(example))
            self.assertRegex(printed.getvalue(), "[1-9][0-9]* contacts|contact 0.25 deep", example.name)

    def test_code_prints_what_the_pages_say(self):
        for page in ("python.md", "fcl.md", "porting.md"):
            names, checked = {}, 0
            text = (PAGES / page).read_text(encoding="utf-8")
            for code, expected in re.findall(r"(?<!-->\n)```python\n(.*?)```\n(?:```text\n(.*?)```)?", text, re.DOTALL):
                printed = io.StringIO()
                with self.subTest(page, code=code), contextlib.redirect_stdout(printed):
                    exec(code, names)
                self.assertEqual(printed.getvalue(), expected, code)
                checked += bool(expected)
            self.assertGreater(checked, 0, page)
            if "universe" in names:
                names["universe"].close()


def rows_of(page):
    """The tables of a page: {heading of the column: cell} of each row."""
    heading = None
    for line in (PAGES / page).read_text(encoding="utf-8").splitlines():
        if not line.startswith("|"):
            heading = None
            continue
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if heading is None:
            heading = cells
        elif set(cells[0]) != {"-"}:
            yield dict(zip(heading, cells))


@unittest.skipUnless(importlib.util.find_spec("numpy"), "NumPy is not installed")
@unittest.skipUnless("ABUT_HEADERS" in os.environ, "the folder of the headers was not given")
class Porting(unittest.TestCase):
    def test_names_exist(self):
        importlib.import_module("abut.fcl")
        headers = "".join(path.read_text(encoding="utf-8") for path in
                          pathlib.Path(os.environ["ABUT_HEADERS"], "abut").glob("*.h"))
        words, checked = set(re.findall(r"\w+", headers)), 0
        for row in rows_of("porting.md"):
            for name in re.findall(r"`(\w+)`", row.get("in C", "") + row.get("here", "")):
                self.assertIn(name, words, row)
                checked += 1
            for name in re.findall(r"`([\w.]+)`", row.get("in Python", "")):
                self.assertTrue(callable(functools.reduce(getattr, name.split("."), abut)), row)
                checked += 1
        self.assertGreater(checked, 100)


if __name__ == "__main__":
    unittest.main()
