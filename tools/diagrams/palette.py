# SPDX-License-Identifier: Apache-2.0
"""The one palette of all pictures. A picture brings its own ground, so it reads on any page, light or dark."""

# name: (light, dark) of lines and text, (light, dark) of areas
COLOURS = {
    "ink": (("#1f2328", "#f0f6fc"), ("#eff2f5", "#1c2128")),
    "soft": (("#59636e", "#9198a1"), ("#f6f8fa", "#151b23")),
    "a": (("#0969da", "#4493f8"), ("#e3f2ff", "#0f2748")),
    "b": (("#bc4c00", "#f0883e"), ("#fff1e4", "#4a2a12")),
    "good": (("#1a7f37", "#3fb950"), ("#dcfae3", "#143d22")),
    "bad": (("#cf222e", "#f85149"), ("#ffe7e4", "#40161a")),
    "mark": (("#8250df", "#ab7df8"), ("#f7f0ff", "#312055")),
    "gold": (("#8a6100", "#d8a72b"), ("#fbeab0", "#463607")),
}
GROUND = ("#ffffff", "#0d1117")
BORDER = ("#d1d9e0", "#3d444d")

FONT = "-apple-system, 'Segoe UI', 'Liberation Sans', Helvetica, Arial, sans-serif"


def _rules(side):
    """The classes of one scheme: .l- for lines, .f- for full areas and text, .p- for pale areas."""
    yield f".ground{{fill:{GROUND[side]};stroke:{BORDER[side]}}}"
    for name, (full, pale) in COLOURS.items():
        yield f".l-{name}{{stroke:{full[side]}}}.f-{name}{{fill:{full[side]}}}.p-{name}{{fill:{pale[side]}}}"


def style():
    """The style sheet that each picture carries."""
    light, dark = "".join(_rules(0)), "".join(_rules(1))
    return f"text{{font-family:{FONT}}}{light}@media (prefers-color-scheme:dark){{{dark}}}"
