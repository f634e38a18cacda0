#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tool that draws report.json: what it writes, what it refuses, and what it finds between two reports."""

import copy
import json
import platform
import re
import subprocess
import sys
import tempfile
import unittest
from html.parser import HTMLParser
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools" / "report"))

import compare  # noqa: E402
import condense  # noqa: E402
import document  # noqa: E402
import maps  # noqa: E402
import page  # noqa: E402
import pairs  # noqa: E402
import publish  # noqa: E402
import questions  # noqa: E402
import sample  # noqa: E402
import words  # noqa: E402
import work  # noqa: E402

VOID = {"meta", "br", "hr", "img", "input", "link"}


class Balance(HTMLParser):
    """Elements that are open, ids, and where links go."""

    def __init__(self):
        super().__init__()
        self.open, self.ids, self.links = [], [], []

    def handle_starttag(self, tag, attributes):
        if tag not in VOID:
            self.open.append(tag)
        self._note(attributes)

    def handle_startendtag(self, tag, attributes):
        self._note(attributes)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            raise AssertionError(f"</{tag}> closes another element")

    def _note(self, attributes):
        for name, value in attributes:
            if name == "id":
                self.ids.append(value)
            elif name in ("href", "xlink:href"):
                self.links.append(value)


def parsed(html):
    its = Balance()
    its.feed(html)
    return its


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.html = page.render(document.check(sample.document()))
        cls.its = parsed(cls.html)

    def test_elements_are_closed_and_ids_are_unique(self):
        self.assertEqual(self.its.open, [])
        self.assertEqual(len(self.its.ids), len(set(self.its.ids)))

    def test_links_lead_to_places_of_the_page(self):
        self.assertTrue(self.its.links)
        for link in self.its.links:
            self.assertTrue(link.startswith("#"), link)
            self.assertIn(link[1:], self.its.ids)

    def test_nothing_is_loaded(self):
        self.assertEqual(re.findall(r"""(?:src=|@import|url\((?!#))[^\n]{0,40}""", self.html), [])
        self.assertNotIn("<script", self.html)

    def test_every_part_has_a_section(self):
        for name in ("work-distance", "work-candidates", "work-overlap", "promises", "map-size-ratio-and-aspect", "moving", "stiff-spring", "steady", "universe", "builds", "pairs"):
            self.assertIn(name, self.its.ids)

    def test_text_is_escaped_everywhere(self):
        evil = '<script>alert("&")</script>'
        hostile = sample.document()
        hostile["machine"][evil] = evil
        for name in ("accuracy", "extremes"):
            for row in hostile[name]["rows"]:
                row["contender"] = evil + row["contender"]
            hostile[name]["shapes"][0]["kind"] = evil
        hostile["accuracy"]["rows"][0]["condition"] = hostile["extremes"]["rows"][0]["map"] = evil
        hostile["response"]["rows"][0]["trial"] = hostile["response"]["rows"][0]["error_is"] = evil
        hostile["response_maps"]["maps"][0]["name"] = hostile["steadiness"]["rows"][0]["ground"] = evil
        hostile["builds"]["rows"][0]["libraries"] = [evil]
        html = page.render(document.check(hostile))
        self.assertNotIn("<script", html)
        self.assertIn("&lt;script&gt;", html)
        self.assertEqual(parsed(html).open, [])

    def test_a_report_of_no_parts_is_a_page(self):
        self.assertEqual(parsed(page.render(document.check({"version": 1, "machine": {}}))).open, [])

    def test_each_contender_has_a_mark_and_a_row(self):
        for name in ("abut", "abut 1e-2", "bullet", "fcl"):
            self.assertIn(f"</svg>{name}</li>", self.html)
            self.assertIn(f"<td>{name}</td>", self.html)

    def test_meshes_that_deform_have_panels_of_their_own(self):
        for title in ("deforming, two sheets", "all pairs"):
            self.assertIn(title, self.html)
        only = sample.document()
        del only["accuracy"]
        self.assertIn('id="work-candidates"', page.render(document.check(only)))

    def test_failures_are_named(self):
        self.assertIn("<td>2 N</td>", self.html)
        self.assertIn("E: the process ended", self.html)

    def test_the_command_of_a_pair_holds_its_numbers(self):
        command = pairs.command(sample.document()["accuracy"], 0)
        scene = json.loads(command.split("'")[1])
        self.assertEqual(scene["parts"][1]["pose"]["position"], [4.0, 0.0, 0.0])
        self.assertEqual(scene["parts"][1]["geometries"][0]["shape"], {"kind": "box", "half": [1.0, 2.0, 3.0]})


