# SPDX-License-Identifier: Apache-2.0
"""A step of a universe: five stages, and what one hands to the next."""

from picture import Picture

STAGES = (
    ("Refresh", ("what moved gets", "a new box"), "boxes"),
    ("Broad phase", ("which boxes", "overlap"), "pairs"),
    ("Pairs", ("filters; what a", "pair remembers"), "pairs to look at"),
    ("Narrow phase", ("where shapes", "touch; reduction"), "manifolds"),
    ("Lists", ("in the order", "of the slots"), "contacts, events"),
)


def draw():
    picture = Picture(760, 200, "A step: refresh, broad phase, pairs, narrow phase, and the lists of contacts and events")
    width, gap, top = 122, 22, 56
    picture.text(24, 34, "abut_universe_step", size=15, is_code=True)
    for i, (word, lines, out) in enumerate(STAGES):
        x = 24 + i * (width + gap)
        name = "b" if word == "Narrow phase" else "a"
        picture.rectangle(x, top, width, 84, name, pale=name, round_by=6)
        picture.text(x + width / 2, top + 26, word, size=15, anchor="middle", name=name, is_bold=True)
        picture.paragraph(x + width / 2, top + 49, lines, size=12, anchor="middle", step=16)
        if i + 1 < len(STAGES):
            picture.arrow((x + width + 3, top + 42), (x + width + gap - 3, top + 42), "ink", thick=2)
        picture.text(x + width / 2, top + 106, out, size=12, anchor="middle", name="soft")
    picture.text(24, 186, "Pairs of which nothing has moved or changed keep their contacts.", name="soft", size=12)
    return picture
