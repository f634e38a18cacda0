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

    def test_formats_of_others_name_what_reads_them(self):
        path = self.file("square.ply", "ply\n")
        with unittest.mock.patch("importlib.util.find_spec", lambda name: None):
            with self.assertRaisesRegex(ValueError, "obj and .stl are read by abut; .ply needs trimesh or meshio"):
                abut.Shape.mesh(path)

    def test_formats_of_others_are_read_by_what_is_installed(self):
        mesh = types.SimpleNamespace(points=CORNERS, cells_dict={"triangle": SQUARE, "line": [(0, 1)]})
        meshio = types.SimpleNamespace(read=lambda path: mesh)
        trimesh = types.SimpleNamespace(load=lambda path, force: types.SimpleNamespace(vertices=CORNERS, faces=SQUARE))
        path = self.file("square.ply", "ply\n")
        for name, module in (("meshio", meshio), ("trimesh", trimesh)):
            with unittest.mock.patch("importlib.util.find_spec", lambda asked: asked == name), \
                    unittest.mock.patch.dict("sys.modules", {name: module}):
                self.expect_square(abut.Shape.mesh(path))
        mesh.cells_dict["quad"] = [(0, 1, 2, 3)]
        with unittest.mock.patch("importlib.util.find_spec", lambda asked: asked == "meshio"), \
                unittest.mock.patch.dict("sys.modules", {"meshio": meshio}):
            with self.assertRaisesRegex(ValueError, "square.ply has cells of the kinds quad, triangle; they must be triangles"):
                abut.Shape.mesh(path)

    def test_a_file_that_is_missing(self):
        for name in ("none.obj", "none.ply"):
            with self.assertRaises(FileNotFoundError):
                abut.Shape.mesh(self.folder / name)


if __name__ == "__main__":
    unittest.main()
