# SPDX-License-Identifier: Apache-2.0
"""What Doxygen reads in place of a header and of a page, on small ones."""

import re
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import headers
import names
import pages

HEADER = """/* SPDX-License-Identifier: Apache-2.0 */
/*
 * abut.h - all of it.
 */

#define ABUT_LIMIT 3

/* ------------------------------------------------------------------------------------------------
 * Values: docs/values.md
 *
 * They are small.
 * --------------------------------------------------------------------------------------------- */

/** Two numbers. */
typedef struct abut_pair {
  double first; /**< the one */
  double second;
} abut_pair;

typedef uint32_t abut_side;
enum abut_side_value ABUT_ENUM(uint32_t) {
  ABUT_SIDE_LEFT = 0,
  ABUT_SIDE_RIGHT = 1 /**< not ABUT_SIDE_LEFT, nor ABUT_SIDE_TOP */
};

/* ------------------------------------------------------------------------------------------------
 * Functions
 * --------------------------------------------------------------------------------------------- */

ABUT_API void abut_pair_init(abut_pair *pair, uint32_t struct_size);

/** Adds an abut_pair up. [any] */
ABUT_API double abut_pair_sum(const abut_pair *pair);
"""

PAGE = """# All `values`

<!-- given: abut_pair p; -->
A call of `abut_pair_sum(p)` is no name, `abut_pair_sum` is one. See [the
other](other.md#its-end) and [here](#all-of-them), [the header](../include/abut/abut.h), [code](../examples/a.c).

## All of them

```c
double sum = abut_pair_sum(&pair); /* [not a link](x.md) */
```
"""


def site():
    return names.Site({"docs/values.md": PAGE, "docs/other.md": "# Other\n", "README.md": "# abut\n"}, {"abut": HEADER})


class ContentsTest(unittest.TestCase):
    def test_the_head_of_abut_h_lists_its_sections_in_order(self):
        text = Path(__file__).resolve().parents[2].joinpath("include/abut/abut.h").read_text(encoding="utf-8")
        head, _, rest = text.partition("#ifndef")
        contents = head[head.index("Contents") :]
        titles = [re.split("[:,] what|, for|:", title)[0] for title in re.findall(r"^/\* -{20,}\n \* (.+)$", rest, re.MULTILINE)]
        self.assertEqual(re.findall(r"^ \*  - ([^:]+):", contents, re.MULTILINE), titles)
        self.assertLessEqual(set(names.NAME.findall(contents)), names.declared(text))


class NamesTest(unittest.TestCase):
    def test_every_kind_of_name_is_found(self):
        self.assertEqual(site().names, {"ABUT_LIMIT", "abut_pair", "abut_side", "ABUT_SIDE_LEFT", "ABUT_SIDE_RIGHT", "abut_pair_init",
                                        "abut_pair_sum"})

    def test_comments_declare_nothing(self):
        self.assertEqual(names.declared("/* ABUT_API int abut_old(void); */"), set())


class HeaderTest(unittest.TestCase):
    def setUp(self):
        self.turned = headers.for_doxygen(HEADER, "abut", site())

    def test_no_line_moves(self):
        turned = self.turned.split("\n")
        for number, line in enumerate(HEADER.split("\n")):
            if line.startswith(("ABUT_API", "typedef", "#define")):
                self.assertIn(line, turned[number])

    def test_sections_become_groups_that_end_before_the_next_one(self):
        self.assertIn('@defgroup section_abut_values Values\n * @ref page_values "All values".\n *\n * They are small.\n * @{ */', self.turned)
        self.assertIn("/** @} */ /** @defgroup section_abut_functions Functions", self.turned)
        self.assertEqual(self.turned.count("@{"), self.turned.count("@}"))

    def test_what_has_no_comment_is_described_by_its_name(self):
        self.assertIn("double second; /**< second */", self.turned)
        self.assertIn("ABUT_SIDE_LEFT = 0, /**< side left */", self.turned)
        self.assertIn("#define ABUT_LIMIT 3 /**< limit */", self.turned)
        self.assertIn('/** Fills @ref abut_pair "abut_pair" with defaults;', self.turned)

    def test_what_has_a_comment_keeps_it(self):
        self.assertNotIn("/**< first */", self.turned)
        self.assertNotIn("Each field", self.turned)

    def test_names_in_comments_lead_to_what_is_declared(self):
        self.assertIn('not @ref ABUT_SIDE_LEFT "ABUT_SIDE_LEFT", nor ABUT_SIDE_TOP', self.turned)
        self.assertIn('@ref page_threads "[any]"', self.turned)

    def test_functions_lead_to_the_pages_that_speak_of_them(self):
        self.assertRegex(self.turned, r'"\[any\]" +@see @ref page_values "All values" \*/\nABUT_API double abut_pair_sum')


class PageTest(unittest.TestCase):
    def setUp(self):
        self.turned = pages.for_doxygen(PAGE, "docs/values.md", site())

    def test_headings_have_anchors(self):
        self.assertIn("# All values {#page_values}", self.turned)
        self.assertIn("## All of them {#page_values_all-of-them}", self.turned)

    def test_links_lead_to_pages_anchors_headers_and_files(self):
        self.assertIn("\n[the other](@ref page_other_its-end) and [here](@ref page_values_all-of-them)", self.turned)
        self.assertIn("[the header](@ref abut.h), [code](files/examples/a.c)", self.turned)
        self.assertEqual(pages.linked_files(PAGE, "docs/values.md", site()), {"examples/a.c"})

    def test_names_lead_to_the_reference_unless_they_are_part_of_code(self):
        self.assertIn('`abut_pair_sum(p)` is no name, <code>@ref abut_pair_sum "abut_pair_sum"</code> is one', self.turned)
        self.assertIn("double sum = abut_pair_sum(&pair); /* [not a link](x.md) */", self.turned)

    def test_lines_stay_and_hidden_code_goes(self):
        self.assertEqual(self.turned.count("\n"), PAGE.count("\n"))
        self.assertNotIn("given", self.turned)


@unittest.skipUnless(shutil.which("doxygen"), "Doxygen is missing")
class DoxygenTest(unittest.TestCase):
    def complaints(self, header):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "abut.h").write_text(header, encoding="utf-8")
            settings = f"INPUT={folder}\nOUTPUT_DIRECTORY={folder}\nQUIET=YES\nOPTIMIZE_OUTPUT_FOR_C=YES\nMACRO_EXPANSION=YES\n"
            settings += 'EXPAND_ONLY_PREDEF=YES\nPREDEFINED=ABUT_API= "ABUT_ENUM(type)="\nGENERATE_LATEX=NO\nHAVE_DOT=NO\n'
            return subprocess.run(["doxygen", "-"], input=settings, capture_output=True, text=True, check=True).stderr

    def test_a_turned_header_has_no_complaint_but_for_pages_that_are_not_there(self):
        turned = headers.for_doxygen(HEADER, "abut", names.Site({}, {"abut": HEADER}))
        self.assertEqual(self.complaints(turned.replace('@ref page_threads "[any]"', "[any]")), "")

    def test_a_function_without_a_comment_is_told(self):
        turned = headers.for_doxygen(HEADER + "\nABUT_API void abut_bare(void);\n", "abut", names.Site({}, {"abut": HEADER}))
        self.assertIn("abut_bare", self.complaints(turned))


if __name__ == "__main__":
    unittest.main()
