#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Opens the page of the report in headless Chromium: nothing overflows, on a phone and on a desk.

usage: check_browser.py [REPORT.json [FOLDER]]
Without a report that of sample.py. With a folder its screenshots go there, phone.png and desk.png. Skips, with status 77,
where there is no Chromium.
"""

import html
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools" / "report"))

import document  # noqa: E402
import page  # noqa: E402
import sample  # noqa: E402

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
WIDTHS = {"phone": 390, "desk": 1400}

# A window is not as narrow as a phone: a frame is. All that is folded is opened. Pictures are drawn by a program that
# guesses how wide a text is, so that their texts are looked at too.
FRAME = """<!DOCTYPE html><html><body style="margin:0"><iframe id="its" src="index.html" style="border:0;width:WIDTHpx;height:HEIGHTpx"></iframe>
<pre id="found"></pre><script>
document.getElementById("its").onload = event => {
  const inner = event.target.contentDocument, found = [], width = WIDTH;
  inner.querySelectorAll("details").forEach(its => its.open = OPEN);
  const say = (what, its) => found.push(what + ": " + its.tagName + " " + its.textContent.trim().slice(0, 60));
  if (inner.documentElement.scrollWidth > width) say("the page is " + inner.documentElement.scrollWidth + " wide", inner.body);
  inner.querySelectorAll("body *").forEach(its => {
    if (its.closest("svg") || (its.closest(".scroll, pre") && !its.matches(".scroll, pre"))) return;
    const box = its.getBoundingClientRect();
    if (box.right > width + 1 || box.left < -1) say("beyond the edge", its);
  });
  inner.querySelectorAll("figure > svg").forEach(svg => {
    const edge = svg.getBoundingClientRect();
    svg.querySelectorAll("text").forEach(its => {
      const box = its.getBoundingClientRect();
      if (box.left < edge.left - 1 || box.right > edge.right + 1 || box.top < edge.top - 1 || box.bottom > edge.bottom + 1)
        say("cut off in " + svg.getAttribute("aria-label"), its);
    });
  });
  document.getElementById("found").textContent = JSON.stringify({height: inner.documentElement.scrollHeight, found});
};
</script></body></html>"""


def chromium(*arguments):
    with tempfile.TemporaryDirectory() as profile:
        return subprocess.run(
            [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--allow-file-access-from-files",
             f"--user-data-dir={profile}", *arguments], capture_output=True, text=True, check=True, timeout=120)


def examine(folder, width, is_open=True):
    """The height of the page at a width, and what overflows."""
    frame = folder / "frame.html"
    frame.write_text(FRAME.replace("WIDTH", str(width)).replace("HEIGHT", "900").replace("OPEN", str(is_open).lower()), encoding="utf-8")
    text = chromium("--dump-dom", "--virtual-time-budget=20000", "--window-size=1600,1000", frame.as_uri()).stdout
    return json.loads(html.unescape(re.search(r'<pre id="found">(.*?)</pre>', text, re.DOTALL)[1]))


def shoot(folder, name, width, height):
    frame = folder / "frame.html"
    frame.write_text(FRAME.replace("WIDTH", str(width)).replace("HEIGHT", str(height)).replace("OPEN", "false"), encoding="utf-8")
    chromium(f"--screenshot={folder / name}.png", f"--window-size={max(width, 500)},{height}", "--virtual-time-budget=20000", frame.as_uri())


class Browser(unittest.TestCase):
    source, pictures = None, None

    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.made.name)
        its = document.read(cls.source) if cls.source else document.check(sample.document())
        (cls.folder / "index.html").write_text(page.render(its), encoding="utf-8")

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def test_nothing_overflows(self):
        for name, width in WIDTHS.items():
            with self.subTest(width=width):
                seen = examine(self.folder, width)
                self.assertEqual(seen["found"], [])
                self.assertGreater(seen["height"], 900)
            if self.pictures:
                shoot(self.folder, name, width, min(examine(self.folder, width, False)["height"], 16000))
                shutil.copy(self.folder / f"{name}.png", self.pictures)

    def test_what_overflows_is_seen(self):
        page_text = (self.folder / "index.html").read_text(encoding="utf-8")
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "index.html").write_text(page_text.replace("<body>", '<body><div style="width:2000px">wide</div>', 1), encoding="utf-8")
            self.assertTrue(any("wide" in line for line in examine(Path(folder), 390)["found"]))


if __name__ == "__main__":
    if CHROMIUM is None:
        print("skipped: there is no Chromium; on Debian it is the package chromium")
        sys.exit(77)
    Browser.source = sys.argv[1] if len(sys.argv) > 1 else None
    Browser.pictures = sys.argv[2] if len(sys.argv) > 2 else None
    unittest.main(argv=sys.argv[:1])
