# SPDX-License-Identifier: Apache-2.0
"""The house: folders of modules, each of which imports only those to the right of it or below."""

from picture import Picture

# Floors from the roof down: colour, rooms as (name, what it holds).
FLOORS = (
    ("mark", (("programs and bindings", "C, C++, Python and others"),)),
    ("mark", (("capi", "the C interface: abut.h"), ("picking", "Embree: picking.h"), ("response", "response.h"))),
    ("b", (("universe", "a step: stage by stage"), ("report", "what it did, and why"))),
    ("b", (("queries", "rays, points, casts"), ("detect", "poses to contacts, events"), ("scene", "parts, rules: no detection"))),
    ("a", (("motion", "paths and impacts"), ("pairs", "shapes to a kernel"), ("proximity", "meshes that deform"), ("elements", "features of meshes"), ("deforming", "moving vertices"))),
    ("a", (("narrow", "two shapes to contacts"), ("broadphase", "boxes to pairs of boxes"), ("shapes", "one file per shape"))),
    ("good", (("trees", "from boxes to items"), ("triangles", "as they are given"), ("capability", "what shapes can do"))),
    ("good", (("math", "vectors, poses, boxes"), ("core", "ids, results, threads"))),
)


def draw():
    picture = Picture(760, 560, "Modules import only those to their right or on lower floors")
    left, right, top, height, gap = 24, 700, 52, 54, 8
    picture.text(left, 34, "The house", size=16, is_bold=True)
    picture.text(728, 34, "imports run down, or to the right", anchor="end", name="soft")
    for floor, (name, rooms) in enumerate(FLOORS):
        y = top + floor * (height + gap)
        width = (right - left - gap * (len(rooms) - 1)) / len(rooms)
        for i, (word, meaning) in enumerate(rooms):
            x = left + i * (width + gap)
            picture.rectangle(x, y, width, height, name, pale=name, round_by=6)
            picture.text(x + width / 2, y + 23, word, size=15, anchor="middle", name=name, is_bold=True)
            picture.text(x + width / 2, y + 42, meaning, size=12, anchor="middle")
    picture.arrow((722, top), (722, top + 8 * (height + gap) - gap), "soft", thick=2.5, head=12)
    return picture
