# SPDX-License-Identifier: Apache-2.0
"""Runs the programs of bench/ and gathers what they measured."""

import json
import os
import platform
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from document import VERSION, Wrong

ROOT = Path(__file__).resolve().parents[2]

# part: (program, arguments of a full run, of a quick one)
PROGRAMS = {
    "accuracy": ("accuracy", ["--cases", "16", "--repetitions", "3"], ["--cases", "2", "--repetitions", "1", "--without", "hull200"]),
    "extremes": ("extremes", ["--cases", "6"], ["--cases", "2", "--every", "3"]),
    "response": ("response", ["--seconds", "10"], ["--seconds", "1"]),
    "response_maps": ("response_maps", ["--seconds", "4"], ["--every", "2", "--seconds", "1"]),
    "steadiness": ("steadiness", ["--steps", "10000"], ["--steps", "200"])}


def _first_line(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.split("\n")[0].strip()
    except (OSError, subprocess.CalledProcessError):
        return "unknown"


def _processor():
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").split("\n")
    except OSError:
        return platform.processor() or "unknown"
    return next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown")


def _from_cache(build, name):
    cache = build / "CMakeCache.txt"
    lines = cache.read_text(encoding="utf-8").split("\n") if cache.exists() else []
    return next((line.split("=", 1)[1] for line in lines if line.startswith(name + ":")), "")


def machine(build, quick):
    packages = ("libbullet-dev", "libfcl-dev", "libode-dev", "libccd-dev")
    return {"date": time.strftime("%Y-%m-%d"), "processor": _processor(), "processors": os.cpu_count(),
            "system": f"{platform.system()} {platform.release()}",
            "compiler": _first_line(_from_cache(build, "CMAKE_CXX_COMPILER") or "clang++-19", "--version"),
            "build": f"{_from_cache(build, 'CMAKE_BUILD_TYPE')}, {_from_cache(build, 'ABUT_ARCH') or 'x86-64-v3'}",
            "abut": _first_line("git", "-C", str(ROOT), "describe", "--always", "--dirty"),
            "peers": ", ".join(f"{name[3:-4]} {_first_line('dpkg-query', '--show', '--showformat=${Version}', name)}" for name in packages),
            "run": "quick: few cases, short runs" if quick else "full"}


def _progress(text):
    print(text, file=sys.stderr, flush=True)


def run(build, quick, only):
    """The document; parts whose program is missing are left out, and told."""
    document = {"version": VERSION, "machine": machine(build, quick)}
    with tempfile.TemporaryDirectory() as folder:
        for i, (name, (program, full, short)) in enumerate(PROGRAMS.items(), 1):
            path = build / "bench" / f"abut_bench_{program}"
            if only and name not in only:
                continue
            if not path.exists():
                _progress(f"[{i}/{len(PROGRAMS)}] {name}: left out, {path.name} is not built")
                continue
            _progress(f"[{i}/{len(PROGRAMS)}] {name}")
            out = Path(folder, f"{name}.json")
            start = time.monotonic()
            more = ["--out", folder] if program in ("accuracy", "response") else []
            result = subprocess.run([path, "--json", out, *(short if quick else full), *more], stdout=subprocess.DEVNULL, check=False)
            if result.returncode != 0:
                raise Wrong(f"{path.name} ended with {result.returncode}")
            document[name] = json.loads(out.read_text(encoding="utf-8"))
            document[name]["seconds"] = round(time.monotonic() - start, 1)
            _progress(f"      {document[name]['seconds']} s")
    return document
