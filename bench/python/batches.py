#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares batches in Python with a loop of single calls in C, on the same poses of two boxes.

usage: batches.py [count] [repeats]
Times are the least processor times of many, on one thread. A row of all threads has the least time of the clock.
Needs NumPy, a C compiler, the package abut, and ABUT_LIBRARY with the file of the library.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy

import abut

HERE = pathlib.Path(__file__).resolve().parent


def random_poses(random, count):
    turns = random.normal(size=(count, 4))
    turns /= numpy.linalg.norm(turns, axis=1, keepdims=True)
    return numpy.hstack([random.uniform(-1, 1, (count, 3)), turns])


def time_of(call, repeats, clock=time.process_time):
    times = []
    for _ in range(repeats):
        start = clock()
        found = call()
        times.append(clock() - start)
    return min(times), found


def build_c(folder):
    library, program = pathlib.Path(os.environ["ABUT_LIBRARY"]).resolve(), pathlib.Path(folder, "batches")
    subprocess.run(["cc", "-O2", "-I", HERE.parents[1] / "include", HERE / "batches.c", library,
                    f"-Wl,-rpath,{library.parent}", "-lm", "-o", program], check=True)
    return program


def numbers_of_c(program, question, poses, count, repeats):
    data = pathlib.Path(program.parent, "poses")
    poses.tofile(data)
    answer = subprocess.run([program, question, data, str(count), str(repeats)], check=True, capture_output=True,
                            text=True)
    return map(float, answer.stdout.split())


def compare(question, program, first, second, repeats, ask, ask_one, sum_of):
    count = len(first)
    loop, batch, total = numbers_of_c(program, question, numpy.vstack([first, second]), count, repeats)
    narrow, wide = first.astype("f4"), numpy.hstack([second, second])[:, :7]
    rows = {
        f"{question} in C, single calls": loop,
        f"{question} in C, one call": batch,
        "Python": None,
        "Python, float32 and strided": time_of(lambda: ask(narrow, wide, threads=1), repeats)[0],
        "Python, one pose against all": time_of(lambda: ask(first[0], second, threads=1), repeats)[0],
        "Python, all threads, by the clock": time_of(lambda: ask(first, second), repeats, time.perf_counter)[0],
        "Python, one call each": time_of(lambda: [ask_one(x, y) for x, y in zip(first, second)], 3)[0],
    }
    rows["Python"], found = time_of(lambda: ask(first, second, threads=1), repeats)
    if abs(total - sum_of(found)) > 1e-9 * count:
        raise SystemExit(f"Python and C find different {question}")
    for name, seconds in rows.items():
        print(f"{name:34} {1e3 * seconds:8.3f} ms  {seconds / loop:6.2f} times single calls in C")


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    repeats = int(sys.argv[2]) if len(sys.argv) > 2 else 101
    random = numpy.random.default_rng(1)
    first, second = random_poses(random, count), random_poses(random, count)
    a, b = abut.Shape.box(0.5, 0.3, 0.2), abut.Shape.box(0.1, 0.4, 0.6)
    with tempfile.TemporaryDirectory() as folder:
        given = (build_c(folder), first, second, repeats)
        compare("distances", *given, lambda x, y, **rest: abut.pairs_distance(a, x, b, y, **rest),
                lambda x, y: abut.pair_distance(a, x, b, y), lambda found: found.distance.sum())
        compare("contacts", *given, lambda x, y, **rest: abut.pairs_contacts(a, x, b, y, **rest),
                lambda x, y: abut.pair_contacts(a, x, b, y), lambda found: found.records.distance.sum())
        compare("casts", *given, lambda x, y, **rest: abut.pairs_cast(a, x, -x[..., :3], b, y, **rest),
                lambda x, y: abut.pair_cast(a, x, -x[:3], b, y),
                lambda found: found.fraction[numpy.isfinite(found.fraction)].sum())


if __name__ == "__main__":
    main()
