# SPDX-License-Identifier: Apache-2.0
"""Checks the code in the documents: compiles and runs it.

usage: check_code.py ROOT FOLDER PYTHON_LIBRARY PROGRAM LIBRARY...
FOLDER takes what is built. PYTHON_LIBRARY is the library for the Python binding; PROGRAM is `abut`, or - without one.
CONTRIBUTING.md tells the rules. Exit status 77 says that a compiler is not installed.
"""

import collections
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from compiled import Compiler
from pages import BadPage, blocks, documents

# Folders that commands name; what they write lies elsewhere.
FOLDERS = ("scripts", "examples", "docs", "bindings", "include", "cmake", "tools", "tests")


def run(block, command, folder, environment, **options):
    """What is wrong when a command runs for a block; empty when nothing is."""
    done = subprocess.run(command, check=False, capture_output=True, text=True, timeout=120, cwd=folder,
                          env={**os.environ, **environment}, **options)
    if done.returncode != 0:
        return f"{block.place}: fails with {done.returncode}\n{done.stdout}{done.stderr}"
    return block.wrong_output(done.stdout) if block.language == "sh" and "-n" not in command else ""


def excerpt_failure(block, root):
    """A block that shows a part of a file of the tree: its lines stand there, one after the other."""
    path = root / block.markers["from"]
    if not path.is_file():
        return f"{block.place}: there is no {block.markers['from']}"
    shown = [line.strip() for line in block.code.split("\n") if line.strip()]
    lines = [line.strip() for line in path.read_text(encoding="utf-8").split("\n") if line.strip()]
    if any(lines[i : i + len(shown)] == shown for i in range(len(lines))):
        return ""
    return f"{block.place}: {block.markers['from']} has no such lines, one after the other"


# Runs the steps of a page: (line, lines that come before, code, what it prints or None).
PYTHON_PAGE = """
import contextlib, io, sys
names = {"__name__": "__main__"}
for line, given, code, output in STEPS:
    exec(compile(given, PAGE, "exec"), names)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile("\\n" * (line - 1) + code, PAGE, "exec"), names)
    if output is not None and printed.getvalue().rstrip() != output.rstrip():
        sys.exit(f"{PAGE}:{line}: prints\\n{printed.getvalue().rstrip()}\\ninstead of\\n{output.rstrip()}")
"""


def python_failure(page, found, root, folder, library):
    """The blocks of a page run one after the other, as a reader would type them."""
    steps = [(block.line, block.markers.get("given", ""), block.code, block.output)
             for block in found if "no-run" not in block.markers]
    for block in found:
        compile(block.code, block.place, "exec")
    script = folder / (re.sub(r"\W", "_", page) + ".py")
    script.write_text(f"PAGE = {page!r}\nSTEPS = {steps!r}\n{PYTHON_PAGE}", encoding="utf-8")
    environment = {"PYTHONPATH": str(root / "bindings" / "python"), "ABUT_LIBRARY": library}
    failure = run(found[0], [sys.executable, "-B", str(script)], folder, environment)
    missing = re.search(r"ModuleNotFoundError: No module named '(?!abut)([^']+)'", failure)
    if missing:
        print(f"skipped: the blocks of Python in {page} need {missing[1]}, which is not installed")
        return ""
    return failure


def shell_failure(block, root, folder, program):
    syntax = run(block, ["bash", "-n"], folder, {}, input=block.code)
    if syntax:
        return syntax
    for word in re.findall(rf"(?<![\w./-])(?:{'|'.join(FOLDERS)})/[\w./-]*", block.code):
        if not (root / word).exists() and "build" not in word:
            return f"{block.place}: there is no {word}"
    if "run" not in block.markers or program is None:
        return ""
    place = folder / "shell"
    place.mkdir(exist_ok=True)
    for name in FOLDERS:
        if not (place / name).exists():
            (place / name).symlink_to(root / name)
    return run(block, ["bash", "-euo", "pipefail", "-c", block.code], place, {"PATH": f"{program.parent}:{os.environ['PATH']}"})


def json_failure(block, root, folder, program):
    """JSON is whole; what has parts is a scene, and is stepped."""
    try:
        value = json.loads(block.code)
    except ValueError as error:
        return f"{block.place}: no JSON: {error}"
    if program is None or "no-run" in block.markers or not (isinstance(value, dict) and "parts" in value):
        return ""
    place = folder / "scenes"
    if not place.exists():
        shutil.copytree(root / "examples" / "scenes", place)
    scene = place / "scene_of_a_page.json"
    scene.write_text(block.code, encoding="utf-8")
    return run(block, [str(program), "run", str(scene), "--quiet"], place, {})


def main(root, folder, library, program, libraries):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    program = None if str(program) == "-" else program.resolve()
    by_language, failures, excerpts, not_checked = collections.defaultdict(list), [], 0, collections.Counter()
    for path in documents(root):
        page = str(path.relative_to(root))
        try:
            for block in blocks(page, path.read_text(encoding="utf-8")):
                if "from" in block.markers:
                    excerpts += 1
                    failures.append(excerpt_failure(block, root))
                elif "no-check" not in block.markers:
                    by_language[block.language].append(block)
        except BadPage as error:
            failures.append(str(error))
    compiled = by_language.pop("c", []) + by_language.pop("cpp", [])
    missing = {Compiler.missing(block.language) for block in compiled} - {None}
    if missing:
        print(f"skipped: {', '.join(sorted(missing))} is not installed")
        return 77
    count, found = Compiler(root, folder, libraries).failures(compiled)
    failures += found
    for page, group in group_by_page(by_language.pop("python", [])).items():
        count += len(group)
        try:
            failures.append(python_failure(page, group, root, folder, library))
        except SyntaxError as error:
            failures.append(f"{error.filename}: {error.msg}, line {error.lineno} of the block")
    for language, check in (("sh", shell_failure), ("json", json_failure)):
        for block in by_language.pop(language, []):
            count += 1
            failures.append(check(block, root, folder, program))
    for language, group in by_language.items():
        not_checked[language or "text"] = len(group)
    failures = [failure for failure in failures if failure]
    for failure in failures:
        print(failure)
    rest = ", ".join(f"{number} of {language}" for language, number in sorted(not_checked.items()))
    print(f"{count} blocks checked, {excerpts} compared with files, {len(failures)} failed; not looked at: {rest or 'none'}")
    return 1 if failures or not count else 0


def group_by_page(found):
    groups = collections.defaultdict(list)
    for block in found:
        groups[block.page].append(block)
    return groups


if __name__ == "__main__":
    root, folder, library, program, *libraries = sys.argv[1:]
    sys.exit(main(pathlib.Path(root).resolve(), pathlib.Path(folder), library, pathlib.Path(program),
                  [pathlib.Path(path) for path in libraries]))