class Numbers(unittest.TestCase):
    def test_rows_of_several_pairs_become_one(self):
        one = work.together([sample.judged(nanoseconds=10, worst=1e-3, worst_pair=5), sample.judged(nanoseconds=30, worst=1e-9)])
        self.assertEqual((one["nanoseconds"], one["worst"], one["worst_pair"], one["cases"]), (20, 1e-3, 5, 8))

    def test_a_failure_is_worse_than_any_error(self):
        failed = sample.judged(failures=sample.FAILURES | {"none": 1}, worst_pair=7)
        self.assertEqual(work.together([sample.judged(worst=1.0), failed])["worst_pair"], 7)

    def test_maps_keep_the_order_of_their_axes(self):
        self.assertEqual(maps._places([1, 1e-4, 1e-2, 1]), [1, 1e-2, 1e-4])
        self.assertEqual(maps._places([1, 1e3, 1e2]), [1, 1e2, 1e3])
        self.assertEqual(maps._places(["0", "1 ulp", "1e-9"]), ["0", "1 ulp", "1e-9"])

    def test_numbers_are_short(self):
        self.assertEqual([words.error(value) for value in (None, 0, 1, 2.4e-16, 1961.0)], ["-", "0", "1", "2e-16", "2e3"])
        self.assertEqual([words.time(value) for value in (0, 12.34, 1234, 5.6e7)], ["-", "12.3 ns", "1.23 µs", "56 ms"])

    def test_classes_do_not_depend_on_the_order(self):
        self.assertEqual(work.class_of("box-sphere"), work.class_of("capsule-hull32"))


class Refusal(unittest.TestCase):
    def refused(self, change, *words):
        wrong = sample.document()
        change(wrong)
        with self.assertRaises(document.Wrong) as caught:
            document.check(wrong)
        for word in words:
            self.assertIn(word, str(caught.exception))

    def test_wrong_members_are_named_with_their_values(self):
        self.refused(lambda its: its.update(version=2), "version is 2", "expected 1")
        self.refused(lambda its: its["accuracy"]["rows"][1].update(nanoseconds="fast"), 'accuracy.rows[1].nanoseconds is "fast"', "a number")
        self.refused(lambda its: its["accuracy"]["rows"][2].update(nanoseconds=float("nan")), "accuracy.rows[2].nanoseconds is NaN")
        self.refused(lambda its: its["extremes"]["rows"][0].pop("map"), "extremes.rows[0] has no member map")
        self.refused(lambda its: its["extremes"]["rows"][0].update(worst_pair=9), "extremes.rows[0].worst_pair is 9", "1 pairs")
        self.refused(lambda its: its["accuracy"]["pairs"][0].update(b=4), "accuracy.pairs[0].b is 4", "2 shapes")
        self.refused(lambda its: its["response_maps"]["maps"][0].update(x=3), "response_maps.maps[0].x is 3", "a text")
        self.refused(lambda its: its.update(steadiness=[]), "steadiness is []", "an object")

    def test_files_that_are_no_report_are_refused_by_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "old.json")
            for text, word in (("{", "is no JSON"), ('{"version": 7}', "version is 7"), (None, "cannot be read")):
                if text is None:
                    path.unlink()
                else:
                    path.write_text(text, encoding="utf-8")
                result = subprocess.run([sys.executable, "-B", ROOT / "tools/report/report.py", "--from", path], capture_output=True,
                                        text=True, check=False)
                self.assertEqual(result.returncode, 2)
                self.assertIn("old.json", result.stderr)
                self.assertIn(word, result.stderr)


