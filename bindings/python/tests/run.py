# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of this folder.

usage: run.py [--without-numpy | --with-numpy]
The first is as where NumPy is not installed. The second skips all, with 77, where it is not.
"""

import importlib.util
import pathlib
import sys
import unittest

if __name__ == "__main__":
    if "--without-numpy" in sys.argv:
        sys.modules["numpy"] = None
    elif "--with-numpy" in sys.argv and not importlib.util.find_spec("numpy"):
        print("skipped: NumPy is not installed; scripts/setup installs it")
        sys.exit(77)
    tests = unittest.defaultTestLoader.discover(str(pathlib.Path(__file__).parent))
    sys.exit(not unittest.TextTestRunner().run(tests).wasSuccessful())
