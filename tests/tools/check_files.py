# SPDX-License-Identifier: Apache-2.0
"""Models that a scene reads, STL, PLY and OBJ, and pictures that the program draws.

usage: check_files.py ABUT DIRECT SCENES
"""

import json
import re
import shutil
import struct
import subprocess
import unittest
import zlib

import program
from program import run

# A pyramid on the square from -1 to 1; its base has four corners.
CORNERS = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0), (0, 0, 1.5)]
SIDES = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
BASE = (3, 2, 1, 0)
TRIANGLES = SIDES + [(3, 2, 1), (3, 1, 0)]


def stl_text():
    facets = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*CORNERS[i]) for i in triangle) +
                     "endloop\nendfacet\n" for triangle in TRIANGLES)
    return f"solid pyramid\n{facets}endsolid pyramid\n".encode()


def stl_binary():
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *(x for i in triangle for x in CORNERS[i]), 0) for triangle in TRIANGLES)
    return b"pyramid".ljust(80, b" ") + struct.pack("<I", len(TRIANGLES)) + facets


def ply_header(form, real="float"):
    return (f"ply\nformat {form} 1.0\ncomment made by a test\nelement vertex {len(CORNERS)}\nproperty {real} x\nproperty {real} y\n"
            f"property {real} z\nproperty uchar red\nelement face 5\nproperty list uchar int vertex_indices\n"
            "property int group\nend_header\n").encode()


def ply_text():
    rows = ["{} {} {} 255".format(*corner) for corner in CORNERS]
    rows += [" ".join(map(str, (len(face), *face, 7))) for face in [*SIDES, BASE]]
    return ply_header("ascii") + "\n".join(rows).encode() + b"\n"


def ply_binary(order="<", form="binary_little_endian", real="f"):
    data = b"".join(struct.pack(f"{order}3{real}B", *corner, 255) for corner in CORNERS)
    data += b"".join(struct.pack(f"{order}B{len(face)}ii", len(face), *face, 7) for face in [*SIDES, BASE])
    return ply_header(form, "float" if real == "f" else "double") + data


def obj():
    return ("".join("v {} {} {}\n".format(*c) for c in CORNERS) +
            "".join("f {}\n".format(" ".join(str(i + 1) for i in face)) for face in [*SIDES, BASE])).encode()


FILES = {"text.stl": stl_text(), "UPPER.STL": stl_text(), "binary.stl": stl_binary(), "text.ply": ply_text(), "little.ply": ply_binary(),
         "big.ply": ply_binary(">", "binary_big_endian"), "double.ply": ply_binary(real="d"), "a.obj": obj()}


