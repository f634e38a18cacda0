# SPDX-License-Identifier: Apache-2.0
"""Signs: distance, depth, normal and the two points of a contact."""

from picture import Picture


def _pair(picture, a, radius_a, b, radius_b):
    picture.circle(a, radius_a, pale="a")
    picture.circle(b, radius_b, pale="b", opacity=0.85)
    picture.circle(a, radius_a, "a")
    picture.circle(b, radius_b, "b")
    point_a, point_b = (a[0] + radius_a, a[1]), (b[0] - radius_b, b[1])
    return point_a, point_b


def _leader(picture, point, end, text, name):
    picture.lines([point, end], name, thick=1)
    picture.dot(point, name, 4.5)
    picture.text(end[0], end[1] - 6, text, anchor="middle", name=name, is_code=True)


def _draw_apart(picture):
    picture.text(24, 34, "Apart: distance > 0", size=16, is_bold=True)
    point_a, point_b = _pair(picture, (100, 170), 72, (284, 170), 52)
    _leader(picture, point_a, (132, 80), "point_a", "a")
    _leader(picture, point_b, (272, 80), "point_b", "b")
    picture.arrow((177, 170), (225, 170), "mark", thick=2.5)
    picture.text(202, 150, "normal", anchor="middle", name="mark", is_bold=True)
    for x in (point_a[0], point_b[0]):
        picture.lines([(x, 176), (x, 262)], "soft", thick=0.8, dash="3 3")
    picture.measure((point_a[0], 254), (point_b[0], 254))
    picture.text(202, 280, "distance", anchor="middle", is_bold=True)
    picture.text(70, 196, "a", size=18, name="a", is_bold=True)
    picture.text(292, 176, "b", size=18, name="b", is_bold=True)


def _draw_overlap(picture):
    picture.text(404, 34, "Overlapping: distance < 0", size=16, is_bold=True)
    point_a, point_b = _pair(picture, (500, 170), 80, (628, 170), 84)
    _leader(picture, point_b, (512, 80), "point_b", "b")
    _leader(picture, point_a, (612, 80), "point_a", "a")
    picture.arrow((585, 170), (650, 170), "mark", thick=2.5)
    picture.text(622, 158, "normal", anchor="middle", name="mark", is_bold=True)
    for x in (point_a[0], point_b[0]):
        picture.lines([(x, 176), (x, 274)], "soft", thick=0.8, dash="3 3")
    picture.measure((point_b[0], 268), (point_a[0], 268))
    picture.text(592, 280, "depth = -distance", is_bold=True)
    picture.text(460, 176, "a", size=18, name="a", is_bold=True)
    picture.text(664, 220, "b", size=18, name="b", is_bold=True)


def draw():
    picture = Picture(760, 350, "The normal points from a to b; the distance is negative where the shapes overlap")
    _draw_apart(picture)
    picture.lines([(380, 20), (380, 290)], "soft", thick=0.8)
    _draw_overlap(picture)
    picture.text(380, 316, "distance == dot(point_b - point_a, normal)", size=14, anchor="middle", is_code=True)
    picture.text(380, 337, "Moving b along the normal parts the shapes.", anchor="middle", name="soft")
    return picture
