# SPDX-License-Identifier: Apache-2.0
"""Broken scenes and arguments: exit status 1, a message with the place, the value and what was expected, and no file.

usage: check_mistakes.py ABUT DIRECT SCENES
"""

import copy
import json

import program
from program import run

GOOD = {
    "version": 1,
    "universe": {"broadphase": "tree", "events": ["pairs"]},
    "layers": {"ground": 0},
    "tags": {"near": 1, "far": 2},
    "shapes": {
        "ball": {"kind": "sphere", "radius": 0.5},
        "sheet": {"kind": "mesh", "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "triangles": [[0, 1, 2]]},
        "pair": {"kind": "composite", "children": [{"shape": "ball"}, {"shape": "sheet", "pose": {"position": [1, 0, 0]}}]},
        "land": {"kind": "height_field", "spacing_x": 1, "spacing_y": 1, "heights": [[0, 0], [0, 1]]},
    },
    "parts": [
        {"name": "ball", "pose": {"position": [0, 0, 1]}, "geometries": [{"shape": "ball", "layers": ["ground"]}]},
        {"name": "pair", "motion": "animated", "script": {"velocity": [1, 0, 0]}, "geometries": [{"shape": "pair"}]},
    ],
    "rules": [{"a": {"part": "ball"}, "b": "any", "rule": "disable"}],
    "policies": [{"tags": ["near", 0], "detail": "point"}],
    "focus": {"centres": [[0, 0, 0]], "near_tag": "near", "far_tag": "far", "near_distance": 1, "far_distance": 2},
}

# Where a value is put, the value, what is expected, and what the message says to be wrong if it is not that value.
MISTAKES = [
    ("version", 2, "expected 1"),
    ("steps", 0, "expected a whole number from 1 to"),
    ("steps", 2.5, "expected a whole number from 1 to"),
    ("dt", -0.5, "not negative"),
    ("gravity", 9.81, "no field of this name; there are: "),
    ("units.length", 3, "a name"),
    ("universe", [], "an object"),
    ("universe.broadphase", "quick", '"sweep_and_prune" or "hash_grid"'),
    ("universe.broadphase", "hash_gird", "did you mean 'hash_grid'?"),
    ("universe.tolerance_mode", True, '"dead_band" or "margin"'),
    ("universe.max_contacts", -1, "a whole number from 0"),
    ("universe.threads", 5000, "a whole number from 0 to 1024"),
    ("universe.origin", [0, 0], "three numbers"),
    ("universe.max_pair_contacts", 1.5, "a whole number from 0"),
    ("universe.islands", 1, "true or false"),
    ("universe.welds", "yes", "true or false"),
    ("parts[0].velocity", "mesured", '"measured", or an object with linear and spin'),
    ("parts[0].velocity", {"linear": [1, 2]}, "three numbers", "parts[0].velocity.linear is [1,2]"),
    ("parts[0].geometries[0].fast", 1, "true or false"),
    ("parts[0].geometries[0].sequence", {"files": []}, "at least one file"),
    ("parts[0].geometries[0].sequence", {"files": ["none.ply"]}, "a file that can be read",
     'parts[0].geometries[0].sequence.files[0] is "none.ply"'),
    ("policies[0].contact_distance", -1, "not negative"),
    ("universe.events[0]", "all", '"pairs", "persist", "contacts" or "elements"'),
    ("layers.ground", 64, "a whole number from 0 to 63"),
    ("shapes.ball.kind", "orb", "a kind of shape of this build: sphere, box"),
    ("shapes.ball.kind", "spere", "did you mean 'sphere'?"),
    ("shapes.ball", {"kind": "sphere", "raduis": 1}, "a field \"radius\" in it; is 'raduis' meant to be it?"),
    ("shapes.ball.radius", -1, "the library says: radius is -1",
     'shapes.ball is {"kind":"sphere","radius":-1}'),
    ("shapes.ball.radius", "1", "a number"),
    ("shapes.ball.raduis", 1, "no field of this name; there are: comment, kind, radius; did you mean 'radius'?"),
    ('shapes["my box"]', {"kind": "box", "half": [1, 1]}, "three numbers", 'shapes["my box"].half is [1,1]'),
    ("shapes.sheet.vertices[1]", [1, 0], "three numbers"),
    ("shapes.sheet.vertices[1][2]", None, "a number"),
    ("shapes.sheet.triangles[0][1]", -1, "a whole number from 0"),
    ("shapes.sheet.triangles[0]", [0, 1, 7], "the library says: ", "shapes.sheet is {"),
    ("shapes.sheet.file", "sheet.obj", "either a file or vertices", "shapes.sheet is {"),
    ("shapes.pair.children[1].shape", "blal", "the name of a shape of the scene, or a shape, {\"kind\": ...}; there are: ball, land, pair, sheet; did you mean"),
    ("shapes.pair.children[0].shape", "pair", "not made of itself"),
    ("shapes.pair.children", [], "the library says: count is 0", "shapes.pair.children is []"),
    ("shapes.land.heights[1]", [0, 1, 2], "as many as in the row before"),
    ("parts", {}, "a list of parts"),
    ("parts[0].name", "a/b", "without [, ] and /"),
    ("parts[1].name", "ball", "no other part has"),
    ("parts[0].motion", "fixed", '"dynamic", "animated" or "static"'),
    ("parts[0].pose.position", "here", "three numbers"),
    ("parts[0].pose.quaternion", [2, 0, 0, 0], "of length 1 within 0.001"),
    ("parts[0].pose.axis", [0, 0, 0], "a direction"),
    ("parts[0].pose.degrees", 90, 'a field "axis" in it', 'parts[0].pose is {"degrees":90,'),
    ("parts[0].geometries", None, "a list of geometries"),
    ("parts[0].geometries[0].tolerance", -1e-3, "not negative"),
    ("parts[0].geometries[0].sensor", 1, "true or false"),
    ("parts[0].sleep", 1, "true or false"),
    ("parts[0].sleep.steps", 0, "a whole number from 1 to"),
    ("parts[0].sleep.linear_speed", -1, "not negative"),
    ("parts[0].sleep.speed", 1, "no field of this name"),
    ("parts[0].geometries[0].layers", ["grund"], "the name of a layer that the scene declares: ground",
     'parts[0].geometries[0].layers[0] is "grund"'),
    ("parts[0].geometries[0].layers[0]", 64, "from 0 to 63"),
    ("parts[0].geometries[0].label", "wheel", "it declares none"),
    ("parts[0].geometries[0].parking", "away", '"none", "short_term" or "long_term"'),
    ("parts[0].grid", {"count": [2, 0, 1], "spacing": [1, 1, 1]}, "a whole number from 1", "parts[0].grid.count[1] is 0"),
    ("parts[0].grid", {"count": [9999, 9999, 9999], "spacing": [1, 1, 1]}, "at most 10000000 copies",
     "parts[0].grid.count is [9999,9999,9999]"),
    ("parts[0].grid", {"count": [9, 1, 1], "spacing": [1e308, 1, 1]}, "what a number can hold", "parts[0].grid is {"),
    ("parts[0].scatter", {"count": 3, "minimum": [0, 0, 0], "maximum": [1, 1, 1]}, 'a field "seed"',
     'parts[0].scatter is {"count":3,'),
    ("parts[0].scatter", {"count": 3, "seed": 1, "minimum": [0, 2, 0], "maximum": [1, 1, 1]}, "not below",
     "parts[0].scatter.maximum is [1,1,1]"),
    ("parts[1].script", {}, "either keyframes"),
    ("parts[1].script", {"keyframes": [{"time": 1}, {"time": 1}]}, "a time after that of the keyframe before",
     "parts[1].script.keyframes[1].time is 1"),
    ("parts[1].motion", "static", "no script on a static part", 'parts[1].script is {"velocity":[1,0,0]}'),
    ("rules[0].a.part", "bal", "the name of a part of the scene; there are: ball, pair; did you mean 'ball'?"),
    ("rules[0].a.geometry", "lid", "the name of a geometry of the part; there are: 0"),
    ("rules[0].b", "all", '"any", {"label"'),
    ("rules[0].rule", "off", '"enable" or "disable"'),
    ("policies[0].tags", ["near"], "two tags"),
    ("policies[0].period", 0, "a whole number from 1"),
    ("policies[0].algorithm", "fast", '"libccd_gjk" or "libccd_mpr"'),
    ("focus.centres", [0, 0, 0], "three numbers", "focus.centres[0] is 0"),
    ("focus.far_tag", "away", "the name of a tag that the scene declares: far, near"),
    ("focus.near_distance", -1, "not negative"),
    ("focus.far_distance", 0.5, "the library says: focus.far_distance is 0.5", "focus: "),
]

# Texts that are no JSON, or not only that; what the message says.
TEXTS = [
    ('{"version": 1,\n "parts": [}\n', "line 2, column 12"),
    ('{"version": 1, "parts": []', "line 1, column 27"),
    ("", "line 1, column 1"),
    ('{"version": 1, "parts": [],}', "line 1, column 28"),
    ('{"version": 1, "dt": 1e999, "parts": []}', "1e999"),
    ('{"version": 1, "parts": [], "parts": []}', 'the scene has the name "parts" twice'),
    ('{"version": 1, "parts": [{"name": "a", "pose": {"axis": [1, 0, 0], "axis": [0, 0, 1]}}]}',
     'parts[0].pose has the name "axis" twice'),
    ('{"version": 1, "parts": ' + "[" * 100 + "]" * 100 + "}", "at most 64 levels"),
    ('{"version": NaN, "parts": []}', "line 1, column 1"),
    ('{"version": "\u00e9\n"}', "line 1, column 16"),
    ("[1]", "the scene is [1]; expected an object"),
    ('{"version": 1, "parts": []} x', "line 1, column 29"),
]


def put(document, path, value):
    """Sets what a path such as parts[3].pose names."""
    steps = [json.loads(s) if s.startswith('"') else int(s) if s.isdigit() else s
             for s in path.replace("[", ".").replace("]", "").split(".")]
    for step in steps[:-1]:
        document = document[step] if isinstance(document, list) else document.setdefault(step, {})
    document[steps[-1]] = value


class Mistakes(program.Case):
    def refuse(self, scene, *words):
        """Both commands answer with status 1 and one line, and leave nothing behind."""
        before = sorted(self.folder.iterdir())
        outputs = ("--contacts", self.folder / "c.csv", "--events", self.folder / "e.json")
        for arguments in (("run", scene, *outputs), ("explain", scene)):
            result = run(*arguments)
            self.assertEqual(result.returncode, 1, result.stdout)
            self.assertEqual(result.stdout, "")
            self.assertRegex(result.stderr, r"^[ -~]+\n$")
            for word in words:
                self.assertIn(word, result.stderr)
            self.assertTrue(result.stderr.startswith(f"abut: {scene}: "), result.stderr)
        self.assertEqual(sorted(self.folder.iterdir()), before)

    def test_the_scene_without_mistakes_is_taken(self):
        self.succeed("run", self.scene(GOOD))

    def test_each_mistake_is_told_with_place_value_and_expectation(self):
        for path, value, expectation, *elsewhere in MISTAKES:
            with self.subTest(path=path, value=value):
                document = copy.deepcopy(GOOD)
                put(document, path, value)
                told = elsewhere[0] if elsewhere else f"{path} is {json.dumps(value, separators=(',', ':'))}; expected"
                self.refuse(self.scene(document), told, expectation)

    def test_a_mistake_in_the_text_is_told_with_line_and_column(self):
        for text, expectation in TEXTS:
            with self.subTest(text=text[:50]):
                self.refuse(self.scene(text), expectation)

    def test_fields_that_are_missing_are_named(self):
        for path, field in (("", "version"), ("", "parts"), ("shapes.ball", "kind"), ("shapes.ball", "radius"),
                            ("shapes.sheet", "triangles"), ("parts[0]", "geometries"), ("rules[0]", "rule"),
                            ("policies[0]", "tags"), ("focus", "centres"), ("focus", "far_distance")):
            with self.subTest(path=path, field=field):
                document = copy.deepcopy(GOOD)
                place = document
                for step in filter(None, path.replace("[", ".").replace("]", "").split(".")):
                    place = place[int(step)] if step.isdigit() else place[step]
                del place[field]
                self.refuse(self.scene(document), path or "the scene", f'a field "{field}" in it')

    def test_files_beside_the_scene(self):
        (self.folder / "bad.obj").write_text("v 0 0 0\nv 1 0 0\nf 1 2 9\n")
        (self.folder / "bad.txt").write_text("0 0 zero")
        (self.folder / "bad.pgm").write_bytes(b"P5 2 2 255\n\0\0")
        (self.folder / "grey.pgm").write_bytes(b"P5 2 2 255\n\0\0\0\0")
        for shape, words in (
            ({"kind": "hull", "file": "none.obj"}, ("cannot open", "none.obj")),
            ({"kind": "mesh", "file": "bad.obj"}, ("3: f 1 2 9",)),
            ({"kind": "hull", "file": "bad.txt"}, ("'zero'",)),
            ({"kind": "height_field", "spacing_x": 1, "spacing_y": 1, "file": "bad.pgm"}, ("ends too early",)),
            ({"kind": "hull", "file": "grey.pgm"}, (".obj, .stl or .ply for hulls",)),
            ({"kind": "hull", "file": "."}, ("is a folder",)),
            ({"kind": "hull", "file": 3}, ("a text",)),
        ):
            with self.subTest(shape=shape):
                document = copy.deepcopy(GOOD)
                document["shapes"]["from file"] = shape
                told = f'shapes["from file"].file is {json.dumps(shape["file"])}; expected'
                self.refuse(self.scene(document), told, *words)

    def test_a_scene_that_cannot_be_read(self):
        self.refuse(self.folder / "none.json", "cannot be opened")
        self.refuse(self.folder, "cannot be opened")

    def test_arguments(self):
        scene = self.scene(GOOD)
        for arguments, words in (
            ([], ("no command",)),
            (["chekc", scene], ("chekc", "there are: run, explain, check", "did you mean 'check'?")),
            (["run"], ("no argument is given", "expected abut run SCENE")),
            (["run", scene, scene], ("one argument too many",)),
            (["run", scene, "--steps", "0"], ("--steps is '0'", "expected a whole number")),
            (["run", scene, "--steps", "1e3"], ("1e3",)),
            (["run", scene, "--steps="], ("--steps is ''",)),
            (["run", scene, "--steps"], ("--steps needs a value",)),
            (["run", scene, "--dt", "nan"], ("--dt is 'nan'", "not negative")),
            (["run", scene, "--dt=-1"], ("--dt is '-1'",)),
            (["run", scene, "--threads", "many"], ("--threads is 'many'",)),
            (["run", scene, "--colour", "red"], ("run has no option '--colour'", "--contacts, --elements, --events")),
            (["run", scene, "--contcats=x"], ("did you mean '--contacts'?",)),
            (["run", scene, "--quiet=yes"], ("--quiet takes no value",)),
            (["shapes", "--steps", "2"], ("shapes has no option '--steps'; it takes: --json",)),
            (["manual", "--json"], ("manual has no option '--json'; it takes none",)),
            (["run", scene, "--contacts", "x.csv", "--events", "x.csv"], ("different files",)),
            (["run", scene, "--contacts", "x.csv", "--events", "./x.csv"], ("different files",)),
            (["run", scene, "--contacts", "x.csv", "--elements", "x.csv"], ("--contacts and --elements", "different files")),
            (["run", scene, "--elements", "x.csv", "--events", "x.csv"], ("--elements and --events", "different files")),
            (["explain", scene, "--contacts", "x.csv"], ("--contacts",)),
            (["explain", "pair", scene, "a"], ("2 arguments are given", "expected abut explain pair SCENE A B")),
            (["explain", "pair", scene, "a", "b", "c"], ("'c'", "one argument too many")),
            (["explain", "pair", scene, "nobody", "b"], ("'nobody'", "PART/GEOMETRY", "there are: ball, pair")),
            (["check", scene, "ball"], ("2 arguments are given", "expected abut check SCENE [A B]")),
            (["check", scene, "bal", "pair"], ("there is no geometry 'bal'", "did you mean 'ball'?")),
            (["check", scene, "ball", "ball"], ("one geometry", "expected two")),
            (["shapes", scene], ("one argument too many",)),
        ):
            with self.subTest(arguments=arguments):
                result = run(*arguments)
                self.assertEqual(result.returncode, 1)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
                for word in words:
                    self.assertIn(word, result.stderr)


if __name__ == "__main__":
    program.main()
