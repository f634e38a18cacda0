# SPDX-License-Identifier: Apache-2.0
"""Installs the package with pip into new environments, without a network, and runs the first query there: once with the
libraries of the system, and once with copies of them in the wheel.

usage: wheel.py PACKAGE EXAMPLE
ABUT_LIBRARY names the library that the wheel carries.
"""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

CHECK = """
import abut, importlib.metadata, pathlib
assert pathlib.Path(abut.__file__).is_relative_to({folder!r}), abut.__file__
assert pathlib.Path(abut.library._name).is_relative_to({folder!r}), abut.library._name
assert importlib.metadata.version("abut") == abut.__version__ == abut.version()
assert {has_picking} == (abut.c.picking is not None), abut.c.picking_failure
others = {{line.split()[-1] for line in open("/proc/self/maps") if any(name in line for name in {others})}}
outside = [path for path in others if not pathlib.Path(path).is_relative_to({folder!r})]
assert not {carries} or others and not outside, (others, outside)
"""
OTHERS = ("libccd", "libqhull", "libtbb", "libembree")


def main():
    package, example = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    if not importlib.util.find_spec("ensurepip"):
        print("skipped: Python has no ensurepip; scripts/setup installs python3-venv")
        return 77
    if not shutil.which("patchelf"):
        print("skipped: patchelf is missing; scripts/setup installs it")
        return 77
    return install(package, example, False) or install(package, example, True)


def install(package, example, carries):
    """Whether the first query fails in a new environment, where the wheel `carries` the libraries of others or not."""
    has_picking = any(pathlib.Path(os.environ["ABUT_LIBRARY"]).parent.glob("libabut_picking.so.*"))
    with tempfile.TemporaryDirectory() as folder:
        python = pathlib.Path(folder, "bin", "python")
        quiet = {"check": True, "cwd": folder}
        subprocess.run([sys.executable, "-m", "venv", folder], **quiet)
        settings = ["--config-settings", "dependencies=carried"] if carries else []
        subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-index", "--disable-pip-version-check", *settings, package],
                       **quiet)
        clean = {name: value for name, value in os.environ.items() if not name.startswith(("ABUT_", "PYTHON"))}
        check = CHECK.format(folder=folder, has_picking=has_picking, carries=carries, others=OTHERS)
        subprocess.run([python, "-c", check], env=clean, **quiet)
        found = subprocess.run([python, example], env=clean, capture_output=True, text=True, **quiet).stdout
    print(found, end="")
    return 0 if "distance -0.25, normal (0, 0, 1)" in found else 1


if __name__ == "__main__":
    sys.exit(main())
