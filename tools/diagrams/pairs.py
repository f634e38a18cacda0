# SPDX-License-Identifier: Apache-2.0
"""Which search answers which pair: the table of docs/pairs.md, as the library prints it, in colours."""

from picture import Picture
from tables import table_under

COLOURS = {"🟢": "good", "🔵": "a", "🟡": "gold", "🟠": "b", "🟣": "mark"}
LEGEND = (("good", "F, S", "exact by a formula"), ("a", "A, B, H", "proven to rounding"), ("gold", "R", "proven within 1e-9"),
          ("b", "D, E, P, T", "within an interval"), ("mark", "C, W", "as its children or walls"), (None, "", "no answer"))
LEFT, TOP, SIDE = 126, 200, 30


def _cell(picture, x, y, sign):
    colour, _, letter = sign.partition(" ")
    if colour in COLOURS:
        picture.rectangle(x + 1, y + 1, SIDE - 2, SIDE - 2, pale=COLOURS[colour], round_by=4)
        picture.text(x + SIDE / 2, y + SIDE / 2 + 5, letter, size=14, anchor="middle", name=COLOURS[colour], is_bold=True)
    else:
        picture.rectangle(x + 1, y + 1, SIDE - 2, SIDE - 2, pale="soft", round_by=4)


def _legend(picture):
    for i, (name, letters, meaning) in enumerate(LEGEND):
        x, y = 24 + 246 * (i % 3), 52 + 30 * (i // 3)
        picture.rectangle(x, y, 78, 22, pale=name or "soft", round_by=4)
        if letters:
            picture.text(x + 39, y + 16, letters, anchor="middle", name=name, is_bold=True)
        picture.text(x + 86, y + 16, meaning)


def draw():
    rows = table_under("pairs.md", "## The table")
    kinds = rows[0][1:]
    bottom = TOP + SIDE * len(kinds)
    picture = Picture(760, bottom + 44, "Which search answers each pair of kinds, and how sure the answer is")
    picture.text(24, 34, "Which kinds collide, and how exactly", size=16, is_bold=True)
    _legend(picture)
    for i, kind in enumerate(kinds):
        picture.text(LEFT - 8, TOP + SIDE * i + 21, kind, anchor="end")
        picture.text(LEFT + SIDE * i + 21, TOP - 6, kind, size=12, is_upward=True)
        for j, sign in enumerate(rows[1 + i][1:]):
            _cell(picture, LEFT + SIDE * j, TOP + SIDE * i, sign)
    picture.text(24, bottom + 26, "+: each ball of particles, each triangle beside a field or a hole.", name="soft")
    return picture
