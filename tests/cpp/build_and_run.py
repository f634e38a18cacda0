# SPDX-License-Identifier: Apache-2.0
"""Compiles the tests of the headers for C++ in one way, links them to the shared libraries, and runs them.

usage: build_and_run.py COMPILER-STANDARD[-results] ROOT FOLDER LIBRARY...
With `results` calls answer a Result and the compiler has no exceptions. Without, those tests are compiled with
ABUT_NO_EXCEPTIONS and linked to the others, since both ways may meet in one program. FOLDER takes what is built.
Exit status 77 says that the compiler is not installed.
"""

import pathlib
import shutil
import subprocess
import sys

COMPILERS = {"g++": ["g++"], "clang++": ["clang++-19", "clang++"]}
# What careful users turn on; nothing is switched off for the headers.
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Wsign-conversion", "-Wold-style-cast", "-Werror"]


def run(command):
    """Whether a command succeeds; what it prints is shown."""
    done = subprocess.run(command, check=False, capture_output=True, text=True)
    if done.returncode != 0:
        print("failed:", *command)
    print(done.stdout + done.stderr, end="")
    return done.returncode == 0


def main(way, root, folder, libraries):
    name, standard, *rest = way.rsplit("-", 2) if way.endswith("-results") else way.rsplit("-", 1)
    compiler = next(filter(None, map(shutil.which, COMPILERS[name])), None)
    if compiler is None:
        print(f"skipped: {name} is not installed")
        return 77
    absent = [name for name in ("picking", "response") if not any(f"abut_{name}" in library.name for library in libraries)]
    # By -I, not as a system folder: warnings of the headers count here.
    options = [f"-std={standard}", *WARNINGS, f"-I{root / 'include'}"]
    tests = root / "tests" / "cpp"
    parts = {tests / "results": ["-fno-exceptions"]} if rest else {tests: [], tests / "results": ["-DABUT_NO_EXCEPTIONS"]}
    folder.mkdir(parents=True, exist_ok=True)
    objects = []
    for part, more in parts.items():
        # One source of all in a folder, since most of the time goes into the headers.
        together = folder / f"{part.name}.cpp"
        sources = [source for source in sorted(part.glob("*.cpp")) if not any(name in source.name for name in absent)]
        together.write_text("".join(f'#include "{source}"\n' for source in sources), encoding="utf-8")
        objects.append(str(together.with_suffix(".o")))
        if not run([compiler, *options, *more, "-c", str(together), "-o", objects[-1]]):
            return 1
    program = folder / "program"
    paths = [f"-Wl,-rpath,{library.parent}" for library in libraries]
    link = [compiler, *objects, *map(str, libraries), *paths, "-lgtest", "-lgtest_main", "-o", str(program)]
    return 0 if run(link) and run([str(program), "--gtest_brief=1"]) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), [pathlib.Path(path) for path in sys.argv[4:]]))
