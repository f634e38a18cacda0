# SPDX-License-Identifier: Apache-2.0
"""Compiles the public headers alone, twice and in the layout test, in every language version of one compiler.

usage: compile.py gcc|g++|clang|clang++ ROOT
Exit status 77 says that the compiler is not installed.
"""

import pathlib
import shutil
import subprocess
import sys

COMMON = ["-fsyntax-only", "-pedantic-errors", "-Wall", "-Wextra", "-Werror"]
C = ["-x", "c", "-Wstrict-prototypes"]
# C++98 has no 64-bit integers of its own; the system's <stdint.h> brings them along.
CXX = ["-x", "c++", "-Wno-long-long"]
COMPILERS = {
    "gcc": (["gcc"], C, ["c99", "c11", "c17"]),
    "g++": (["g++"], CXX, ["c++98", "c++11", "c++17"]),
    "clang": (["clang-19", "clang"], [*C, "-Wc++-compat"], ["c99", "c11", "c17", "c23"]),
    "clang++": (["clang++-19", "clang++"], CXX, ["c++98", "c++11", "c++20"]),
}


def main(compiler, root):
    names, options, standards = COMPILERS[compiler]
    path = next(filter(None, map(shutil.which, names)), None)
    if path is None:
        print(f"skipped: {compiler} is not installed")
        return 77
    tests = root / "tests" / "capi"
    sources = [*sorted((tests / "header").glob("*.c")), tests / "layout.c"]
    failures = 0
    for standard in standards:
        for source in sources:
            command = [path, f"-std={standard}", *COMMON, *options, "-I", str(root / "include"),
                       "-I", str(root / "capi"), str(source)]
            if subprocess.run(command, check=False).returncode != 0:
                print("failed:", *command)
                failures += 1
    print(f"{compiler}: {len(sources)} files in {len(standards)} language versions, {failures} failed")
    return 1 if failures or not sources else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2])))
