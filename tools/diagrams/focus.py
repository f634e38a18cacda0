# SPDX-License-Identifier: Apache-2.0
"""A focus: geometries near a centre get one tag, those far away another, and in between they keep theirs."""

from picture import Picture, turned


def _body(picture, centre, name, angle):
    corners = ((-13, -13), (13, -13), (13, 13), (-13, 13))
    picture.polygon([turned(corner, angle, centre) for corner in corners], name, pale=name, thick=2)


def _draw_circles(picture):
    centre = (196, 194)
    picture.circle(centre, 132, "soft", pale="soft", dash="5 4")
    picture.circle(centre, 74, "a", pale="a")
    picture.dot(centre, "ink", 5)
    picture.text(centre[0], centre[1] - 12, "centre", size=12, anchor="middle")
    for point, name, angle in (((150, 206), "a", 10), ((234, 168), "a", 30), ((196, 90), "a", 0), ((106, 246), "b", 20), ((346, 92), "b", 15), ((42, 92), "b", 40)):
        _body(picture, point, name, angle)
    edge = turned((74, 0), -40, centre)
    picture.measure(centre, edge, "a")
    picture.text(262, 256, "near", size=12, name="a", is_bold=True)
    picture.measure(centre, turned((132, 0), -75, centre), "ink")
    picture.text(232, 292, "far", size=12, is_bold=True)


def _draw_rule(picture):
    rows = (("a", "nearer than near_distance", "gets near_tag"), ("soft", "in between", "keeps the tag that it has"), ("b", "farther than far_distance", "gets far_tag"))
    for i, (name, where, what) in enumerate(rows):
        y = 84 + 66 * i
        picture.rectangle(410, y, 326, 52, name, pale=name, round_by=6)
        picture.text(426, y + 21, where, is_bold=True, name=name if name != "soft" else "ink")
        picture.text(426, y + 40, what)
    picture.paragraph(410, 300, ("A centre that trembles at a border", "flips nothing."), name="soft")


def draw():
    picture = Picture(760, 346, "Near a centre a geometry gets one tag, far from all centres another, and in between it keeps its own")
    picture.text(24, 34, "A focus changes two tags by distance", size=16, is_bold=True)
    _draw_circles(picture)
    _draw_rule(picture)
    return picture
