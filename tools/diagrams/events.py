# SPDX-License-Identifier: Apache-2.0
"""Events: a touch of two geometries from step to step, and the ages of its contacts."""

from picture import Picture, turned

LEFT, STEP = 150, 84
NAMES = {"begin": "good", "persist": "a", "end": "bad"}
# Of each step: how far b is above a, how far it leans, the event of the pair, the ages of its two contacts.
STEPS = (
    (34, 0, None, ()),
    (0, 12, "begin", (0,)),
    (0, 6, "persist", (1,)),
    (0, 0, "persist", (2, 0)),
    (0, 0, "persist", (3, 1)),
    (0, -12, "persist", (None, 2)),
    (36, 0, "end", ()),
)


def _scene(picture, x, lift, lean):
    picture.rectangle(x - 32, 128, 64, 16, "a", pale="a")
    pivot = (x - 20 if lean >= 0 else x + 20, 128 - lift)
    corners = [(x - 20, 128 - lift), (x + 20, 128 - lift), (x + 20, 100 - lift), (x - 20, 100 - lift)]
    picture.polygon([turned((cx - pivot[0], cy - pivot[1]), lean, pivot) for cx, cy in corners], "b", pale="b")


def draw():
    picture = Picture(760, 316, "A touch is one begin, a persist in each step, and one end; contacts age by one in each step")
    picture.text(24, 34, "One touch, step by step", size=16, is_bold=True)
    for y, word in ((192, "event of the pair"), (236, "age of contact 1"), (272, "age of contact 2")):
        picture.text(24, y, word)
    for i, (lift, lean, event, ages) in enumerate(STEPS):
        x = LEFT + STEP // 2 + STEP * i
        _scene(picture, x, lift, lean)
        picture.text(x, 164, f"step {i + 1}", size=12, anchor="middle", name="soft")
        if event:
            picture.rectangle(x - 36, 176, 72, 24, NAMES[event], pale=NAMES[event], round_by=5)
            picture.text(x, 193, event, anchor="middle", name=NAMES[event], is_bold=True)
        for row, age in enumerate(ages):
            if age is not None:
                picture.circle((x, 232 + 36 * row), 13, "mark", pale="mark")
                picture.text(x, 237 + 36 * row, str(age), anchor="middle", name="mark", is_bold=True)
    picture.text(24, 303, "A contact keeps its id, its age and your data while the same features touch.", size=12, name="soft")
    return picture
