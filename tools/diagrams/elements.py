# SPDX-License-Identifier: Apache-2.0
"""Element contacts of a sheet on a ball: which vertices, edges and faces are near each other, found by trying all."""

import itertools
import math

from picture import Picture

REACH = 0.08
KINDS = (("vertex and face", "mark"), ("edge and edge", "good"), ("vertex and edge", "gold"), ("vertex and vertex", "bad"))
_SCALE, _CENTRE, _ELEVATION = 172, (252, 232), math.radians(52)


def _plus(a, b, share=1.0):
    return tuple(x + share * y for x, y in zip(a, b))


def _minus(a, b):
    return _plus(a, b, -1.0)


def _dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def ball():
    """An icosahedron of radius 1 whose faces are split in four."""
    golden = (1 + math.sqrt(5)) / 2
    places = [point for one, other in itertools.product((-1, 1), (-golden, golden))
              for point in ((0, one, other), (one, other, 0), (other, 0, one))]
    faces = [f for f in itertools.combinations(range(12), 3)
             if all(abs(math.dist(places[a], places[b]) - 2) < 1e-9 for a, b in itertools.combinations(f, 2))]
    middles = {}

    def middle(a, b):
        if (min(a, b), max(a, b)) not in middles:
            middles[min(a, b), max(a, b)] = len(places)
            places.append(_plus(places[a], places[b]))
        return middles[min(a, b), max(a, b)]

    split = []
    for a, b, c in faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        split += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    places = [tuple(x / math.hypot(*point) for x in point) for point in places]
    outward = [f if _dot(_cross(_minus(places[f[1]], places[f[0]]), _minus(places[f[2]], places[f[0]])), places[f[0]]) > 0
               else (f[0], f[2], f[1]) for f in split]
    return places, outward


def sheet():
    """A square that lies on the ball and hangs down beyond 50 degrees."""
    side, radius, edge = 8, 1.03, math.radians(50)
    places = []
    for i, j in itertools.product(range(side), repeat=2):
        x, y = (2.4 * k / (side - 1) - 1.2 for k in (i, j))
        x, y = x * math.cos(0.35) - y * math.sin(0.35), x * math.sin(0.35) + y * math.cos(0.35)
        along = math.hypot(x, y)
        angle = min(along / radius, edge)
        beyond = along - radius * angle
        out = radius * math.sin(angle) + beyond * math.cos(edge)
        places.append((x * out / along, y * out / along, radius * math.cos(angle) - beyond * math.sin(edge)))
    return places, [face for i, j in itertools.product(range(side - 1), repeat=2) for a in [i * side + j]
                    for face in ((a, a + side, a + side + 1), (a, a + side + 1, a + 1))]


def _closest_on_edge(point, places, ends):
    a, b = (places[k] for k in ends)
    share = _dot(_minus(point, a), _minus(b, a)) / _dot(_minus(b, a), _minus(b, a))
    if share <= 0 or share >= 1:
        k = ends[0] if share <= 0 else ends[1]
        return math.dist(point, places[k]), (k,), places[k]
    at = _plus(a, _minus(b, a), share)
    return math.dist(point, at), tuple(sorted(ends)), at


def _closest_on_face(point, places, face):
    """Distance, feature and place of the point of a triangle that is nearest to another point."""
    a, b, c = (places[k] for k in face)
    u, v, w = _minus(b, a), _minus(c, a), _minus(point, a)
    whole = _dot(u, u) * _dot(v, v) - _dot(u, v) ** 2
    first = (_dot(v, v) * _dot(w, u) - _dot(u, v) * _dot(w, v)) / whole
    second = (_dot(u, u) * _dot(w, v) - _dot(u, v) * _dot(w, u)) / whole
    if first > 0 and second > 0 and first + second < 1:
        at = _plus(_plus(a, u, first), v, second)
        return math.dist(point, at), tuple(sorted(face)), at
    return min(_closest_on_edge(point, places, ends) for ends in itertools.combinations(face, 2))


