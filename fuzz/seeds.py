#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the committed corpus: six records for each pair of kinds of cmake/registry.cmake.

usage: fuzz/seeds.py
"""
import re
import struct
from pathlib import Path

HERE = Path(__file__).resolve().parent
FLAT_A, DOUBLED_A, FLAT_B, DOUBLED_B, LATTICE, PARALLEL = 1, 2, 4, 8, 16, 64
A = (1, 0.75, 0.5, 0.25, 1.5, -0.5, 2, 3)
B = (0.5, 1.25, 0.75, -0.5, 1, 2.5, -1, 0.125)
TURNED = (0.9, 0.3, 0.1, 0.3)


def record(flags=0, a=A, b=B, rotation=TURNED, position=(0, 0, 0), margin=0.0):
    return struct.pack("<BB25d", 1, flags, *a, *b, *rotation, *position, margin, 0.0)


def seeds():
    flat_a, flat_b = A[:2] + (0,) + A[3:], B[:2] + (0,) + B[3:]
    return {
        "apart": record(position=(2.5, -3, 4), margin=0.125),
        # The first number is the reach along X of spheres, boxes and capsules.
        "touching": record(PARALLEL | LATTICE, position=(A[0] + B[0], 0, 0), margin=2**-20),
        "deep": record(position=(0.1, -0.05, 0.2)),
        "coincident": record(PARALLEL, b=A),
        "parallel": record(PARALLEL | LATTICE, position=(0, 0, 1)),
        "degenerate": record(FLAT_A | DOUBLED_A | FLAT_B | DOUBLED_B, a=flat_a, b=flat_b, position=(0.5, 0.25, 0.0625)),
    }


def main():
    registry = (HERE.parent / "cmake" / "registry.cmake").read_text(encoding="utf-8")
    kinds = sorted(re.findall(r"^abut_shape\((\w+)", registry, re.MULTILINE))
    for place, a in enumerate(kinds):
        for b in kinds[place:]:
            folder = HERE / "corpus" / f"{a}_{b}"
            folder.mkdir(parents=True, exist_ok=True)
            for name, data in seeds().items():
                (folder / name).write_bytes(data)


if __name__ == "__main__":
    main()