class Comparison(unittest.TestCase):
    def changed(self, change):
        new = sample.document()
        change(new)
        return list(compare.differences(sample.document(), new))

    def test_equal_reports_have_no_news(self):
        self.assertEqual(self.changed(lambda its: None), [])

    def test_a_slower_machine_is_no_news(self):
        def slow(its):
            for row in its["accuracy"]["rows"]:
                row["nanoseconds"] *= 3
        self.assertEqual(self.changed(slow), [])

    def test_what_got_slower_is_told(self):
        lines = self.changed(lambda its: its["accuracy"]["rows"][0].update(nanoseconds=500.0))
        self.assertEqual(lines, ["accuracy: distance/ordinary/sphere-box/abut takes 10.00 times as long"])

    def test_abut_as_a_whole_is_told_beside_its_peers(self):
        def slow(its):
            for row in its["accuracy"]["rows"]:
                row["nanoseconds"] *= 1.3 if row["contender"].startswith("abut") else 1
        self.assertEqual(self.changed(slow), ["accuracy: abut takes 1.30 times as long, by the times of its peers"])

    def test_what_is_less_exact_or_fails_is_told(self):
        lines = self.changed(lambda its: its["accuracy"]["rows"][0].update(worst=1e-3, failures=sample.FAILURES | {"none": 1}))
        self.assertEqual(len(lines), 2)
        self.assertIn("worst of distance/ordinary/sphere-box/abut is 0.001, it was 1e-15", lines[0])
        self.assertIn("fails in 1 cases, it was 0", lines[1])

    def test_peers_are_no_news(self):
        self.assertEqual(self.changed(lambda its: its["accuracy"]["rows"][3].update(worst=1.0)), [])

    def test_rounding_is_no_news(self):
        self.assertEqual(self.changed(lambda its: its["accuracy"]["rows"][0].update(worst=9e-15)), [])

    def test_larger_builds_are_told(self):
        self.assertEqual(len(self.changed(lambda its: its["builds"]["rows"][0].update(bytes=8000000))), 1)


class Published(unittest.TestCase):
    """docs/report/report.json and the tables that are written from it."""

    @classmethod
    def setUpClass(cls):
        cls.report = document.read(publish.COMMITTED)

    def test_tables_of_documents_are_those_of_the_committed_report(self):
        self.assertEqual(publish.stale(), [], "scripts/report --from docs/report/report.json --publish writes them")

    def test_the_committed_report_is_small_and_whole(self):
        self.assertLess(publish.COMMITTED.stat().st_size, 300_000)
        self.assertTrue(self.report["condensed"])
        for name in ("processor", "compiler", "flags", "peers", "abut", "run", "load"):
            self.assertIn(name, self.report["machine"])
        self.assertNotIn(platform.node(), publish.COMMITTED.read_text(encoding="utf-8"))

    def test_a_number_that_differs_is_seen(self):
        for name in publish.PAGES:
            text = (ROOT / name).read_text(encoding="utf-8")
            start, end = text.index("<!-- report: "), text.index("<!-- report: end -->")
            digit = re.compile(r"(?<=\| )\d").search(text, start, end)
            changed = text[:digit.start()] + str(9 - int(digit[0])) + text[digit.end():]
            self.assertEqual(publish.filled(changed, self.report, name), text)

    def test_tables_without_a_name_are_refused(self):
        with self.assertRaisesRegex(document.Wrong, "page.md has a table none; there are: .*speed"):
            publish.filled("<!-- report: none -->\n<!-- report: end -->", self.report, "page.md")

    def test_the_committed_report_is_drawn(self):
        self.assertEqual(parsed(page.render(self.report)).open, [])


