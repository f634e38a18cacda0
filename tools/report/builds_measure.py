# SPDX-License-Identifier: Apache-2.0
"""Weighs builds of libabut: bytes, what they load, how long a program takes to start, and a step."""

import json
import os
import re
import shutil
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

from document import Wrong

STARTS = 20


def _setting(build, name):
    for line in (build / "CMakeCache.txt").read_text(encoding="utf-8").split("\n"):
        if line.startswith(name + ":"):
            return line.split("=", 1)[1].replace(";", " ")
    return ""


def _stripped(library):
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder, library.name)
        shutil.copy(library, copy)
        tool = shutil.which("strip") or shutil.which("llvm-strip-19")
        if tool is None:
            raise Wrong("there is no program strip")
        subprocess.run([tool, copy], check=True)
        return copy.stat().st_size


def _loaded(program, environment):
    text = subprocess.run(["ldd", program], env=environment, capture_output=True, text=True, check=True).stdout
    names = [re.match(r"\s*(\S+)", line)[1] for line in text.split("\n") if "=>" in line]
    return sorted(Path(name).name for name in names if not name.startswith("linux-vdso"))


def _milliseconds(command, environment):
    start = time.perf_counter()
    subprocess.run(command, env=environment, check=True)
    return 1e3 * (time.perf_counter() - start)


def rows(build, others):
    """Of `build`, which has the program, and of other folders of builds."""
    program = build / "bench" / "abut_bench_footprint"
    if not program.exists():
        raise Wrong(f"{program} is not built")
    folders = [build, *others]
    for folder in folders:
        if not (folder / "capi" / "libabut.so").exists():
            raise Wrong(f"--lean is {folder}; there is no capi/libabut.so in it")
    environments = [os.environ | {"LD_LIBRARY_PATH": str(folder / "capi")} for folder in folders]
    # All in turns, so that a slow second is one of each.
    starts = [[_milliseconds([program, "start"], its) - _milliseconds(["true"], its) for its in environments] for _ in range(STARTS)]
    result = []
    for i, (folder, environment) in enumerate(zip(folders, environments)):
        runs = [json.loads(subprocess.run([program], env=environment, capture_output=True, text=True, check=True).stdout) for _ in range(3)]
        library = (folder / "capi" / "libabut.so").resolve()
        result.append({
            "name": folder.name, "shapes": _setting(folder, "ABUT_SHAPES"), "features": _setting(folder, "ABUT_FEATURES"),
            "bytes": library.stat().st_size, "stripped_bytes": _stripped(library),
            "start_milliseconds": statistics.median(start[i] for start in starts),
            "resident_bytes": runs[-1]["resident_bytes"], "step_microseconds": min(run["step_microseconds"] for run in runs),
            "libraries": _loaded(program, environment)})
    return result
