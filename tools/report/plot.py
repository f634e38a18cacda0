#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws what `abut run --motion` wrote: energy, the deepest overlap and the worst residual over time.

usage: plot.py MOTION PICTURE
MOTION is CSV or JSON; PICTURE ends in .png, .svg or .pdf. Needs Matplotlib.
Exit status 0: drawn; 2: MOTION is no such file, or PICTURE has another ending.
"""

import csv
import json
import pathlib
import sys

NEEDED = ("time", "kinetic", "potential", "deepest", "residual")
ENDINGS = (".png", ".svg", ".pdf")


class Wrong(Exception):
    """A sentence about what was given."""


def rows_of(path):
    try:
        text = path.read_text(encoding="utf-8")
        rows = json.loads(text) if path.suffix == ".json" else list(csv.DictReader(text.splitlines()))
        columns = {name: [float(row[name]) for row in rows] for name in NEEDED}
    except OSError as error:
        raise Wrong(f"{path} cannot be read: {error.strerror}") from error
    except (KeyError, TypeError, ValueError) as error:
        raise Wrong(f"{path} is not what abut run --motion writes: {error}") from error
    if not rows:
        raise Wrong(f"{path} has no steps")
    return columns


def draw(its, picture):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(3, 1, sharex=True, figsize=(8, 7), layout="constrained")
    whole = [kinetic + potential for kinetic, potential in zip(its["kinetic"], its["potential"])]
    for values, name in ((whole, "all"), (its["kinetic"], "kinetic"), (its["potential"], "potential")):
        axes[0].plot(its["time"], values, label=name)
    axes[0].legend(loc="upper right")
    axes[0].set_ylabel("energy")
    for place, name, title in ((axes[1], "deepest", "deepest overlap"), (axes[2], "residual", "worst residual")):
        # Zeros have no logarithm: gaps.
        place.plot(its["time"], [value if value > 0 else float("nan") for value in its[name]])
        if max(its[name]) > 0:
            place.set_yscale("log")
        place.set_ylabel(title)
    axes[2].set_xlabel("time")
    for each in axes:
        each.grid(alpha=0.3)
    figure.savefig(picture, dpi=120)
    pyplot.close(figure)


def main(motion, picture):
    picture = pathlib.Path(picture)
    try:
        if picture.suffix not in ENDINGS:
            raise Wrong(f"the picture is '{picture}'; expected a name that ends in {', '.join(ENDINGS)}")
        columns = rows_of(pathlib.Path(motion))
        try:
            draw(columns, picture)
        except OSError as error:
            raise Wrong(f"{picture} cannot be written: {error.strerror}") from error
    except Wrong as wrong:
        print(f"abut: {wrong}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
