# SPDX-License-Identifier: Apache-2.0
"""Numbers and failures in words."""

import math

FAILURES = {"ended": ("E", "the process ended, or no answer came within 20 s"), "none": ("N", "no answer"),
            "not_finite": ("F", "no finite number"), "wrong_side": ("S", "apart for overlapping, or the other way round")}


def error(value):
    """An error with one digit."""
    if value is None:
        return "-"
    if value == 0:
        return "0"
    if not math.isfinite(value):
        return str(value)
    return f"{value:.0e}".replace("e-0", "e-").replace("e+0", "e").replace("e+", "e").replace("e0", "")


def time(value):
    """Nanoseconds with three digits."""
    if not value:
        return "-"
    for unit, size in (("s", 1e9), ("ms", 1e6), ("µs", 1e3)):
        if value >= size:
            return f"{value / size:.3g} {unit}"
    return f"{value:.3g} ns"


def size(value):
    return f"{value / 1e6:.1f} MB" if value >= 1e7 else f"{value / 1e3:,.0f} kB"


def failed(row):
    return sum(row["failures"].values())


def failures(row):
    """Such as "3 E, 1 S"; a dash where there are none."""
    return ", ".join(f"{row['failures'][name]} {letter}" for name, (letter, _) in FAILURES.items() if row["failures"].get(name)) or "-"
