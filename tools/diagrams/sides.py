# SPDX-License-Identifier: Apache-2.0
"""Surfaces: the front of a triangle, a mesh of one side, and the cells of a height field."""

from picture import Picture


def _ball(picture, centre, arrow_to, is_stopped):
    picture.circle(centre, 18, "b", pale="b")
    picture.arrow(centre, arrow_to, "good" if is_stopped else "bad", thick=2.2)


def _draw_winding(picture):
    picture.text(24, 34, "The front", size=16, is_bold=True)
    corners = ((52, 226), (204, 248), (132, 112))
    picture.polygon(corners, "a", pale="a")
    for (x, y), word, shift in zip(corners, ("a", "b", "c"), ((-14, 6), (14, 8), (0, -10))):
        picture.dot((x, y), "a", 4.5)
        picture.text(x + shift[0], y + shift[1], word, anchor="middle", name="a", is_bold=True)
    picture.arc((128, 198), 26, -150, 120, "mark", thick=2)
    picture.arrow((119, 174), (113, 176), "mark", head=9)
    picture.paragraph(24, 294, ("Corners run counter-clockwise", "seen from the front. The normal", "points to you."))


def _draw_sides(picture):
    picture.text(276, 34, "Sides of a mesh", size=16, is_bold=True)
    for y, word, is_one_sided in ((112, "ABUT_SIDES_BOTH", False), (222, "ABUT_SIDES_FRONT", True)):
        picture.lines([(286, y), (486, y)], "a", thick=4)
        for x in (320, 386, 452):
            picture.arrow((x, y), (x, y - 18), "mark", head=6)
        _ball(picture, (352, y - 28), (352, y - 50), True)
        if not is_one_sided:
            _ball(picture, (418, y + 28), (418, y + 50), True)
        else:
            _ball(picture, (418, y + 10), (418, y - 34), False)
        picture.text(278, y + 32, word, size=12, is_code=True)
    picture.paragraph(276, 294, ("Both: pushed out where it lies.", "Front: what is behind passes;", "pushes go to the front only."))


def _draw_field(picture):
    picture.text(534, 34, "A height field", size=16, is_bold=True)
    origin, step_x, step_y, lean = (540, 236), 50, 34, 16
    heights = ((0, 14, 6, 0), (8, 26, 18, 6), (4, 16, 24, 10), (0, 6, 12, 4))

    def sample(i, j):
        return (origin[0] + i * step_x + j * lean, origin[1] - j * step_y - heights[j][i])

    for j in range(3):
        for i in range(3):
            picture.polygon([sample(i, j), sample(i + 1, j), sample(i + 1, j + 1)], "a", pale="a", thick=1)
            picture.polygon([sample(i, j), sample(i + 1, j + 1), sample(i, j + 1)], "a", pale="a", thick=1)
    for j in range(4):
        for i in range(4):
            picture.dot(sample(i, j), "a", 2.5)
    picture.arrow((540, 254), (640, 254), "ink")
    picture.text(648, 258, "columns, x", size=12)
    picture.arrow((700, 236), (734, 164), "ink")
    picture.text(726, 214, "y", size=12)
    picture.arrow((606, 118), (606, 76), "mark", thick=2.2)
    picture.text(614, 88, "+z is the front", name="mark", is_bold=True)
    picture.paragraph(534, 294, ("Cells are split from (i, j)", "to (i + 1, j + 1).", "Sample (0, 0) is the origin."))


def draw():
    picture = Picture(760, 350, "The front of triangles, meshes of one or two sides, and the cells of a height field")
    _draw_winding(picture)
    _draw_sides(picture)
    _draw_field(picture)
    return picture
