# SPDX-License-Identifier: Apache-2.0
"""A rectangle of a picture, and the frustum that it is in space."""

from picture import Picture, turned


def _draw_picture(picture):
    picture.text(24, 34, "In the picture", size=16, is_bold=True)
    picture.rectangle(24, 56, 350, 220, "soft", pale="soft", thick=1)
    picture.rectangle(104, 98, 176, 128, "mark", pale="mark", thick=2, dash="6 4")
    picture.dot((104, 98), "mark", 4)
    picture.text(98, 90, "(x0, y0)", size=12, anchor="end", name="mark", is_bold=True)
    picture.dot((280, 226), "mark", 4)
    picture.text(286, 246, "(x1, y1)", size=12, name="mark", is_bold=True)
    picture.circle((158, 150), 32, "good", pale="good", thick=2)
    picture.text(158, 154, "inside", size=12, anchor="middle", name="good", is_bold=True)
    picture.polygon([(238, 140), (344, 120), (356, 186), (252, 206)], "b", pale="b", thick=2)
    picture.text(300, 168, "touching", size=12, anchor="middle", name="b", is_bold=True)
    # Its box in the picture covers the corner of the rectangle; the bar itself does not.
    picture.polygon([(40, 212), (52, 202), (124, 256), (112, 266)], "soft", pale="soft", thick=2)
    picture.rectangle(40, 202, 84, 64, "soft", thick=0.8, dash="3 3")
    picture.text(34, 294, "Only its box reaches the rectangle: not selected.", size=12, name="soft")


def _draw_space(picture):
    picture.text(430, 34, "In space, from above", size=16, is_bold=True)
    eye, half = (452, 166), 19
    near, far = 62, 282
    corners = [turned((near, 0), half, eye), turned((far, 0), half, eye), turned((far, 0), -half, eye),
               turned((near, 0), -half, eye)]
    # Planes, not spheres: both ends are straight.
    picture.polygon(corners, "mark", pale="mark", thick=2, dash="6 4")
    for angle in (-half, half):
        picture.lines([eye, turned((near, 0), angle, eye)], "soft", thick=1.2)
    picture.dot(eye, "a", 5)
    picture.text(452, 192, "pose", size=12, anchor="middle", name="a", is_bold=True)
    picture.text(506, 132, "near", size=12, anchor="middle", name="mark")
    picture.text(718, 58, "far", size=12, anchor="middle", name="mark")
    picture.circle((602, 150), 24, "good", pale="good", thick=2)
    picture.polygon([(640, 208), (712, 236), (702, 268), (630, 240)], "b", pale="b", thick=2)
    picture.circle((684, 140), 17, "good", pale="good", thick=2)
    picture.text(430, 294, "Hidden geometries count as well.", size=12, name="soft")


def draw():
    picture = Picture(760, 316, "What touches a rectangle of a picture, and what lies inside of it")
    _draw_picture(picture)
    picture.lines([(404, 20), (404, 296)], "soft", thick=0.8)
    _draw_space(picture)
    return picture
