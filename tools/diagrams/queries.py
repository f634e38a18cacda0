# SPDX-License-Identifier: Apache-2.0
"""Four questions to a universe: along a ray, in the way of a shape, near a shape, closest to a shape."""

from picture import Picture

WIDTH = 184


def _head(picture, left, word, call):
    picture.text(left, 36, word, size=15, is_bold=True)
    picture.text(left, 288, call, size=12, is_code=True, name="mark")


def _draw_ray(picture, left):
    _head(picture, left, "Along a ray", "_cast_ray")
    picture.circle((left + 62, 130), 26, "a", pale="a")
    picture.rectangle(left + 108, 134, 44, 62, "a", pale="a")
    picture.arrow((left, 92), (left + 160, 192), "b", thick=2)
    picture.dot((left, 92), "b", 4)
    near, far = (left + 39.7, 116.8), (left + 108, 159.5)
    for point, number in ((near, "1"), (far, "2")):
        picture.dot(point, "bad", 5.5)
        picture.text(point[0] - 13, point[1] + 16, number, anchor="middle", name="bad", is_bold=True)
    picture.paragraph(left, 236, ("NEAREST: 1. ALL: 1, 2.", "ANY: one of them."), size=12)


def _draw_cast(picture, left):
    _head(picture, left, "In the way", "_cast_shape")
    picture.rectangle(left + 112, 84, 34, 112, "a", pale="a")
    for x, dash in ((22, ""), (90, "4 3")):
        picture.circle((left + x, 140), 22, "b", pale="b" if not dash else None, dash=dash)
    picture.circle((left + 156, 140), 22, "soft", dash="2 4", thick=1)
    picture.arrow((left + 22, 140), (left + 154, 140), "b", head=8)
    picture.dot((left + 112, 140), "bad", 5.5)
    for x in (22, 90, 156):
        picture.lines([(left + x, 166), (left + x, 214)], "soft", thick=0.8, dash="3 3")
    picture.measure((left + 22, 204), (left + 90, 204), "bad")
    picture.text(left + 56, 222, "fraction", size=12, anchor="middle", name="bad", is_code=True)
    picture.paragraph(left, 246, ("The share of the way", "until the first touch."), size=12)


def _draw_overlap(picture, left):
    _head(picture, left, "Near a shape", "_overlaps")
    centre = (left + 78, 140)
    picture.circle(centre, 58, "b", dash="5 4", thick=1.2)
    picture.circle(centre, 30, "b", pale="b")
    picture.rectangle(left + 96, 86, 36, 40, "good", pale="good")
    picture.rectangle(left + 2, 150, 40, 36, "good", pale="good")
    picture.rectangle(left + 134, 184, 24, 24, "soft", pale="soft")
    picture.measure((left + 78, 110), (left + 78, 82), "b")
    picture.text(left + 28, 76, "margin", size=12, name="b", is_code=True)
    picture.paragraph(left, 236, ("What touches it, or lies", "within the margin."), size=12)


def _draw_closest(picture, left):
    _head(picture, left, "Closest", "_closest")
    picture.circle((left + 30, 140), 26, "b", pale="b")
    picture.rectangle(left + 112, 120, 40, 40, "good", pale="good")
    picture.rectangle(left + 84, 186, 36, 26, "soft", pale="soft")
    picture.rectangle(left + 98, 72, 30, 26, "soft", pale="soft")
    picture.measure((left + 56, 140), (left + 112, 140), "bad")
    picture.dot((left + 56, 140), "b", 4)
    picture.dot((left + 112, 140), "good", 4)
    picture.text(left + 81, 162, "distance", size=12, anchor="middle", name="bad", is_code=True)
    picture.paragraph(left, 236, ("One geometry, its points", "and the signed distance."), size=12)


def draw():
    picture = Picture(760, 306, "A ray meets geometries in order; a cast stops at a fraction; overlaps lie within a margin; one is closest")
    for i, panel in enumerate((_draw_ray, _draw_cast, _draw_overlap, _draw_closest)):
        left = 22 + WIDTH * i
        panel(picture, left)
        if i:
            picture.lines([(left - 14, 20), (left - 14, 288)], "soft", thick=0.6)
    return picture
