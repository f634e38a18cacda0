# SPDX-License-Identifier: Apache-2.0
"""What is left of the speed of a ball of 1 kg that bounces on a spring, over its stiffness and the step."""

import json
from pathlib import Path

from picture import Picture

CELL_X, CELL_Y, LEFT, TOP, GAP = 40, 22, 92, 84, 88
STIFFNESSES, STEPS = range(2, 13), [-5 + j / 2 for j in range(9)]  # powers of ten
TITLES = {"implicit": "ABUT_INTEGRATOR_IMPLICIT", "midpoint": "ABUT_INTEGRATOR_MIDPOINT"}


def _map(picture, top, name, rows):
    picture.text(LEFT, top - 10, TITLES[name], is_bold=True)
    for row, (step, speeds) in enumerate(zip(STEPS, rows)):
        y = top + CELL_Y * row
        exponent = f"{step:g}"
        picture.text(LEFT - 8, y + 16, f"1e{exponent} s" if step == int(step) else f"3e{int(step - 0.5)} s", size=12, anchor="end", name="soft")
        for column, speed in enumerate(speeds):
            x = LEFT + CELL_X * column
            picture.rectangle(x, y, CELL_X, CELL_Y, area="a", opacity=max(0.02, 0.45 * abs(speed)))
            picture.text(x + CELL_X / 2, y + 16, f"{abs(speed):.2f}", size=12, anchor="middle")
    # Left of the steps the step is less than the time of the mass on the spring.
    edge = []
    for row, step in enumerate(STEPS):
        x = LEFT + CELL_X * sum(1 for power in STIFFNESSES if step + power / 2 < 0)
        edge += [(x, top + CELL_Y * row), (x, top + CELL_Y * (row + 1))]
    picture.lines(edge, "bad", thick=2)
    bottom = top + CELL_Y * len(STEPS)
    for column, power in enumerate(STIFFNESSES):
        picture.text(LEFT + CELL_X * (column + 0.5), bottom + 17, f"1e{power}", size=12, anchor="middle", name="soft")
    return bottom


def draw():
    maps = json.loads(Path(__file__).with_name("moving.json").read_text(encoding="utf-8"))["springs"]
    height = TOP + 2 * CELL_Y * len(STEPS) + GAP + 28
    picture = Picture(LEFT + CELL_X * len(STIFFNESSES) + 24, height, "The speed that is left by a bounce on a spring, over stiffness and step, by two integrators")
    picture.text(24, 32, "Speed after a bounce on a spring, of 1 m/s; the law says 1", size=16, is_bold=True)
    picture.text(24, 52, "left of the red line the step is less than 1/w, where w is the root of stiffness over mass", size=12, name="bad")
    bottom = _map(picture, TOP, "implicit", maps["implicit"])
    bottom = _map(picture, bottom + GAP - 26, "midpoint", maps["midpoint"])
    picture.text(LEFT + CELL_X * len(STIFFNESSES) / 2, bottom + 38, "stiffness, N/m", anchor="middle")
    return picture
