# SPDX-License-Identifier: Apache-2.0
"""Tests of what checks the documents: a check that finds nothing shows nothing."""

import pathlib
import tempfile
import unittest

from check_code import excerpt_failure, json_failure, python_failure, shell_failure
from check_links import anchors, failures_of
from check_sofa import failures_of as row_failures_of
from check_sofa import rows_of, tests_of
from compiled import Compiler, source_of
from pages import BadPage, blocks


def only_block(text):
    (block,) = blocks("page.md", text)
    return block


class Blocks(unittest.TestCase):
    def test_a_block_knows_its_place_language_and_markers(self):
        block = only_block("# A\n\ntext\n\n<!-- given:\nint i = 1;\n-->\n<!-- no-run: it never ends -->\n```c\nint j = i;\n```\n")
        self.assertEqual((block.place, block.language, block.code), ("page.md:10", "c", "int j = i;\n"))
        self.assertEqual(block.markers, {"given": "int i = 1;", "no-run": "it never ends"})

    def test_a_marker_counts_directly_before_its_block_only(self):
        self.assertEqual(only_block("<!-- no-check: old -->\ntext\n```c\n;\n```\n").markers, {})
        self.assertEqual(only_block("<!-- a remark -->\n\n```c\n;\n```\n").markers, {})

    def test_a_block_of_text_directly_below_is_the_output(self):
        page = "```c\nf();\n```\n\n```text\n1\n```\nwords\n```text\n2\n```\n"
        first, second = blocks("page.md", page)
        self.assertEqual((first.output, second.language), ("1\n", "text"))
        self.assertEqual(first.wrong_output("1"), "")
        self.assertEqual(first.wrong_output("3"), "page.md:2: prints\n3\ninstead of\n1\n")
        self.assertEqual(second.wrong_output("3"), "")

    def test_a_block_in_a_list_loses_its_indent(self):
        self.assertEqual(only_block("- a\n\n  ```c\n  f();\n    g();\n  ```\n").code, "f();\n  g();\n")

    def test_a_marker_without_a_reason_and_a_block_without_an_end_are_errors(self):
        for text in ("<!-- no-run: -->\n```c\n;\n```\n", "```c\n;\n"):
            with self.assertRaises(BadPage):
                blocks("page.md", text)


class Sources(unittest.TestCase):
    def test_a_program_stays_whole(self):
        self.assertNotIn("fragment", source_of(only_block("```c\nint main(void) { return 0; }\n```\n"), []))

    def test_a_fragment_takes_what_it_continues(self):
        page = "```c\nint i;\n```\n<!-- file scope -->\n```c\nint f(void);\n```\n<!-- continues -->\n```c\n#include <a.h>\ni = 1;\n```\n"
        first, scope, last = blocks("page.md", page)
        self.assertEqual(Compiler._chain(last, [first, scope]), [scope])
        outside, inside = source_of(last, [scope]).split("void fragment(void) {")
        self.assertIn("int f(void);", outside)
        self.assertIn("#include <a.h>", outside)
        self.assertIn('#line 10 "page.md"', inside)


