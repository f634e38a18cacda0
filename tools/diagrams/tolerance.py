# SPDX-License-Identifier: Apache-2.0
"""Tolerance modes: for which distances a universe reports a contact."""

from picture import Picture

LEFT, ZERO, RIGHT, STEP = 190, 450, 730, 130


def _pair(picture, x, gap):
    picture.circle((x - 21 - gap / 2, 92), 21, "a", pale="a")
    picture.circle((x + 21 + gap / 2, 92), 21, "b", pale="b", opacity=0.8)


def _row(picture, y, name, note, limit):
    picture.text(24, y + 14, name, is_code=True, size=12)
    picture.text(24, y + 33, note, size=12, name="soft")
    picture.rectangle(LEFT, y, limit - LEFT, 40, "good", pale="good", round_by=4)
    picture.rectangle(limit, y, RIGHT - limit, 40, "soft", pale="soft", round_by=4)
    picture.text((LEFT + limit) / 2, y + 25, "contact", anchor="middle", name="good", is_bold=True)
    picture.text((limit + RIGHT) / 2, y + 25, "none", anchor="middle", name="soft", is_bold=True)


def draw():
    picture = Picture(760, 350, "The dead band ignores small overlaps; the margin reports small gaps")
    picture.text(24, 34, "What the tolerance of a pair means", size=16, is_bold=True)
    for x, gap, text in ((LEFT + 46, -30, "deep"), (ZERO - STEP, -12, "just overlapping"), (ZERO, 0, "touching"),
                         (ZERO + STEP, 12, "near"), (686, 30, "apart")):
        _pair(picture, x, gap)
        picture.text(x, 134, text, size=12, anchor="middle", name="soft")
    picture.arrow((LEFT, 160), (RIGHT, 160))
    picture.text(176, 164, "distance", anchor="end", is_bold=True)
    for x, text in ((ZERO - STEP, "-tolerance"), (ZERO, "0"), (ZERO + STEP, "+tolerance")):
        picture.lines([(x, 153), (x, 316)], "soft", dash="3 3", thick=1)
        picture.text(x, 334, text, anchor="middle", is_bold=True)
    _row(picture, 182, "DEAD_BAND", "default: rest is quiet", ZERO - STEP)
    _row(picture, 250, "MARGIN", "contacts come early", ZERO + STEP)
    return picture
