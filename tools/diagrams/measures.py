# SPDX-License-Identifier: Apache-2.0
"""Which lengths shapes are made of: half heights, half extents and radii."""

from picture import Picture

MIDDLE = 176


def _title(picture, x, name):
    picture.text(x, 44, name, size=15, anchor="middle", is_bold=True)


def _axis(picture, x, top=66, bottom=286):
    picture.arrow((x, bottom), (x, top), "soft", dash="8 3 2 3", thick=1.2)
    picture.text(x + 8, top + 8, "z", name="soft", is_bold=True)
    picture.dot((x, MIDDLE), "ink", 3.5)


def _height(picture, x, edge, length, text, text_at):
    """Half a length, from the middle up, beside a shape."""
    for y in (MIDDLE, MIDDLE - length):
        picture.lines([(edge, y), (x + 6, y)], "soft", thick=0.8, dash="3 3")
    picture.measure((x, MIDDLE), (x, MIDDLE - length), "mark")
    picture.text(text_at, MIDDLE + 18, text, name="mark", size=12, is_code=True)


def _radius(picture, x, y, radius):
    picture.measure((x, y), (x + radius, y), "b")
    picture.text(x + radius / 2 + 1, y - 7, "radius", anchor="middle", name="b", size=12, is_code=True)


def _draw_capsule(picture, x):
    radius, half = 50, 50
    _title(picture, x, "capsule")
    data = f"M{x - radius},{MIDDLE - half} a{radius},{radius} 0 0 1 {2 * radius},0 v{2 * half} a{radius},{radius} 0 0 1 {-2 * radius},0 z"
    picture.path(data, "a", pale="a")
    picture.lines([(x, MIDDLE - half), (x, MIDDLE + half)], "a", thick=4)
    _axis(picture, x)
    _radius(picture, x, MIDDLE + half, radius)
    _height(picture, x + radius + 26, x, half, "half_height", x + radius + 6)


def _rim(picture, x, y, radius):
    picture.ellipse((x, y), radius, 13, "a", pale="a")


def _draw_cylinder(picture, x):
    radius, half = 52, 74
    _title(picture, x, "cylinder")
    data = f"M{x - radius},{MIDDLE - half} v{2 * half} a{radius},13 0 0 0 {2 * radius},0 v{-2 * half} z"
    picture.path(data, "a", pale="a")
    _rim(picture, x, MIDDLE - half, radius)
    _axis(picture, x)
    _radius(picture, x, MIDDLE + half, radius)
    _height(picture, x + radius + 26, x, half, "half_height", x + radius + 6)


def _draw_cone(picture, x):
    radius, half = 54, 74
    _title(picture, x, "cone")
    data = f"M{x - radius},{MIDDLE + half} L{x},{MIDDLE - half} L{x + radius},{MIDDLE + half} a{radius},13 0 0 1 {-2 * radius},0 z"
    picture.path(data, "a", pale="a")
    _axis(picture, x)
    _radius(picture, x, MIDDLE + half, radius)
    _height(picture, x + radius + 20, x, half, "half_height", x + radius - 18)


def _draw_box(picture, x):
    width, height, lean = 48, 60, (22, -18)
    _title(picture, x, "box")
    left, right, top, bottom = x - width - 11, x + width - 11, MIDDLE - height + 9, MIDDLE + height + 9
    picture.polygon([(left, top), (left + lean[0], top + lean[1]), (right + lean[0], top + lean[1]), (right, top)], "a", pale="a")
    picture.polygon([(right, top), (right + lean[0], top + lean[1]), (right + lean[0], bottom + lean[1]), (right, bottom)], "a", pale="a")
    picture.rectangle(left, top, right - left, bottom - top, "a", pale="a")
    _axis(picture, x)
    picture.measure((x, bottom + 14), (right, bottom + 14), "b")
    picture.text(right + 8, bottom + 18, "half_x", name="b", size=12, is_code=True)
    _height(picture, x + width + 42, x, height + 9, "half_z", x + 60)


def draw():
    picture = Picture(760, 350, "Heights and extents are halves, measured from the origin; axes lie along local Z")
    _draw_capsule(picture, 70)
    _draw_cylinder(picture, 262)
    _draw_cone(picture, 452)
    _draw_box(picture, 640)
    picture.text(380, 316, "Axes lie along local z, and the origin is in the middle. Heights and extents are halves.", anchor="middle")
    picture.text(380, 336, "The half height of a capsule ends where its round ends begin.", anchor="middle")
    return picture
