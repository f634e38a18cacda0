#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the recipes of ports/ with CMakeLists.txt.

usage: check_recipes.py ROOT CMAKE PORT_STEPS
"""

import ast
import json
import pathlib
import re
import subprocess
import sys


def constants(path):
    """{name: value} of literals that a Python file assigns, in its classes as well."""
    found = {}
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            try:
                found[node.targets[0].id] = ast.literal_eval(node.value)
            except ValueError:
                pass
    return found


def steps_of(root, cmake, script, features):
    """What the port does where these features are chosen."""
    found = subprocess.run([cmake, "-D", f"FEATURES={';'.join(['core', *features])}", "-D",
                            f"PORTFILE={root / 'ports/vcpkg/abut/portfile.cmake'}", "-P", script], capture_output=True, text=True)
    return [line.strip() for line in found.stderr.split("\n") if line.startswith("vcpkg_")], found


def failures(root, cmake, script):
    build = (root / "CMakeLists.txt").read_text(encoding="utf-8")
    version = re.search(r"^project\(abut VERSION ([\d.]+)", build, re.MULTILINE)[1]
    features = re.search(r'^set\(ABUT_FEATURES "([^"]*)"', build, re.MULTILINE)[1].split(";")
    port = json.loads((root / "ports/vcpkg/abut/vcpkg.json").read_text(encoding="utf-8"))
    recipe = constants(root / "ports/conan/conanfile.py")
    for name, found in (("vcpkg.json", port["version"]), ("conanfile.py", recipe["version"])):
        if found != version:
            yield f"{name} names the version {found}; it is {version}"
    for name, found in (("vcpkg.json", port["features"]), ("conanfile.py", recipe["FEATURES"])):
        if set(found) != set(features):
            yield f"{name} has the features {sorted(found)}; there are {sorted(features)}"
    for feature in port["default-features"]:
        if feature not in features:
            yield f"vcpkg.json chooses {feature}, which is no feature"
    for chosen, targets in (([], ["abut"]), (features, ["abut", "abut_picking", "abut_response"])):
        steps, run = steps_of(root, cmake, script, chosen)
        if run.returncode or not any(f"-DABUT_FEATURES={'|'.join(chosen)}" in step for step in steps):
            yield f"the port cannot be read with the features {chosen}:\n{run.stderr}"
        built = [step.rpartition("|")[2] for step in steps if step.startswith("vcpkg_cmake_build")]
        if built != targets:
            yield f"the port builds {built} with the features {chosen}; expected {targets}"
        installed = {step.split("|")[5] for step in steps if step.startswith("vcpkg_execute_required_process")}
        if installed != {"library", "dev", *(target.removeprefix("abut_") for target in targets[1:])}:
            yield f"the port installs {installed} with the features {chosen}"


def main(root, cmake, script):
    found = list(failures(pathlib.Path(root), cmake, script))
    print("\n".join(found))
    return 1 if found else 0


sys.exit(main(*sys.argv[1:]))
