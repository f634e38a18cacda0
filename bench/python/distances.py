#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares a batch of distances in Python with the same one in C, on the same poses: the least processor time of many.

usage: distances.py [count] [repeats]
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


def time_of(call, repeats):
    times = []
    for _ in range(repeats):
        start = time.process_time()
        found = call()
        times.append(time.process_time() - start)
    return min(times), found


def time_of_c(poses, count, repeats):
    library = pathlib.Path(os.environ["ABUT_LIBRARY"]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        program, data = pathlib.Path(folder, "distances"), pathlib.Path(folder, "poses")
        subprocess.run(["cc", "-O2", "-I", HERE.parents[1] / "include", HERE / "distances.c", library,
                        f"-Wl,-rpath,{library.parent}", "-o", program], check=True)
        poses.tofile(data)
        answer = subprocess.run([program, data, str(count), str(repeats)], check=True, capture_output=True, text=True)
    seconds, total = map(float, answer.stdout.split())
    return seconds, total


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    repeats = int(sys.argv[2]) if len(sys.argv) > 2 else 101
    random = numpy.random.default_rng(1)
    first, second = random_poses(random, count), random_poses(random, count)
    a, b = abut.Shape.box(0.5, 0.3, 0.2), abut.Shape.box(0.1, 0.4, 0.6)
    reused = abut.pairs_distance(a, first, b, second)
    in_c, total = time_of_c(numpy.vstack([first, second]), count, repeats)
    if abs(total - reused.distance.sum()) > 1e-9 * count:
        raise SystemExit("Python and C find different distances")
    narrow, wide = first.astype("f4"), numpy.hstack([second, second])[:, :7]
    rows = {
        "C, abut_pairs_distance": in_c,
        "Python, answers in an earlier one": time_of(lambda: abut.pairs_distance(a, first, b, second, out=reused), repeats)[0],
        "Python, new answers": time_of(lambda: abut.pairs_distance(a, first, b, second), repeats)[0],
        "Python, float32 and strided": time_of(lambda: abut.pairs_distance(a, narrow, b, wide), repeats)[0],
        "Python, one pose against all": time_of(lambda: abut.pairs_distance(a, first[0], b, second), repeats)[0],
        "Python, one call each": time_of(lambda: [abut.pair_distance(a, x, b, y) for x, y in zip(first, second)], 3)[0],
    }
    for name, seconds in rows.items():
        print(f"{name:36} {1e3 * seconds:8.3f} ms  {seconds / in_c:6.2f} times C")


if __name__ == "__main__":
    main()
