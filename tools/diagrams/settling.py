# SPDX-License-Identifier: Apache-2.0
"""Twelve boxes and balls that fall on each other: energy, the deepest overlap and the worst residual over time."""

import json
import math
from pathlib import Path

from picture import Picture

LEFT, RIGHT, TOP, HEIGHT, GAP = 92, 716, 76, 120, 46
SECONDS = 6


def _x(time):
    return LEFT + (RIGHT - LEFT) * time / SECONDS


class _Panel:
    def __init__(self, picture, number, title, low, high, is_log):
        self.picture, self.low, self.high, self.is_log = picture, low, high, is_log
        self.top = TOP + number * (HEIGHT + GAP)
        picture.text(LEFT, self.top - 10, title, is_bold=True)
        picture.rectangle(LEFT, self.top, RIGHT - LEFT, HEIGHT, "soft", thick=0.8)

    def y(self, value):
        if self.is_log:
            part = math.log(max(value, self.low) / self.low) / math.log(self.high / self.low)
        else:
            part = (value - self.low) / (self.high - self.low)
        return self.top + HEIGHT * (1 - min(1.0, max(0.0, part)))

    def mark(self, value, text):
        self.picture.lines([(LEFT, self.y(value)), (RIGHT, self.y(value))], "soft", thick=0.6, dash="3 3")
        self.picture.text(LEFT - 8, self.y(value) + 4, text, size=12, anchor="end", name="soft")

    def curve(self, rows, value, name):
        self.picture.lines([(_x(row[0]), self.y(value(row))) for row in rows], name, thick=1.8)


def draw():
    rows = json.loads(Path(__file__).with_name("moving.json").read_text(encoding="utf-8"))["settling"]
    bottom = TOP + 3 * HEIGHT + 2 * GAP
    picture = Picture(740, bottom + 50, "Energy, overlap and residual of twelve bodies that fall on each other")
    picture.text(24, 32, "Twelve boxes and balls fall on each other", size=16, is_bold=True)
    whole = max(row[1] + row[2] for row in rows)
    energy = _Panel(picture, 0, "energy, part of that at the start", 0, 1.05, False)
    energy.mark(1, "1")
    energy.mark(0.5, "0.5")
    energy.mark(0, "0")
    energy.curve(rows, lambda row: (row[1] + row[2]) / whole, "a")
    energy.curve(rows, lambda row: row[1] / whole, "b")
    picture.text(RIGHT - 70, energy.top - 10, "all", anchor="end", name="a", is_bold=True)
    picture.text(RIGHT, energy.top - 10, "kinetic", anchor="end", name="b", is_bold=True)
    depth = _Panel(picture, 1, "deepest overlap, m", 1e-6, 1, True)
    for power in (-5, -3, -1):
        depth.mark(10.0**power, f"1e{power}")
    depth.curve(rows, lambda row: row[3], "mark")
    residual = _Panel(picture, 2, "worst residual of an island, m/s", 1e-16, 1e-3, True)
    for power in (-15, -12, -9, -6):
        residual.mark(10.0**power, f"1e{power}")
    residual.curve(rows, lambda row: row[4], "good")
    for time in range(SECONDS + 1):
        picture.text(_x(time), bottom + 18, f"{time} s", size=12, anchor="middle", name="soft")
    return picture
