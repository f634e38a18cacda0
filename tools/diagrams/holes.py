# SPDX-License-Identifier: Apache-2.0
"""A hole in a composite, cut open: walls, rims and an open end."""

from picture import Picture


def draw():
    picture = Picture(760, 350, "Walls of a hole have normals into the cavity; where a hole ends in a surface, its rim is an edge")
    picture.text(24, 34, "A box with a cylinder hole, cut open", size=16, is_bold=True)
    left, right, top, bottom, wall_left, wall_right, floor = 56, 436, 130, 300, 178, 314, 244
    solid = [(left, top), (wall_left, top), (wall_left, floor), (wall_right, floor), (wall_right, top), (right, top), (right, bottom), (left, bottom)]
    picture.polygon(solid, "a", pale="a", thick=2)
    for x in (wall_left, wall_right):
        picture.lines([(x, top), (x, 66)], "soft", dash="4 4", thick=1.2)
    picture.text((wall_left + wall_right) / 2, 70, "open end", anchor="middle", name="soft")
    picture.rectangle(240, 92, 66, 128, "b", pale="b", thick=2, round_by=2)
    picture.text(273, 164, "b", size=18, anchor="middle", name="b", is_bold=True)
    for begin, end in (((wall_left, 176), (wall_left + 40, 176)), ((230, floor), (230, floor - 40))):
        picture.arrow(begin, end, "mark", thick=2.2)
    picture.arrow((wall_right, 200), (wall_right - 36, 200), "mark", thick=2.2)
    for x in (wall_left, wall_right):
        picture.dot((x, top), "bad", 6)
    picture.text(110, 220, "a: solid", size=15, anchor="middle", name="a", is_bold=True)
    picture.text(375, 220, "a: solid", size=15, anchor="middle", name="a", is_bold=True)

    notes = (("mark", "wall", "stops what is inside, normal into the cavity"), ("bad", "rim", "is found as an edge of the solid"),
             ("soft", "open end", "has no wall; the hole goes on beyond it"), ("a", "material", "a wall holds only where material is behind it"))
    for i, (name, word, meaning) in enumerate(notes):
        y = 96 + 56 * i
        picture.dot((468, y - 4), name, 6)
        picture.text(484, y, word, size=14, is_bold=True, name=name if name != "soft" else "ink")
        picture.text(484, y + 19, meaning, size=12)
    return picture