class Models(program.Case):
    def deepest(self, shape):
        """How deep a ball above the tip of a pyramid and one beside its base reach into it."""
        ball = {"kind": "sphere", "radius": 0.5}
        document = {"version": 1, "parts": [{"name": "pyramid", "motion": "static", "geometries": [{"shape": shape}]}] + [
            {"name": name, "pose": {"position": place}, "geometries": [{"shape": ball}]}
            for name, place in (("above", [0, 0, 1.9]), ("beside", [1.3, 0, 0.2]))]}
        contacts = self.contacts(self.scene(document))
        return [min(c["distance"] for c in contacts if c["part_b"] == name) for name in ("above", "beside")]

    def test_each_form_gives_the_same_mesh_and_hull(self):
        inline = {"mesh": {"kind": "mesh", "vertices": CORNERS, "triangles": TRIANGLES}, "hull": {"kind": "hull", "points": CORNERS}}
        for kind, shape in inline.items():
            expected = self.deepest(shape)
            self.assertAlmostEqual(expected[0], -0.1, delta=1e-12)
            for name, data in FILES.items():
                with self.subTest(kind=kind, file=name):
                    (self.folder / name).write_bytes(data)
                    found = self.deepest({"kind": kind, "file": name})
                    for one, other in zip(found, expected):
                        self.assertAlmostEqual(one, other, delta=1e-12)

    def test_vertices_at_one_place_become_one(self):
        # Particles show each vertex: the tip is on four facets, but one particle.
        (self.folder / "a.stl").write_bytes(stl_binary())
        document = {"version": 1, "universe": {"max_contacts": 0}, "parts": [
            {"name": "tips", "motion": "static", "geometries": [{"shape": {"kind": "particles", "file": "a.stl", "radius": 0.1}}]},
            {"name": "plate", "pose": {"position": [0, 0, 2]}, "geometries": [{"shape": {"kind": "box", "half": [1, 1, 0.45]}}]}]}
        self.assertEqual(len(self.contacts(self.scene(document))), 1)

    def test_small_models_are_not_joined(self):
        # Places a millionth apart are corners of their own.
        tiny = stl_text().decode().replace("1.5", "1.5e-6").replace(" 1 ", " 1e-6 ").replace(" -1 ", " -1e-6 ")
        (self.folder / "tiny.stl").write_text(tiny)
        self.assertEqual(len(self.contacts(self.scene({"version": 1, "parts": [
            {"name": "a", "motion": "static", "geometries": [{"shape": {"kind": "hull", "file": "tiny.stl"}}]},
            {"name": "b", "pose": {"position": [0, 0, 1.9e-6]},
             "geometries": [{"shape": {"kind": "sphere", "radius": 0.5e-6}}]}]}))), 1)

    def refused(self, name, data):
        (self.folder / name).write_bytes(data)
        result = run("check", self.scene({"version": 1, "parts": [{"geometries": [{"shape": {"kind": "mesh", "file": name}}]}]}))
        self.assertIn(result.returncode, (0, 1, 4), result.stderr)
        if result.returncode == 1:
            self.assertIn("parts[0].geometries[0].shape", result.stderr)
            self.assertRegex(result.stderr, r"^[ -~]+\n$")
        return result.stderr

    def test_bad_files_are_told(self):
        text, table = stl_text(), ply_text()
        for name, data, words in (
            ("a.stl", b"", "does not begin with 'solid'"),
            ("a.stl", bytes(range(256)) * 2, "not as long as the count of its triangles says"),
            ("a.stl", text.replace(b"vertex 0 0 1.5", b"vertex 0 0 tip"), "'tip' where a number"),
            ("a.stl", text.replace(b"vertex 0 0 1.5", b"vertex 0 0 nan"), "a number is expected"),
            ("a.stl", text.replace(b"endloop", b"vertex", 1), "'vertex' where 'endloop'"),
            ("a.stl", b"solid nothing\nendsolid\n", "no triangles"),
            ("a.ply", b"solid", "does not begin with 'ply'"),
            ("a.ply", table.replace(b"ascii", b"nonsense"), "its format is 'nonsense'"),
            ("a.ply", table.replace(b"uchar red", b"colour red"), "the type 'colour'"),
            ("a.ply", table.replace(b"vertex 5", b"vertex many"), "without a count"),
            ("a.ply", table.replace(b"end_header\n", b""), "its header holds"),
            ("a.ply", table.replace(b"3 0 1 4", b"3 0 1 5"), "the vertex 5; expected a whole number below 5"),
            ("a.ply", table.replace(b"3 0 1 4", b"3 0 1.5 4"), "the vertex 1.5"),
            ("a.ply", table.replace(b"3 0 1 4", b"-3 0 1 4"), "the count -3"),
            ("a.ply", table.replace(b"property float z\n", b"property float w\n"), "no finite x, y and z"),
        ):
            with self.subTest(words=words):
                self.assertIn(words, self.refused(name, data))

    def test_a_file_that_is_missing_is_named_once(self):
        for name in ("none.stl", "none.ply", "none.obj"):
            scene = self.scene({"version": 1, "parts": [{"geometries": [{"shape": {"kind": "mesh", "file": name}}]}]})
            self.assertTrue(run("check", scene).stderr.endswith(
                f'is "{name}"; expected a file that can be read: cannot open the model {self.folder / name}\n'))

    def test_files_that_are_cut_off_are_told(self):
        for name, data in FILES.items():
            if name.endswith("obj"):
                continue
            for size in range(0, len(data) - 12, max(1, len(data) // 40)):
                with self.subTest(file=name, size=size):
                    self.assertNotEqual(self.refused(f"cut_{name}", data[:size]), "")


def pixels_of(data):
    """Rows of (r, g, b) of a PNG of 8-bit RGB."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    position, packed = 8, b""
    while position < len(data):
        size, name = struct.unpack(">I4s", data[position:position + 8])
        body = data[position + 8:position + 8 + size]
        if name == b"IHDR":
            width, height, depth, form = struct.unpack(">IIBB", body[:10])
            assert (depth, form) == (8, 2)
        packed += body if name == b"IDAT" else b""
        position += size + 12
    raw, before, rows = zlib.decompress(packed), bytes(3 * width), []
    for y in range(height):
        line = bytearray(raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)])
        for i in range(3 * width):
            left, up, corner = (line[i - 3] if i > 2 else 0), before[i], (before[i - 3] if i > 2 else 0)
            near = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))[2]
            line[i] = (line[i] + (0, left, up, (left + up) // 2, near)[raw[y * (3 * width + 1)]]) & 255
        before = bytes(line)
        rows.append([tuple(line[3 * x:3 * x + 3]) for x in range(width)])
    return rows


class Pictures(program.Case):
    RED = {"version": 1, "parts": [{"name": "a", "geometries": [{"shape": {"kind": "sphere", "radius": 1}}]}]}

    def setUp(self):
        super().setUp()
        result = run("picture", self.scene(self.RED), self.folder / "first.png", "--size", "8x8")
        if "this build draws no pictures" in result.stderr:
            self.skipTest("this build draws no pictures")

    def picture(self, document, *options):
        out = self.folder / "out.png"
        self.succeed("picture", self.scene(document), out, "--size", "48x36", *options)
        return pixels_of(out.read_bytes())

    def is_red(self, pixel):
        return pixel[0] > pixel[1] + 50

    def test_all_fits_in(self):
        for place, radius in (([0, 0, 0], 1), ([1e4, -3, 7], 40), ([0, 0, 0], 1e-4)):
            document = json.loads(json.dumps(self.RED))
            document["parts"][0]["pose"] = {"position": place}
            document["parts"][0]["geometries"][0]["shape"]["radius"] = radius
            rows = self.picture(document)
            self.assertEqual((len(rows), len(rows[0])), (36, 48))
            self.assertTrue(self.is_red(rows[16][24]), rows[16][24])
            self.assertFalse(self.is_red(rows[1][24]) or self.is_red(rows[16][4]))
            self.assertGreater(sum(self.is_red(p) for row in rows for p in row), 150)

    def test_the_camera_stands_where_it_is_told(self):
        # Seen from below, +X is on the left where +Y is up, and on the right where +Y is down.
        for up, sides in (("0,1,0", {True}), ("0,-1,0", {False})):
            rows = self.picture(self.RED, "--from", "0,0,-20", "--to", "3,0,0", "--up", up)
            self.assertEqual({x > 24 for row in rows for x, pixel in enumerate(row) if self.is_red(pixel)}, sides)
        self.assertEqual(sum(self.is_red(p) for row in self.picture(self.RED, "--from", "0,0,9", "--to", "0,0,20", "--up",
                                                                    "1,0,0") for p in row), 0)

    def test_contacts_are_dots(self):
        # Two boxes, one on the other: what differs in the picture when they begin to touch are the corners.
        def boxes(height):
            box = [{"shape": {"kind": "box", "half": [1, 1, 1]}}]
            rows = self.picture({"version": 1, "parts": [{"name": "low", "geometries": box}, {
                "name": "high", "pose": {"position": [0, 0, height]}, "geometries": box}]})
            return [pixel for row in rows[:32] for pixel in row]

        def differences(first, second):
            return sum(sum(abs(a - b) for a, b in zip(*pixels)) > 60 for pixels in zip(first, second))
        apart = boxes(2.0001)
        self.assertEqual(differences(apart, boxes(2.0002)), 0)
        self.assertGreaterEqual(differences(apart, boxes(1.9999)), 3)

    def test_element_contacts_are_dots(self):
        # The same sheet above the table, with and without a policy for its pair: dots are all that differs.
        document = json.loads((program.SCENES / "table.json").read_text())
        cloth = document["parts"][0]["geometries"][0]
        cloth["shape"]["file"] = str(program.SCENES / "cloth2.ply")
        del cloth["sequence"]

        def above_the_legend():
            rows = self.picture(document, "--size", "160x120", "--from", "0,0,9", "--to", "0,0,0", "--up", "0,1,0")
            return [pixel for row in rows[:110] for pixel in row]
        with_dots = above_the_legend()
        document["policies"] = []
        without = above_the_legend()
        changed = sum(sum(abs(a - b) for a, b in zip(*pixels)) > 60 for pixels in zip(with_dots, without))
        self.assertGreater(changed, 20)

    def test_the_page_shows_what_its_commands_draw(self):
        page = (program.SCENES.parents[1] / "docs" / "abut.md").read_text(encoding="utf-8")
        commands = re.findall(r"^abut picture (\S+) (docs/images/\S+\.png) (.*)$", page, re.MULTILINE)
        self.assertEqual(len(commands), 2)
        for scene, shown, options in commands:
            with self.subTest(scene=scene):
                root, out = program.SCENES.parents[1], self.folder / "again.png"
                self.succeed("picture", root / scene, out, *options.split())
                files = (root / shown).read_bytes(), out.read_bytes()
                if files[0] == files[1]:
                    continue
                pixels = [[pixel for row in pixels_of(data) for pixel in row] for data in files]
                self.assertEqual(len(pixels[0]), len(pixels[1]))
                # Another version of Embree may move a ray at an outline to the other side.
                changed = sum(max(abs(a - b) for a, b in zip(*pair)) > 8 for pair in zip(*pixels))
                self.assertLess(changed, 1e-3 * len(pixels[0]))

    def test_the_same_scene_gives_the_same_bytes(self):
        scene = program.SCENES / "stack.json"
        files = []
        for name in ("one.png", "two.png"):
            self.succeed("picture", scene, self.folder / name, "--size", "64x48")
            files.append((self.folder / name).read_bytes())
        result = subprocess.run([program.ABUT, "picture", scene, "-", "--size", "64x48"], capture_output=True, check=True)
        self.assertEqual(result.stderr, b"")
        self.assertTrue(files[0] == files[1] == result.stdout)

    def test_mistakes(self):
        scene, good = self.scene(self.RED), self.folder / "a.png"
        for arguments, words in (
            ([], ("no argument is given", "picture SCENE PICTURE")),
            ([scene, "a.jpg"], ("the picture is 'a.jpg'", ".png")),
            ([scene, good, "--size", "0x9"], ("--size is '0x9'", "1280x720")),
            ([scene, good, "--size", "9x9x9"], ("--size is '9x9x9'",)),
            ([scene, good, "--from", "1,2,"], ("--from is '1,2,'", "three numbers")),
            ([scene, good, "--up", "0,0,0"], ("--up is 0,0,0", "a direction")),
            ([scene, good, "--from=0,0,9", "--to=0,0,0"], ("parallel to --up",)),
            ([scene, good, "--from=1,1,1", "--to=1,1,1"], ("no length",)),
        ):
            with self.subTest(arguments=arguments):
                result = run("picture", *arguments)
                self.assertEqual(result.returncode, 1, result.stderr)
                for word in words:
                    self.assertIn(word, result.stderr)
        result = run("picture", scene, self.folder / "none" / "a.png", "--size", "8x8")
        self.assertEqual(result.returncode, 3)
        self.assertIn("No such file or directory", result.stderr)

    @unittest.skipUnless(shutil.which("ldd"), "ldd is missing, which lists what a program loads")
    def test_nothing_else_loads_embree(self):
        loaded = subprocess.run(["ldd", program.ABUT], capture_output=True, text=True, check=True).stdout
        self.assertIn("libabut", loaded)
        self.assertNotIn("embree", loaded)


if __name__ == "__main__":
    program.main()
