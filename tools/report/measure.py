# SPDX-License-Identifier: Apache-2.0
"""Runs the programs of bench/ and gathers what they measured."""

import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from document import VERSION, Wrong

ROOT = Path(__file__).resolve().parents[2]

# part: (program, arguments of a full run, of a quick one)
PROGRAMS = {
    "accuracy": ("accuracy", ["--cases", "8", "--repetitions", "3"], ["--cases", "2", "--repetitions", "1", "--without", "hull200"]),
    "deforming": ("deforming", ["--steps", "12", "--repetitions", "5"], ["--steps", "3", "--repetitions", "1"]),
    "extremes": ("extremes", ["--cases", "3"], ["--cases", "2", "--every", "3"]),
    "response": ("response", ["--seconds", "10"], ["--seconds", "1"]),
    "response_maps": ("response_maps", ["--seconds", "4"], ["--every", "2", "--seconds", "1"]),
    "steadiness": ("steadiness", ["--steps", "10000"], ["--steps", "200"])}
STEPS = "^(pile|sparse)/step/(abut|bullet|fcl|ode)$"  # of the suite of universes, whose flags are those of Google Benchmark


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


def _flags(build):
    """Those that change times and bits: of a file of the benchmarks."""
    path = build / "compile_commands.json"
    commands = json.loads(path.read_text(encoding="utf-8")) if path.exists() else []
    words = next((one["command"].split() for one in commands if one["file"].endswith("bench/accuracy_rows.cpp")), [])
    kept = ("-O", "-DNDEBUG", "-march", "-ffp-contract", "-fno-math-errno", "-ftrivial-auto-var-init=", "-fstack", "-fcf", "-flto", "-std")
    return " ".join(dict.fromkeys(word for word in words if word.startswith(kept))) or "unknown"


def _peers(build):
    """The versions of packages, and of libraries that were built from sources (ABUT_PEERS)."""
    packages = ("libbullet-dev", "libfcl-dev", "libode-dev", "libccd-dev")
    installed = [f"{name[3:-4]} {_first_line('dpkg-query', '--show', '--showformat=${Version}', name)}" for name in packages]
    built = build / "bench" / "peers.txt"
    return ", ".join([*installed, built.read_text(encoding="utf-8").strip()] if built.exists() else installed)


def machine(build, quick):
    return {"date": time.strftime("%Y-%m-%d"), "processor": _processor(), "processors": os.cpu_count(),
            "system": f"{platform.system()} {platform.release()}",
            "compiler": _first_line(_from_cache(build, "CMAKE_CXX_COMPILER") or "clang++-19", "--version"),
            "build": _from_cache(build, "CMAKE_BUILD_TYPE") or "unknown", "flags": _flags(build),
            "abut": _first_line("git", "-C", str(ROOT), "describe", "--always", "--dirty"),
            "peers": _peers(build),
            "run": "quick: few cases, short runs" if quick else "full"}


def _progress(text):
    print(text, file=sys.stderr, flush=True)


def _ran(path, arguments):
    result = subprocess.run([path, *arguments], stdout=subprocess.DEVNULL, check=False)
    if result.returncode != 0:
        raise Wrong(f"{path.name} ended with {result.returncode}")


def _steps(path, quick, out):
    """What Google Benchmark writes, as rows."""
    _ran(path, [f"--benchmark_filter={STEPS}", f"--benchmark_repetitions={2 if quick else 5}", f"--benchmark_min_time={0.05 if quick else 0.2}",
                f"--benchmark_out={out}", "--benchmark_out_format=json"])
    times = {}
    for one in json.loads(out.read_text(encoding="utf-8"))["benchmarks"]:
        if one["run_type"] == "iteration":
            times.setdefault(one["run_name"].split(":")[0], []).append(one["cpu_time"])
    rows = []
    for name, found in times.items():
        scene, _, contender = name.split("/")[:3]
        rows.append({"scene": scene, "contender": contender, "milliseconds": statistics.median(found)})
    return {"rows": rows}


def _judged(path, name, arguments, out):
    """What a program with --json wrote."""
    more = ["--out", out.parent] if name in ("accuracy", "response") else []
    _ran(path, ["--json", out, *arguments, *more])
    return json.loads(out.read_text(encoding="utf-8"))


def run(build, quick, only):
    """The document; parts whose program is missing are left out, and told."""
    document = {"version": VERSION, "machine": machine(build, quick)}
    parts = [*PROGRAMS, "universe"]
    load = [os.getloadavg()[0]]
    with tempfile.TemporaryDirectory() as folder:
        for i, name in enumerate(parts, 1):
            program, full, short = PROGRAMS.get(name, (name, [], []))
            path = build / "bench" / f"abut_bench_{program}"
            if only and name not in only:
                continue
            if not path.exists():
                _progress(f"[{i}/{len(parts)}] {name}: left out, {path.name} is not built")
                continue
            _progress(f"[{i}/{len(parts)}] {name}")
            out = Path(folder, f"{name}.json")
            start = time.monotonic()
            document[name] = _steps(path, quick, out) if name == "universe" else _judged(path, name, short if quick else full, out)
            document[name]["seconds"] = round(time.monotonic() - start, 1)
            load.append(os.getloadavg()[0])
            _progress(f"      {document[name]['seconds']} s")
    # The programs themselves take one processor.
    document["machine"]["load"] = f"{load[0]:.1f} at the start, at most {max(load):.1f} while it ran"
    return document
