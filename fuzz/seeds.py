#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the committed corpus: six records for all pairs of kinds, one more for pairs with a mesh, which is made by cells
there, and motions.

usage: fuzz/seeds.py
"""
import struct
from pathlib import Path

HERE = Path(__file__).resolve().parent
FLAT_A, DOUBLED_A, FLAT_B, DOUBLED_B, LATTICE, PARALLEL, OF_CELLS = 1, 2, 4, 8, 16, 64, 128
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


# How two shapes move: bits of MovingRecord::aim.
MEETS, RESTS, MOVES_ALIKE, GRAZES, STARTS_TOUCHING = 1, 2, 8, 16, 64


def motion(velocity=(0, 0, 0), spin=(0, 0, 0), push=(0, 0, 0), turning=(0, 0, 0), centre=(0, 0, 0)):
    return (*velocity, *spin, *push, *turning, *centre)


def moving_record(scene, aim=MEETS, a=motion(), b=motion()):
    return scene + struct.pack("<B30d", aim, *a, *b)


def motions():
    giant, speck = tuple(2.0**10 * x for x in A), tuple(2.0**-10 * x for x in B)
    sheet, needle = (1, 1, 2**-20) + A[3:], (2**-18, 2**-18, 1) + A[3:]
    blade = (2, 0.01, 0.1) + A[3:]
    away, far = (4, -3, 2), (3000, 2000, -1000)
    turns, turns_back = motion(spin=(1, -2, 0.5)), motion(spin=(-3, 0.25, 1), push=(0.1, 0, -0.2))
    propeller = motion(spin=(0, 0, 20))
    return {
        "giant_and_speck": moving_record(record(a=giant, b=speck, position=far), a=turns, b=turns_back),
        "sheets": moving_record(record(a=sheet, b=sheet, position=away), a=turns, b=turns_back),
        "needles": moving_record(record(a=needle, b=needle, position=away), a=turns, b=turns_back),
        "propellers": moving_record(record(PARALLEL, a=blade, b=blade, position=(3, 0, 0)), a=propeller, b=propeller),
        "both_turn": moving_record(record(position=away), a=turns, b=turns_back),
        "grazing": moving_record(record(PARALLEL, position=away), GRAZES, b=motion(velocity=(-1, 0.5, 0.25))),
        "along_a_face": moving_record(
            record(PARALLEL, position=away), STARTS_TOUCHING | GRAZES | RESTS, b=motion(velocity=(1, 1, 1))
        ),
        "one_and_the_same": moving_record(record(position=away), MOVES_ALIKE, a=motion((1, 2, 3), (0.5, -1, 2))),
    }


def main():
    meshes = {"of_cells": record(OF_CELLS, position=(0.1, -0.05, 0.2))}
    for folder, files in (("pairs", seeds()), ("meshes", meshes), ("motions", motions())):
        place = HERE / "corpus" / folder
        place.mkdir(parents=True, exist_ok=True)
        for name, data in files.items():
            (place / name).write_bytes(data)


if __name__ == "__main__":
    main()
