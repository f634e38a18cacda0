# SPDX-License-Identifier: Apache-2.0
"""A picture refuses text that nobody can read, and every picture stands in a document."""

import re
import unittest
import xml.etree.ElementTree
from pathlib import Path

from draw import FOLDER, PICTURES, ROOT, stale
from layers import FLOORS
from palette import COLOURS, GROUND
from picture import Picture
from tree_rules import RANKS


class PictureTest(unittest.TestCase):
    def setUp(self):
        self.picture = Picture(200, 100, "a picture")
        self.picture.text(20, 50, "first")

    def test_small_text_is_refused(self):
        with self.assertRaisesRegex(ValueError, "size 11"):
            self.picture.text(20, 80, "second", size=11)

    def test_text_beyond_the_border_is_refused(self):
        with self.assertRaisesRegex(ValueError, "leaves the picture"):
            self.picture.text(150, 80, "a long line of text")

    def test_text_on_other_text_is_refused(self):
        with self.assertRaisesRegex(ValueError, "'second' runs into 'first'"):
            self.picture.text(40, 55, "second")

    def test_text_beside_other_text_is_drawn(self):
        self.picture.text(20, 80, "a < b")
        self.assertIn(">a &lt; b</text>", self.picture.svg())


def _brightness(colour):
    """Relative luminance by the Web Content Accessibility Guidelines 2."""
    channels = [int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def _contrast(first, second):
    darker, brighter = sorted((_brightness(first), _brightness(second)))
    return (brighter + 0.05) / (darker + 0.05)


class PaletteTest(unittest.TestCase):
    def test_text_stands_out_from_the_ground_and_from_areas_in_light_and_dark(self):
        for name, (full, pale) in COLOURS.items():
            for side, ground in enumerate(GROUND):
                with self.subTest(name=name, side=side):
                    self.assertGreaterEqual(_contrast(full[side], ground), 4.5)
                    self.assertGreaterEqual(_contrast(full[side], pale[side]), 4.5)
                    self.assertGreaterEqual(_contrast(COLOURS["ink"][0][side], pale[side]), 4.5)


class FolderTest(unittest.TestCase):
    def test_pictures_that_nobody_draws_are_named(self):
        others = [(FOLDER / f"{name}.svg", (FOLDER / f"{name}.svg").read_text(encoding="utf-8")) for name in PICTURES[1:]]
        self.assertEqual(stale(others), [FOLDER / f"{PICTURES[0]}.svg"])

    def test_pictures_are_well_formed(self):
        for name in PICTURES:
            root = xml.etree.ElementTree.parse(FOLDER / f"{name}.svg").getroot()
            self.assertTrue(root.findtext("{http://www.w3.org/2000/svg}title"), name)

    def test_every_picture_stands_in_a_document_with_words_for_who_does_not_see_it(self):
        texts = [path.read_text(encoding="utf-8") for path in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]]
        shown = {name for text in texts for words, name in re.findall(r"!\[([^\]]{20,})\]\((?:docs/)?images/(\w+)\.svg\)", text)}
        self.assertEqual(shown, set(PICTURES))

    def test_the_house_has_the_order_of_the_lint(self):
        rooms = [name for _, rooms in FLOORS for name, _ in rooms]
        ranks = {folder.split("/")[0]: rank for folder, rank in sorted(RANKS.items(), key=lambda item: item[1])}
        shown = [ranks[room] for room in rooms if room in ranks]
        self.assertEqual(shown, sorted(shown, reverse=True))
        self.assertEqual({path.name for path in (ROOT / "modules").iterdir() if path.is_dir()} - set(rooms), set())


if __name__ == "__main__":
    unittest.main()
