# SPDX-License-Identifier: Apache-2.0
"""Figures as SVG that lies in a page: colours of text and lines follow the page, ids are its own."""

import io
import re

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
from markupsafe import Markup  # noqa: E402

# Stand-ins, replaced by variables of the style sheet.
INK, SOFT, GROUND = "#010203", "#040506", "#070809"
_VARIABLES = {INK: "var(--ink)", SOFT: "var(--line)", GROUND: "var(--ground)"}

plt.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "abut", "text.parse_math": False, "font.family": "DejaVu Sans", "font.size": 9,
    "axes.facecolor": "none", "figure.facecolor": "none", "axes.edgecolor": SOFT, "axes.labelcolor": INK, "text.color": INK,
    "xtick.color": INK, "ytick.color": INK, "xtick.labelcolor": INK, "ytick.labelcolor": INK, "grid.color": SOFT,
    "grid.linewidth": 0.5, "axes.titlesize": 10, "axes.titlelocation": "left", "axes.titleweight": "bold", "axes.spines.top": False,
    "axes.spines.right": False, "axes.axisbelow": True, "lines.linewidth": 1.2})

# name: (colour, marker). The colours read on a light and on a dark ground.
STYLES = {
    "abut": ("#2f81f7", "o"), "abut analytic": ("#1b9e9e", "D"), "abut sat": ("#1b9e9e", "s"), "abut gjk_epa": ("#1b9e9e", "^"),
    "abut libccd_gjk": ("#7d8590", "v"), "abut libccd_mpr": ("#7d8590", "<"), "abut implicit": ("#2f81f7", "o"),
    "abut midpoint": ("#1b9e9e", "o"), "abut Newton": ("#2f81f7", "o"), "abut sweeps": ("#1b9e9e", "o"),
    "bullet": ("#e5534b", "P"), "Bullet": ("#e5534b", "P"), "fcl": ("#a371f7", "X"), "ode": ("#d29922", "h"),
    "box3d": ("#c2571a", "d"), "jolt": ("#bf5aa5", "p"), "coal": ("#5a6fbf", "*"), "all pairs": ("#7d8590", "s"), "sweep": ("#7d8590", "d"),
    "abut of pairs": ("#1b9e9e", "s"), "abut new elements": ("#5aa2ff", "s"), "abut new meshes": ("#5aa2ff", "^"),
    "fcl new meshes": ("#a371f7", "D"), "abut closest_all": ("#1b9e9e", "D"), "abut closest_of_vertices": ("#1b9e9e", "^"),
    "ODE sweeps": ("#d29922", "h"), "ODE factors": ("#b07d12", "H"), "libccd_gjk": ("#4fa34f", "v"), "libccd_mpr": ("#4fa34f", "<")}
_OTHERS = [("#bf5aa5", "p"), ("#8c6d46", "8"), ("#5a6fbf", "*")]


def style_of(name):
    """Of a contender; error bounds of abut share one."""
    if name in STYLES:
        return STYLES[name]
    if name.startswith("abut 1e-"):
        return "#5aa2ff", "p"
    return _OTHERS[sum(name.encode()) % len(_OTHERS)]


def key(name):
    """The mark of a contender, for legends in the text."""
    colour, marker = style_of(name)
    path = matplotlib.markers.MarkerStyle(marker)
    shape = path.get_path().transformed(path.get_transform())
    points = []
    for corners, code in shape.iter_segments(simplify=False):
        letter = {1: "M", 2: "L", 3: "Q", 4: "C", 79: "Z"}[int(code)]
        points.append(letter + ("" if letter == "Z" else " ".join(f"{value if i % 2 == 0 else -value:.3f}" for i, value in enumerate(corners))))
    return Markup(f'<svg class="key" viewBox="-.6 -.6 1.2 1.2" aria-hidden="true"><path d="{"".join(points)}" fill="{colour}"/></svg>')


def new(height=3.2, left=0.72, width=4.2):
    """A figure with one panel; sizes and the room to the left of it are inches."""
    figure = plt.figure(figsize=(width, height))
    below, above, right = 0.46, 0.3, 0.28
    axes = figure.add_axes((left / width, below / height, (width - left - right) / width, (height - below - above) / height))
    return figure, axes


_count = 0


def svg(figure, label):
    """Closes a figure; the text of its SVG."""
    global _count
    _count += 1
    buffer = io.StringIO()
    figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    plt.close(figure)
    text = buffer.getvalue()
    text = text[text.index("<svg"):]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r' (width|height)="[\d.]+pt"', "", text, count=2)
    for colour, variable in _VARIABLES.items():
        text = text.replace(colour, variable)
    names = set(re.findall(r'\bid="([^"]+)"', text))
    used = set(re.findall(r'url\(#([^)]+)\)', text)) | set(re.findall(r'xlink:href="#([^"]+)"', text))
    for name in names - used:
        text = text.replace(f' id="{name}"', "")
    for name in names & used:
        for before, after in (('id="', '"'), ("url(#", ")"), ('xlink:href="#', '"')):
            text = text.replace(f"{before}{name}{after}", f"{before}f{_count}-{name}{after}")
    return Markup(text.replace("<svg", f'<svg role="img" aria-label="{Markup.escape(label)}"', 1))


def superscript(power):
    return "10" + str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def power_labels(axis, limits, most=8):
    """Ticks at powers of ten, at most so many."""
    low, high = limits
    step = max(1, -(-(high - low) // most))
    ticks = list(range(low, high + 1, step))
    axis.set_ticks([10.0 ** tick for tick in ticks], [superscript(tick) for tick in ticks])
    axis.set_minor_formatter(matplotlib.ticker.NullFormatter())
