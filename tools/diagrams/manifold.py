# SPDX-License-Identifier: Apache-2.0
"""A manifold: the region that two faces share, its corners, and the few that are kept."""

import math

from picture import Picture, turned


def _corners_of_both(centre, half):
    """A square and the same square turned by 45 degrees share a regular octagon."""
    radius = half / math.cos(math.radians(22.5))
    return [turned((radius, 0), 22.5 + 45 * i, centre) for i in range(8)]


def _square(centre, half, angle):
    return [turned((half * x, half * y), angle, centre) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def _draw_faces(picture, centre, kept):
    picture.polygon(_square(centre, 70, 0), "a", pale="a")
    picture.polygon(_square(centre, 70, 45), "b", pale="b", opacity=0.7)
    corners = _corners_of_both(centre, 70)
    picture.polygon(corners, "mark", pale="mark", thick=1.2)
    for i, corner in enumerate(corners):
        if kept is None or i in kept:
            picture.dot(corner, "bad" if kept and i == kept[0] else "mark", 6.5 if kept and i == kept[0] else 5)
        else:
            picture.circle(corner, 3.5, "soft", thick=1.2)


def _draw_side(picture):
    left, right, ground = 278, 480, 214
    picture.rectangle(left, ground, right - left, 40, "a", pale="a")
    body = [turned(corner, 7, (382, 166)) for corner in ((-68, -52), (68, -52), (68, 52), (-68, 52))]
    picture.polygon(body, "b", pale="b", opacity=0.75)
    picture.text(362, 160, "b", size=18, name="b", is_bold=True)
    picture.text(458, 242, "a", size=18, name="a", is_bold=True)
    corner = body[3]
    picture.arrow((corner[0], ground), (corner[0], ground - 52), "mark", thick=2.2)
    picture.text(corner[0] - 6, ground - 58, "normal", anchor="middle", name="mark", is_bold=True)
    picture.dot((corner[0], ground), "a", 4.5)
    picture.dot(corner, "b", 4.5)
    picture.text(corner[0] - 7, ground - 6, "point_a", size=12, anchor="end", name="a", is_code=True)
    picture.text(corner[0] + 2, ground + 58, "point_b", size=12, anchor="middle", name="b", is_code=True)


def draw():
    picture = Picture(760, 350, "Two faces share a region; its corners are contacts, of which a reduction keeps a few")
    heads = (("1  Clip", "Two faces share a region."), ("2  Lift", "Each corner has two points."), ("3  Reduce", "Few points hold as all do."))
    for x, (word, text) in zip((24, 278, 532), heads):
        picture.text(x, 34, word, size=16, is_bold=True)
        picture.text(x, 56, text, name="soft")
    _draw_faces(picture, (124, 180), None)
    _draw_side(picture)
    _draw_faces(picture, (634, 180), (1, 3, 5, 7))
    picture.paragraph(24, 312, ("Its corners are contacts:", "eight here."))
    picture.paragraph(278, 312, ("point_b == point_a", "  + distance * normal"), is_code=True)
    picture.paragraph(532, 312, ("The deepest stays, with those", "that span the largest area."))
    return picture
