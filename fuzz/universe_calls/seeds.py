#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the committed corpus: random sequences of calls, as random_sequence of call.cpp makes them.

usage: fuzz/universe_calls/seeds.py
"""
from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent / "corpus" / "universe"
CALL_SIZE = 16
MASK = 2**64 - 1
# Of many, some that reach contacts, events, filters and refusals in few calls.
SEEDS = (124, 129, 709, 789, 807, 913, 923, 966, 1105, 1148, 1182, 1352, 2878, 2905, 3224, 3367, 3401, 3533, 3953, 4126, 5528, 5613, 5942, 5988)
CALLS = 80


def random_bytes(seed, count):
    """SplitMix64, the low byte of each number."""
    state = seed
    for _ in range(count):
        state = (state + 0x9E3779B97F4A7C15) & MASK
        z = ((state ^ (state >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        yield (z ^ (z >> 31)) & 0xFF


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for seed in SEEDS:
        (FOLDER / f"random_{seed}").write_bytes(bytes(random_bytes(seed, (CALLS + 1) * CALL_SIZE)))


if __name__ == "__main__":
    main()