class Excerpts(unittest.TestCase):
    def test_lines_stand_in_the_file_in_a_row(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "a.cpp").write_text("  f();\n\n  g();\n  h();\n", encoding="utf-8")
            for code, is_there in (("f();\ng();\n", True), ("f();\nh();\n", False)):
                block = only_block(f"<!-- from: a.cpp -->\n```cpp\n{code}```\n")
                self.assertEqual(excerpt_failure(block, root) == "", is_there)


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.root = pathlib.Path(__file__).resolve().parents[2]

    def python(self, text):
        return python_failure("page.md", blocks("page.md", text), self.root, self.folder, "")

    def shell(self, text):
        return shell_failure(only_block(text), self.root, self.folder, pathlib.Path("/bin/true"))

    def test_blocks_of_python_run_one_after_the_other(self):
        page = "<!-- given: j = 1 -->\n```python\ni = j\n```\n\n```python\nassert i == {}\n```\n"
        self.assertEqual(self.python(page.format(1)), "")
        self.assertIn('File "page.md", line 7', self.python(page.format(2)))

    def test_output_of_python_is_compared_block_by_block(self):
        page = "```python\nprint(1)\n```\n```python\nprint(2)\n```\n```text\n{}\n```\n"
        self.assertEqual(self.python(page.format(2)), "")
        self.assertIn("page.md:5: prints\n2\ninstead of\n3", self.python(page.format(3)))

    def test_python_that_lacks_a_library_of_others_is_passed_over(self):
        self.assertEqual(self.python("```python\nimport no_library_of_this_name\n```\n"), "")
        self.assertIn("abut_of_no_such_name", self.python("```python\nimport abut_of_no_such_name\n```\n"))

    def test_commands_name_files_that_exist(self):
        self.assertEqual(self.shell("```sh\nscripts/test quick\n```\n"), "")
        self.assertEqual(self.shell("```sh\nscripts/tests\n```\n"), "page.md:2: there is no scripts/tests")
        self.assertIn("syntax", self.shell("```sh\nif\n```\n"))

    def test_commands_run_where_they_are_marked(self):
        self.assertEqual(self.shell("```sh\nfalse\n```\n"), "")
        self.assertEqual(self.shell("<!-- run -->\n```sh\necho 1\n```\n```text\n1\n```\n"), "")
        self.assertIn("instead of", self.shell("<!-- run -->\n```sh\necho 1\n```\n```text\n2\n```\n"))
        self.assertIn("fails with 1", self.shell("<!-- run -->\n```sh\nls examples/scenes\nfalse\ntrue\n```\n"))

    def test_json_is_whole(self):
        for code, is_whole in (('{"a": 1}', True), ('{"a": 1', False)):
            block = only_block(f"```json\n{code}\n```\n")
            self.assertEqual(json_failure(block, self.root, self.folder, None) == "", is_whole)

    def test_a_scene_is_stepped(self):
        block = only_block('```json\n{"parts": []}\n```\n')
        self.assertEqual(json_failure(block, self.root, self.folder, pathlib.Path("/bin/true")), "")
        self.assertIn("fails with 1", json_failure(block, self.root, self.folder, pathlib.Path("/bin/false")))


class Links(unittest.TestCase):
    def failures(self, text):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            (root / "other.md").write_text("# The `abut` way, twice\n## A b\n## A b\n", encoding="utf-8")
            page = root / "page.md"
            page.write_text(text, encoding="utf-8")
            return list(failures_of(page, root))

    def test_files_and_headings_are_found(self):
        self.assertEqual(self.failures("[a](other.md) [b](other.md#a-b-1) ![c](https://nowhere) `[d](no.md)`\n# E f\n[e](#e-f)"), [])
        self.assertEqual(anchors("# The `abut` way, twice"), {"the-abut-way-twice"})

    def test_what_is_missing_is_told_with_its_line(self):
        self.assertEqual(self.failures("\n[a](no.md)"), ["page.md:2: there is no no.md"])
        self.assertEqual(self.failures("[a](other.md#c)"), ["page.md:1: other.md has no heading #c"])
        self.assertEqual(self.failures("[a](#c)"), ["page.md:1: this page has no heading #c"])
        self.assertEqual(len(self.failures("[a](../../etc)")), 1)


class Rows(unittest.TestCase):
    def failures(self, rows, tests):
        page = "## Broad phases\n\n| SOFA | here | mind |\n|---|---|---|\n" + rows
        return list(row_failures_of(rows_of(page), tests_of(tests)))

    def test_a_row_and_its_test_name_each_other(self):
        self.assertEqual(self.failures("| `a::b_c` (`C`) | `f`, `g` | |\n", "TEST(BroadPhases, Abc) {\n  f(g);\n}\n"), [])

    def test_a_row_without_a_test_and_a_test_without_a_row_fail(self):
        self.assertEqual(self.failures("| `A` | `f` | |\n", "TEST(BroadPhases, B) {\n  f();\n}\n"),
                         ["line 5: there is no test BroadPhases.A", "there is no row for the test BroadPhases.B"])

    def test_a_test_calls_what_its_row_names(self):
        self.assertEqual(self.failures("| `A` | `f` | |\n", "TEST(BroadPhases, A) {\n  ff();\n}\n"),
                         ["line 5: the test BroadPhases.A does not name f"])

    def test_a_dash_needs_a_sentence_and_no_test(self):
        self.assertEqual(self.failures("| `A` | - | Nothing runs on it. |\n", ""), [])
        self.assertEqual(len(self.failures("| `A` | - | |\n", "")), 1)
        self.assertEqual(len(self.failures("| `A` | - | Nothing runs on it. |\n", "TEST(BroadPhases, A) {\n}\n")), 1)

    def test_a_name_has_one_row(self):
        self.assertEqual(len(self.failures("| `A` | - | Nothing runs on it. |\n" * 2, "")), 1)


if __name__ == "__main__":
    unittest.main()