class Peers(unittest.TestCase):
    """What CMake says of the folder with the sources of further libraries."""

    def read(self, folder):
        result = subprocess.run(["cmake", "-D", f"ABUT_PEERS={folder}", "-P", ROOT / "bench/peers/sources.cmake"], capture_output=True,
                                text=True, check=False)
        return result.returncode, " ".join((result.stdout + result.stderr).split())

    @staticmethod
    def box3d(folder):
        for name, text in (("CMakeLists.txt", "project(box3d\n\tVERSION 1.2.3\n)"), ("src/CMakeLists.txt", ""), ("include/box3d/collision.h", "")):
            path = Path(folder, "box3d", name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")

    def test_libraries_that_are_there_are_told_with_their_versions(self):
        with tempfile.TemporaryDirectory() as folder:
            self.box3d(folder)
            status, text = self.read(folder)
        self.assertEqual(status, 0, text)
        self.assertIn("Peers from sources: box3d 1.2.3", text)
        self.assertIn("ABUT_PEERS has no coal", text)

    def test_what_is_missing_is_named(self):
        with tempfile.TemporaryDirectory() as folder:
            for where, words in ((Path(folder, "none"), ("which is no folder",)), (folder, ("which holds none of the folders", "JoltPhysics"))):
                status, text = self.read(where)
                self.assertEqual(status, 1)
                for word in (f"ABUT_PEERS is '{where}'", *words):
                    self.assertIn(word, text)
            self.box3d(folder)
            Path(folder, "box3d/src/CMakeLists.txt").unlink()
            status, text = self.read(folder)
            self.assertEqual(status, 1)
            self.assertIn("its box3d has no src/CMakeLists.txt", text)


class Condensed(unittest.TestCase):
    def setUp(self):
        self.report = condense.condensed(document.check(sample.document()))

    def test_it_is_a_report(self):
        its = parsed(page.render(document.check(self.report)))
        for name in ("work-distance", "maps", "universe", "pairs"):
            self.assertIn(name, its.ids)

    def test_rows_are_the_marks_of_the_page(self):
        rows = [row for row in self.report["accuracy"]["rows"] if row["contender"] == "abut"]
        self.assertEqual([(row["condition"], row["pair"]) for row in rows],
                         [("ordinary", "round and polytope"), ("ordinary", "round and round"), ("far", "far")])

    def test_condensing_twice_changes_nothing(self):
        again = condense.condensed(self.report)
        for name in ("accuracy", "promises", "questions", "extremes_by_map", "steadiness_by_ground"):
            self.assertEqual(again.get(name), self.report.get(name), name)

    def test_failures_of_extremes_are_counted(self):
        row = next(row for row in self.report["extremes_by_map"] if row["contender"] == "abut" and row["failures"])
        self.assertEqual((row["failures"], row["places_failed"], row["places"]), ({"ended": 4}, 1, 4))

    def test_an_answer_that_is_off_or_gives_fewer_contacts_is_another(self):
        ours = sample.judged(points=4.0)
        for other, expected in ((ours, False), (ours | {"points": 1.0}, True), (ours | {"p99": 0.1}, True),
                                (ours | {"failures": sample.FAILURES | {"none": 1}}, True)):
            self.assertEqual(questions._answer(other, ours)["is_other"], expected)


class Program(unittest.TestCase):
    def test_every_picture_is_made_again_from_json_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "report.json")
            path.write_text(json.dumps(sample.document()), encoding="utf-8")
            texts = []
            for name in ("one", "two"):
                out = Path(folder, name)
                subprocess.run([sys.executable, "-B", ROOT / "tools/report/report.py", "--from", path, "--out", out], capture_output=True,
                               check=True)
                self.assertEqual([file.name for file in out.iterdir()], ["index.html"])
                texts.append((out / "index.html").read_bytes())
            self.assertEqual(texts[0], texts[1])

    def test_compare_fails_where_something_got_worse(self):
        worse = copy.deepcopy(sample.document())
        worse["accuracy"]["rows"][0]["worst"] = 1.0
        with tempfile.TemporaryDirectory() as folder:
            for name, its in (("old", sample.document()), ("new", worse)):
                Path(folder, name).write_text(json.dumps(its), encoding="utf-8")
            result = subprocess.run([sys.executable, "-B", ROOT / "tools/report/report.py", "--from", Path(folder, "new"), "--compare",
                                     Path(folder, "old")], capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("worst of distance/ordinary/sphere-box/abut is 1", result.stdout)


if __name__ == "__main__":
    unittest.main()
