# SPDX-License-Identifier: Apache-2.0
"""The code in docs/python.md runs, in its order, and prints what stands below it. Needs NumPy."""

import contextlib
import importlib.util
import io
import pathlib
import re
import unittest

PAGE = pathlib.Path(__file__).resolve().parents[3] / "docs" / "python.md"


@unittest.skipUnless(importlib.util.find_spec("numpy"), "NumPy is not installed")
class Page(unittest.TestCase):
    def test_code_prints_what_the_page_says(self):
        blocks = re.findall(r"```python\n(.*?)```\n```text\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
        self.assertGreater(len(blocks), 5)
        names = {}
        for code, expected in blocks:
            printed = io.StringIO()
            with self.subTest(code), contextlib.redirect_stdout(printed):
                exec(code, names)
            self.assertEqual(printed.getvalue(), expected, code)
        names["universe"].close()


if __name__ == "__main__":
    unittest.main()
