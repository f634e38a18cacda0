# SPDX-License-Identifier: Apache-2.0
"""Compiles a program with the command of another one and compares the errors with what it expects.

usage: compile.py compile_commands.json control.cpp case.cpp
The case says `// expect: <pattern>`; every error has to match it, and there has to be one. A case
without that line has to compile.
"""

import json
import re
import shlex
import subprocess
import sys
from pathlib import Path


def main(database, control, case):
    entry = next(entry for entry in json.loads(Path(database).read_text()) if entry["file"] == control)
    command = shlex.split(entry["command"])
    output = command.index("-o")
    command[output : output + 2] = ["-fsyntax-only", "-fno-color-diagnostics"]
    command = [case if argument == control else argument for argument in command]
    result = subprocess.run(command, cwd=entry["directory"], capture_output=True, text=True)
    errors = re.split(r"^(?=\S+: error: )", result.stderr, flags=re.MULTILINE)[1:]  # each with its notes
    expected = re.search(r"^// expect: (.*)$", Path(case).read_text(), re.MULTILINE)
    print(result.stderr)
    if expected is None:
        return result.returncode
    if result.returncode == 0:
        print(f"it compiled; expected an error like: {expected[1]}")
        return 1
    others = [error for error in errors if not re.search(expected[1], error)]
    if others or not errors:
        print(f"expected only errors like: {expected[1]}")
        return 1
    return 0


sys.exit(main(*sys.argv[1:]))
