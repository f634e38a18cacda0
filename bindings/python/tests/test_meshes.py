# SPDX-License-Identifier: Apache-2.0
"""Meshes from files and from objects of other libraries."""

import pathlib
import struct
import tempfile
import types
import unittest
import unittest.mock

import abut

CORNERS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
SQUARE = [(0, 1, 2), (0, 2, 3)]


class Meshes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def expect_square(self, mesh):
        xyz, triangles = mesh.triangles()
        points = [tuple(xyz[i:i + 3]) for i in range(0, len(xyz), 3)]
        self.assertEqual(points, CORNERS)
        self.assertEqual(list(triangles), [corner for triangle in SQUARE for corner in triangle])

    def test_objects_with_vertices_and_faces(self):
        source = types.SimpleNamespace(vertices=CORNERS, faces=SQUARE)
        self.expect_square(abut.Shape.mesh(source))
        self.expect_square(abut.Shape.mesh(CORNERS, SQUARE))
        self.assertEqual(abut.Shape.hull(source).hull_report().vertex_count, 4)
        with self.assertRaisesRegex(TypeError, "of type list is no mesh: triangles are missing"):
            abut.Shape.mesh(CORNERS)

    def test_quads_are_split(self):
        self.expect_square(abut.Shape.mesh(CORNERS, [(0, 1, 2, 3)]))
        self.expect_square(abut.Shape.uv_grid(CORNERS, [(0, 1, 2, 3)]))
        self.expect_square(abut.Shape.mesh(CORNERS, [0, 1, 2, 3], corners=4))
        with self.assertRaisesRegex(abut.Error, "options.corners is 5"):
            abut.Shape.mesh(CORNERS, SQUARE, corners=5)

    def test_a_mesh_is_described_before_it_is_made(self):
        halves = CORNERS[:3] + [CORNERS[0], CORNERS[2], CORNERS[3]]
        apart = abut.Shape.describe_mesh(halves, [(0, 1, 2), (3, 4, 5)])
        self.assertEqual((apart.open_edges, apart.duplicate_vertices, apart.components), (6, 2, 2))
        merged = abut.Shape.describe_mesh(halves, [(0, 1, 2), (3, 4, 5)], merge_distance=0)
        self.assertEqual((merged.open_edges, merged.merged_vertices, merged.components), (4, 2, 1))

    def test_obj(self):
        corners = "".join(f"v {x} {y} {z}\n" for x, y, z in CORNERS)
        for faces in ("f 1 2 3 4\n", "f 1/1 2/2/2 3//3 4\n", "f -4 -3 -2\nf -4 -2 -1\n"):
            path = self.file("square.obj", "# a square\n" + corners + "vn 0 0 1\n" + faces)
            self.expect_square(abut.Shape.mesh(path))
        self.assertEqual(abut.Shape.hull(str(path)).kind, "hull")
        for line in ("v 1 2", "v 1 2 x", "f 1 2 0", "f 1 2 -9"):
            path = self.file("wrong.obj", corners + line + "\n")
            with self.subTest(line), self.assertRaisesRegex(ValueError, f"wrong.obj, line 5: '{line}' cannot be read"):
                abut.Shape.mesh(path)
        with self.assertRaisesRegex(abut.Error, "ABUT_INDEX_OUT_OF_RANGE"):
            abut.Shape.mesh(self.file("far.obj", corners + "f 1 2 5\n"))

    def test_stl(self):
        binary = b"solid, but binary".ljust(80) + struct.pack("<I", 2)
        text = "solid square\n"
        for triangle in SQUARE:
            binary += struct.pack("<12fH", 0, 0, 1, *(x for corner in triangle for x in CORNERS[corner]), 0)
            text += "facet normal 0 0 1\nouter loop\n"
            text += "".join("vertex {} {} {}\n".format(*CORNERS[corner]) for corner in triangle) + "endloop\nendfacet\n"
        self.expect_square(abut.Shape.mesh(self.file("binary.STL", binary)))
        self.expect_square(abut.Shape.mesh(self.file("text.stl", text)))
        with self.assertRaisesRegex(ValueError, "is no STL file: it has 183 bytes and speaks of 2 triangles"):
            abut.Shape.mesh(self.file("cut.stl", binary.replace(b"solid", b"other")[:-1]))
        with self.assertRaisesRegex(ValueError, "text.stl, line 4: 'vertex 0 0' is no vertex"):
            abut.Shape.mesh(self.file("text.stl", text.replace("vertex 0 0 0", "vertex 0 0", 1)))

    def ply(self, form, body, faces="list uchar int vertex_indices"):
        header = (f"ply\nformat {form} 1.0\ncomment a square\nelement vertex 4\nproperty double x\nproperty double y\n"
                  f"property float z\nproperty uchar red\nelement material 1\nproperty list uchar short numbers\n"
                  f"element face 2\nproperty {faces}\nproperty uchar flags\nend_header\n")
        return header.encode() + body

    def test_ply(self):
        corners = "".join(f"{x} {y} {z} 255\n" for x, y, z in CORNERS)
        text = self.ply("ascii", f"{corners}2 -5 6\n3 0 1 2 0\n3 0 2 3 0\n".encode())
        self.expect_square(abut.Shape.mesh(self.file("text.ply", text)))
        self.expect_square(abut.Shape.mesh(self.file("returns.PLY", text.replace(b"\n", b"\r\n"))))
        for form, order in (("binary_little_endian", "<"), ("binary_big_endian", ">")):
            body = b"".join(struct.pack(order + "ddfB", *corner, 255) for corner in CORNERS)
            body += struct.pack(order + "B2h", 2, -5, 6)
            faces = b"".join(struct.pack(order + "B3iB", 3, *triangle, 0) for triangle in SQUARE)
            whole = self.ply(form, body + faces)
            self.expect_square(abut.Shape.mesh(self.file("binary.ply", whole)))
            quad = whole.replace(b"face 2", b"face 1")[:-len(faces)] + struct.pack(order + "B4iB", 4, 0, 1, 2, 3, 0)
            self.expect_square(abut.Shape.mesh(self.file("quad.ply", quad)))
            for length in range(len(whole) - len(body + faces), len(whole)):
                with self.assertRaisesRegex(ValueError, "cut.ply ends within (vertex|material|face) [0-3] of [1-4]"):
                    abut.Shape.mesh(self.file("cut.ply", whole[:length]))
        self.assertEqual(abut.Shape.hull(self.file("text.ply", text)).kind, "hull")

    def test_what_is_wrong_with_a_ply_is_said(self):
        corners = "".join(f"{x} {y} {z} 255\n" for x, y, z in CORNERS)
        good = self.ply("ascii", f"{corners}2 -5 6\n3 0 1 2 0\n3 0 2 3 0\n".encode())
        for before, after, expected in [
                (b"ply", b"plot", "is no PLY file: it has no header"), (b"end_header", b"", "is no PLY file: it has no header"),
                (b"ascii", b"morse", "line 2: 'format morse 1.0' cannot be read"),
                (b"format ascii 1.0\n", b"", "its header names no format"),
                (b"double x", b"quad x", "line 5: 'property quad x' cannot be read"),
                (b"double x", b"double u", "the element vertex has no property x; it has u, y, z, red"),
                (b"vertex_indices", b"corners", "the element face has no property vertex_indices; it has corners, flags"),
                (b"element vertex 4", b"element vertex four", "line 4: 'element vertex four' cannot be read"),
                (b"1 0 0 255", b"1 0 255", "vertex 1 cannot be read from '1 0 255'"),
                (b"3 0 1 2 0", b"5 0 1 2 0", "face 0 cannot be read from '5 0 1 2 0'"),
                (b"3 0 2 3 0\n", b"", "face 1 cannot be read from ''"),
                (b"3 0 1 2 0", b"3 0 1 -2 0", "triangles has the number -2")]:
            self.assertEqual(good.count(before) > 0, True, before)
            with self.subTest(expected), self.assertRaisesRegex(ValueError, expected):
                abut.Shape.mesh(self.file("wrong.ply", good.replace(before, after, 1)))
        with self.assertRaisesRegex(abut.Error, "ABUT_INDEX_OUT_OF_RANGE"):
            abut.Shape.mesh(self.file("far.ply", good.replace(b"3 0 1 2", b"3 0 1 9")))

    def test_formats_of_others_name_what_reads_them(self):
        path = self.file("square.off", "OFF\n")
        with unittest.mock.patch("importlib.util.find_spec", lambda name: None):
            with self.assertRaisesRegex(ValueError, "obj, .ply and .stl are read by abut; .off needs trimesh or meshio"):
                abut.Shape.mesh(path)

    def test_formats_of_others_are_read_by_what_is_installed(self):
        mesh = types.SimpleNamespace(points=CORNERS, cells_dict={"triangle": SQUARE, "line": [(0, 1)]})
        meshio = types.SimpleNamespace(read=lambda path: mesh)
        trimesh = types.SimpleNamespace(load=lambda path, force: types.SimpleNamespace(vertices=CORNERS, faces=SQUARE))
        path = self.file("square.off", "ply\n")
        for name, module in (("meshio", meshio), ("trimesh", trimesh)):
            with unittest.mock.patch("importlib.util.find_spec", lambda asked: asked == name), \
                    unittest.mock.patch.dict("sys.modules", {name: module}):
                self.expect_square(abut.Shape.mesh(path))
        mesh.cells_dict["quad"] = [(0, 1, 2, 3)]
        with unittest.mock.patch("importlib.util.find_spec", lambda asked: asked == "meshio"), \
                unittest.mock.patch.dict("sys.modules", {"meshio": meshio}):
            with self.assertRaisesRegex(ValueError, "square.off has cells of the kinds quad, triangle; they must be triangles"):
                abut.Shape.mesh(path)

    def test_a_file_that_is_missing(self):
        for name in ("none.obj", "none.ply", "none.off"):
            with self.assertRaises(FileNotFoundError):
                abut.Shape.mesh(self.folder / name)


if __name__ == "__main__":
    unittest.main()
