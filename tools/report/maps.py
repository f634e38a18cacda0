# SPDX-License-Identifier: Apache-2.0
"""Heat maps: the worst error of each place, and what failed there."""

import math

import chart
import words

LOWEST = -17  # errors below this power of ten look alike
BAD = "#e5534b"
_COLOURS = chart.matplotlib.colormaps["viridis"].reversed()


def _is_number(value):
    return isinstance(value, (int, float))


def _label(value):
    if not _is_number(value):
        return str(value)
    power = round(math.log10(value), 1) if value > 0 else 0
    if power == int(power):
        return chart.superscript(int(power))
    return f"{value:,.0f}" if value >= 2 else f"{value:.2g}"


def _places(values):
    """The places of an axis, in order: numbers up or down as they begin, names as they come."""
    unique = list(dict.fromkeys(values))
    if not all(_is_number(value) for value in unique):
        return unique
    return sorted(unique, reverse=len(unique) > 1 and unique[0] > unique[1])


def _ink_on(colour):
    red, green, blue = colour[:3]
    return "#000000" if 0.299 * red + 0.587 * green + 0.114 * blue > 0.5 else "#ffffff"


def draw(title, rows, x_name, y_name, lowest=LOWEST, highest=0):
    """Rows have x, y, error (None where there is none) and letters of what failed."""
    xs, ys = _places([row["x"] for row in rows]), _places([row["y"] for row in rows])
    if not _is_number(ys[0]):
        ys.reverse()  # the first one on top
    figure, axes = chart.new(max(2.2, 0.9 + 0.21 * len(ys)), 0.3 + 0.075 * max(len(_label(value)) for value in ys) + (0.15 if y_name else 0))
    for row in rows:
        column, line = xs.index(row["x"]), ys.index(row["y"])
        error, letters = row["error"], row["letters"]
        power = lowest if error is not None and error <= 0 else None if error is None else math.log10(error)
        if power is None:
            fill, ink, text = BAD, "#ffffff", letters
        else:
            share = (min(max(power, lowest), highest) - lowest) / (highest - lowest)
            fill = _COLOURS(share)
            ink = _ink_on(fill)
            text = letters or (str(round(power)) if power > lowest else "")
        axes.add_patch(chart.plt.Rectangle((column, line), 1, 1, facecolor=fill, edgecolor=BAD if letters else "none", linewidth=1.2,
                                           zorder=2 if letters else 1))
        if len(xs) <= 18:
            axes.text(column + 0.5, line + 0.5, text, ha="center", va="center", color=ink, fontsize=6, zorder=3)
    axes.set(xlim=(0, len(xs)), ylim=(0, len(ys)), title=title, xlabel=x_name, ylabel=y_name)
    every = 1 if len(xs) <= 9 else 2
    axes.set_xticks([i + 0.5 for i in range(0, len(xs), every)], [_label(value) for value in xs[::every]], fontsize=8)
    axes.set_yticks([i + 0.5 for i in range(len(ys))], [_label(value) for value in ys], fontsize=8)
    axes.tick_params(length=0)
    for side in axes.spines.values():
        side.set_visible(False)
    bad = sum(1 for row in rows if row["letters"])
    return chart.svg(figure, f"{title}: worst error over {x_name} and {y_name}; failures in {bad} of {len(rows)} places")


def place(row):
    """Such as "size ratio 10⁶, aspect 10³" in words."""
    x_name, y_name = X_NAMES.get(row["map"], ("x", "y"))
    return f"{x_name} {_label(row['x'])}, {y_name} {_label(row['y'])}".replace(",  ", ", ")


def _letters(row):
    return "".join(letter for name, (letter, _) in words.FAILURES.items() if row["failures"].get(name))


X_NAMES = {"size ratio and aspect": ("size ratio", "aspect"), "distance from the origin": ("distance from the origin, sizes", ""),
           "angle from parallel": ("angle, rad", ""), "gap or depth": ("part of the size", ""),
           "triangles of a flat floor": ("triangles", "")}


def extremes(document, book):
    rows = document["extremes"]["rows"]
    for name in dict.fromkeys(row["map"] for row in rows):
        of_map = [row for row in rows if row["map"] == name]
        x_name, y_name = X_NAMES.get(name, ("x", "y"))
        figures, table = [], []
        for question in dict.fromkeys(row["question"] for row in of_map):
            for contender in dict.fromkeys(row["contender"] for row in of_map):
                its = [row for row in of_map if (row["question"], row["contender"]) == (question, contender)]
                if not its:
                    continue
                cells = [{"x": row["x"], "y": row["y"], "error": row.get("worst"), "letters": _letters(row)} for row in its]
                worst = max(its, key=lambda row: (words.failed(row) > 0, row.get("worst") or 0))
                anchor = book.anchor("extremes", worst)
                figures.append({"svg": draw(f"{contender}, {question}", cells, x_name, y_name), "caption": f"{contender}, {question}",
                                "link": anchor, "table": None})
                failed = {key: sum(row["failures"].get(key, 0) for row in its) for key in words.FAILURES}
                table.append([contender, question, words.error(max((row.get("worst") or 0 for row in its), default=None)),
                              str(sum(row["cases"] for row in its)), words.failures({"failures": failed}),
                              words.time(sorted(row["nanoseconds"] for row in its)[len(its) // 2])])
        yield {"id": "map-" + name.replace(" ", "-"), "title": f"Extremes: {name}", "figures": figures, "keys": [],
               "tables": [{"head": ["contender", "question", "worst error", "cases", "failed", "time, median of places"], "rows": table}],
               "text": ["A number in a place is the power of ten of its worst error by the size; letters name what failed there."]}


def summary(document):
    """The maps of a condensed report: one row for each."""
    head = ["map", "question", "contender", "worst error", "at", "places that failed", "first failure"]
    table = [[row["map"], row["question"], row["contender"], words.error(row["worst"]), row["worst_at"],
              f"{row['places_failed']} of {row['places']}", row["first_failure"] or "-"] for row in document["extremes_by_map"]]
    yield {"id": "maps", "title": "Extremes", "figures": [], "keys": [], "tables": [{"head": head, "rows": table}], "text": []}


def response(document):
    for one in document["response_maps"]["maps"]:
        figures = []
        for contender in dict.fromkeys(row["contender"] for row in one["rows"]):
            its = [row for row in one["rows"] if row["contender"] == contender]
            cells = [{"x": row["x"], "y": row["y"], "error": row.get("error"),
                      "letters": ("F" if row.get("error") is None else "") + ("G" if (row.get("gain") or 0) > 1e-6 else "")
                      + ("L" if row.get("is_late") else "")} for row in its]
            figures.append({"svg": draw(contender, cells, one["x"], one["y"], -16, 1), "caption": contender, "table": None})
        table = [[contender, words.error(max((row["error"] for row in one["rows"] if row["contender"] == contender and row.get("error") is not None), default=None)),
                  words.time(1e3 * sorted(row["microseconds"] for row in one["rows"] if row["contender"] == contender)[len(figures) // 2])]
                 for contender in dict.fromkeys(row["contender"] for row in one["rows"])]
        yield {"id": "stiff-" + one["name"], "title": f"Stiff: {one['name']}", "figures": figures, "keys": [],
               "tables": [{"head": ["contender", "worst error", "time of a step"], "rows": table}],
               "text": [f"Error: {one['error']}. G: energy was gained, by more than a millionth. F: no finite number. "
                        "L: the run took too long and is told up to there."]}
