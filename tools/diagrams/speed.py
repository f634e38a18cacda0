# SPDX-License-Identifier: Apache-2.0
"""How long other libraries take beside abut: the first table of docs/benchmarks.md on a logarithmic scale."""

import math

from picture import Picture
from tables import table_under

LEFT, RIGHT, TOP, STEP = 278, 716, 108, 33
LEAST, MOST = 0.1, 100
PEERS = (("Bullet", "b"), ("FCL", "mark"), ("ODE", "good"))


def _x(ratio):
    return LEFT + (RIGHT - LEFT) * math.log(ratio / LEAST) / math.log(MOST / LEAST)


def _mark(picture, x, y, name, does_other_work):
    if does_other_work:
        picture.circle((x, y), 5.5, name, thick=2)
    else:
        picture.dot((x, y), name, 6)


def _legend(picture):
    x = 24
    for peer, name in PEERS:
        _mark(picture, x + 6, 58, name, False)
        picture.text(x + 18, 62, peer, name=name, is_bold=True)
        x += 82
    _mark(picture, 300, 58, "soft", True)
    picture.text(312, 62, "open: another answer, or fewer contacts", name="soft")


def _scale(picture, bottom):
    picture.rectangle(LEFT, TOP - 20, _x(1) - LEFT, bottom - TOP + 20, pale="bad", opacity=0.55)
    for ratio, text in ((1, "as long as abut"), (10, "10 times"), (100, "100 times")):
        picture.lines([(_x(ratio), TOP - 20), (_x(ratio), bottom)], "soft", thick=1.6 if ratio == 1 else 0.8, dash="" if ratio == 1 else "3 3")
        picture.text(_x(ratio), bottom + 18, text, size=12, anchor="middle", name="soft", is_bold=ratio == 1)
    picture.text(_x(1) - 8, TOP - 26, "faster", size=12, anchor="end", name="bad")
    picture.text(_x(1) + 8, TOP - 26, "slower than abut", size=12, name="soft")


def draw():
    rows = table_under("benchmarks.md", "# Benchmarks")
    names = rows[0]
    bottom = TOP + STEP * (len(rows) - 1)
    picture = Picture(760, bottom + 34, "Times of Bullet, FCL and ODE as multiples of the time of abut")
    picture.text(24, 34, "How long others take, abut = 1", size=16, is_bold=True)
    _legend(picture)
    _scale(picture, bottom)
    for i, row in enumerate(rows[1:]):
        y = TOP + STEP * i
        picture.text(24, y + 5, row[0])
        picture.lines([(LEFT, y), (RIGHT, y)], "soft", thick=0.5)
        own = float(row[names.index("abut")].replace(",", ""))
        for peer, name in PEERS:
            cell = row[names.index(peer)]
            if cell != "-":
                _mark(picture, _x(float(cell.strip("*").replace(",", "")) / own), y, name, cell.endswith("*"))
    return picture
