# SPDX-License-Identifier: Apache-2.0
"""Frames: a pose from local to world, and one shape in the frame of the other."""

from picture import Picture, turned


def _axes(picture, origin, length, angle, name, labels):
    for axis, label in ((0, labels[0]), (90, labels[1])):
        picture.arrow(origin, turned((length, 0), angle + axis, origin), name, thick=2)
        place = turned((length + 13, 0), angle + axis, origin)
        picture.text(place[0], place[1] + 4, label, anchor="middle", name=name, is_bold=True)
    picture.dot(origin, name)


def _box(picture, centre, half_x, half_y, angle, name):
    corners = [(-half_x, -half_y), (half_x, -half_y), (half_x, half_y), (-half_x, half_y)]
    picture.polygon([turned(corner, angle, centre) for corner in corners], name, pale=name)


def _draw_pose(picture):
    picture.text(24, 34, "A pose places a shape", size=16, is_bold=True)
    world, local, angle = (60, 288), (228, 168), 24
    _box(picture, local, 104, 60, angle, "a")
    picture.lines([local, (local[0] + 120, local[1])], "soft", dash="4 4", thick=1.2)
    picture.arrow(world, local, "mark", dash="6 4")
    picture.text(118, 226, "position", anchor="end", name="mark", is_bold=True)
    _axes(picture, world, 86, 0, "ink", "xy")
    _axes(picture, local, 62, angle, "a", "xy")
    picture.arc(local, 100, 0, angle, "mark", thick=2)
    picture.text(338, 152, "orientation", name="mark", is_bold=True)
    point = turned((-66, -26), angle, local)
    picture.dot(point, "b", 5)
    picture.text(point[0] + 10, point[1] - 3, "p", size=14, name="b", is_bold=True)
    picture.text(74, 308, "world", name="soft")
    picture.text(186, 330, "in the world: orientation * p + position", size=14, anchor="middle", is_bold=True)


def _draw_pair(picture):
    picture.text(452, 34, "Two shapes, one frame", size=16, is_bold=True)
    a, b = (530, 230), (680, 130)
    _box(picture, a, 62, 42, -14, "a")
    picture.circle(b, 56, "b", pale="b")
    picture.arrow(a, b, "mark", dash="6 4")
    picture.text(570, 122, "pose of b", anchor="middle", name="mark", is_bold=True)
    picture.text(556, 140, "in the frame of a", anchor="middle", name="mark", is_bold=True)
    _axes(picture, a, 40, -14, "a", "xy")
    _axes(picture, b, 28, 40, "b", "xy")
    picture.text(478, 214, "a", size=18, name="a", is_bold=True)
    picture.text(675, 170, "b", size=18, name="b", is_bold=True)
    picture.text(596, 312, "A world of 10,000 km costs no digits", anchor="middle")
    picture.text(596, 330, "between two neighbours.", anchor="middle")


def draw():
    picture = Picture(760, 350, "A pose maps local points to the world; a pair is computed in the frame of one shape")
    _draw_pose(picture)
    picture.lines([(428, 20), (428, 330)], "soft", thick=0.8)
    _draw_pair(picture)
    return picture
