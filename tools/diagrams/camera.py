# SPDX-License-Identifier: Apache-2.0
"""The camera of a picker, from the side and as a picture."""

from picture import Picture, turned


def _draw_side(picture):
    picture.text(24, 34, "From the side", size=16, is_bold=True)
    eye, half = (58, 190), 24
    picture.polygon([eye, turned((330, 0), half, eye), turned((330, 0), -half, eye)], pale="soft")
    for angle in (-half, 0, half):
        picture.lines([eye, turned((330, 0), angle, eye)], "soft", thick=1.2, dash="" if angle else "5 4")
    picture.arc(eye, 92, -half, half, "good", thick=2.5)
    picture.arc(eye, 300, -half, half, "good", thick=2.5)
    picture.text(104, 258, "near_distance", size=12, anchor="middle", name="good", is_code=True)
    picture.text(338, 338, "far_distance", size=12, anchor="middle", name="good", is_code=True)
    picture.arc(eye, 178, -half, half, "b", thick=2)
    picture.text(246, 164, "vertical_fov", size=12, name="b", is_code=True)
    picture.arrow(eye, (58, 118), "a", thick=2.2)
    picture.text(58, 106, "+Y", anchor="middle", name="a", is_bold=True)
    picture.arrow(eye, (128, 190), "a", thick=2.2)
    picture.text(112, 208, "-Z", name="a", is_bold=True)
    picture.dot(eye, "a", 5)
    picture.text(48, 214, "pose", anchor="middle", name="a", is_bold=True)
    picture.text(24, 300, "Near and far are measured", size=12, name="soft")
    picture.text(24, 317, "along each ray.", size=12, name="soft")


def _draw_picture(picture):
    left, top, side, columns, rows = 456, 96, 34, 8, 5
    right, bottom = left + side * columns, top + side * rows
    picture.text(430, 34, "The picture, in pixels", size=16, is_bold=True)
    picture.rectangle(left, top, side * columns, side * rows, "ink", pale="soft")
    for column in range(1, columns):
        picture.lines([(left + column * side, top), (left + column * side, bottom)], "soft", thick=0.6)
    for row in range(1, rows):
        picture.lines([(left, top + row * side), (right, top + row * side)], "soft", thick=0.6)
    picture.arrow((left, top - 14), (left + 110, top - 14), "a", thick=2)
    picture.text(left + 118, top - 10, "x", name="a", is_bold=True)
    picture.arrow((left - 14, top), (left - 14, top + 96), "a", thick=2)
    picture.text(left - 14, top + 114, "y", anchor="middle", name="a", is_bold=True)
    picture.dot((left, top), "ink", 4)
    picture.text(left - 4, top - 22, "(0, 0)", size=12, anchor="end")
    picture.dot((left + side / 2, top + side / 2), "b", 4)
    picture.text(left + side + 4, top + 22, "(0.5, 0.5)", size=12, name="b", is_bold=True)
    mouse = (left + 5.3 * side, top + 3.2 * side)
    picture.circle(mouse, 40, "mark", pale="mark", opacity=0.8)
    picture.dot(mouse, "mark", 4)
    picture.arrow(mouse, turned((40, 0), 35, mouse), "mark", head=7)
    picture.text(mouse[0] - 6, mouse[1] + 20, "radius", size=12, anchor="middle", name="mark", is_code=True)
    picture.text(right, bottom + 22, "(width, height)", size=12, anchor="end")
    picture.dot((right, bottom), "ink", 4)
    picture.text(430, 317, "pick_pixel looks within the radius around (x, y).", size=12, name="soft")


def draw():
    picture = Picture(760, 350, "The camera looks along its local -Z with +Y up; x runs to the right and y down")
    _draw_side(picture)
    picture.lines([(410, 20), (410, 330)], "soft", thick=0.8)
    _draw_picture(picture)
    return picture