def _of_vertices(places, others, faces):
    """Of each vertex each feature that all faces around it name."""
    around = {}
    for face in faces:
        for count in (1, 2, 3):
            for feature in itertools.combinations(sorted(face), count):
                around.setdefault(feature, []).append(face)
    for vertex, place in enumerate(places):
        named = {face: _closest_on_face(place, others, face) for face in faces
                 if any(math.dist(place, others[k]) < 1 for k in face)}
        for feature, (distance, _, at) in {its[1]: its for its in sorted(named.values())}.items():
            if distance <= REACH and all(named[face][1] == feature for face in around[feature]):
                yield distance, (vertex,), feature, place, at


def _of_edges(places_a, faces_a, places_b, faces_b):
    edges_a, edges_b = ({tuple(sorted(ends)) for face in faces for ends in itertools.combinations(face, 2)}
                        for faces in (faces_a, faces_b))
    for ends_a, ends_b in itertools.product(sorted(edges_a), sorted(edges_b)):
        p, q = places_a[ends_a[0]], places_b[ends_b[0]]
        u, v, w = _minus(places_a[ends_a[1]], p), _minus(places_b[ends_b[1]], q), _minus(p, q)
        whole = _dot(u, u) * _dot(v, v) - _dot(u, v) ** 2
        if whole < 1e-12:
            continue
        first = (_dot(u, v) * _dot(v, w) - _dot(v, v) * _dot(u, w)) / whole
        second = (_dot(u, u) * _dot(v, w) - _dot(u, v) * _dot(u, w)) / whole
        if 0 < first < 1 and 0 < second < 1:
            a, b = _plus(p, u, first), _plus(q, v, second)
            if math.dist(a, b) <= REACH:
                yield math.dist(a, b), ends_a, ends_b, a, b


def contacts():
    """(distance, vertices of the sheet, vertices of the ball, point of the sheet, point of the ball) of each."""
    (of_ball, ball_faces), (of_sheet, sheet_faces) = ball(), sheet()
    found = list(_of_vertices(of_sheet, of_ball, ball_faces))
    found += [(distance, feature, vertex, at, place)
              for distance, vertex, feature, place, at in _of_vertices(of_ball, of_sheet, sheet_faces)]
    found += _of_edges(of_sheet, sheet_faces, of_ball, ball_faces)
    return sorted(set(found))


def kind_of(contact):
    """The index of its kind."""
    counts = sorted(len(vertices) for vertices in contact[1:3])
    return [[1, 3], [2, 2], [1, 2], [1, 1]].index(counts)


def _seen(place):
    x, y, z = place
    up = z * math.cos(_ELEVATION) + y * math.sin(_ELEVATION)
    return (_CENTRE[0] + _SCALE * x, _CENTRE[1] - _SCALE * up)


def _depth(places):
    return sum(-y * math.cos(_ELEVATION) + z * math.sin(_ELEVATION) for _, y, z in places) / len(places)


def _draw_surfaces(picture):
    (of_ball, ball_faces), (of_sheet, sheet_faces) = ball(), sheet()
    areas = [([of_ball[k] for k in face], "a", 1.0) for face in ball_faces]
    areas += [([of_sheet[k] for k in face], "b", 0.55) for face in sheet_faces]
    for corners, name, opacity in sorted(areas, key=lambda its: _depth(its[0])):
        picture.polygon([_seen(corner) for corner in corners], name, pale=name, thick=0.8, opacity=opacity)


def _draw_legend(picture, found):
    for i, (text, name) in enumerate(KINDS):
        y = 136 + 42 * i
        picture.dot((520, y), name, 6)
        picture.text(538, y + 5, text, is_bold=True)
        count = sum(kind_of(contact) == i for contact in found)
        picture.text(716, y + 5, str(count), anchor="end", name=name, is_bold=True)


def draw():
    picture = Picture(760, 420, "Element contacts of a sheet that lies on a ball")
    found = contacts()
    _draw_surfaces(picture)
    for contact in sorted(found, key=lambda its: _depth(its[3:])):
        name = KINDS[kind_of(contact)][1]
        picture.lines([_seen(contact[3]), _seen(contact[4])], name, thick=2)
        picture.dot(_seen(contact[3]), name, 3.2)
    picture.text(510, 48, "Element contacts", size=16, is_bold=True)
    picture.text(510, 72, "of a sheet with a ball of radius 1,", name="soft")
    picture.text(510, 92, f"up to {REACH} apart", name="soft")
    _draw_legend(picture, found)
    picture.paragraph(510, 330, ("Each line leads from the point", "of the sheet to that of the ball."), name="soft")
    return picture
