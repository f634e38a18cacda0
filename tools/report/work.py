# SPDX-License-Identifier: Apache-2.0
"""Error over run time: a panel for each question and class of pair, and one for each hard condition."""

import math
import statistics

import chart
import words

CLASSES = {"sphere": "round", "capsule": "round", "box": "polytope", "hull32": "polytope", "hull200": "polytope",
           "cylinder": "curved", "cone": "curved", "ellipsoid": "curved"}
# What bodies of all these classes are asked on or in.
WHOLES = {"plane": "plane", "mesh": "surface: mesh", "height_field": "surface: height field", "solid_mesh": "solid mesh",
          "distance_field": "distance field", "particles": "particles", "composite": "composite",
          "deforming_folds": "deforming, a sheet in folds with itself", "deforming_two": "deforming, two sheets"}
ORDER = ("round", "polytope", "curved")
QUESTIONS = {"distance": "distance of pairs that are apart", "depth": "depth of pairs that overlap",
             "contacts": "depth of the deepest contact", "overlap": "whether two overlap, yes or no", "cast": "share of a motion at the first touch",
             "ray": "share of a ray at the first hit", "impact": "time of impact of bodies that turn, and of elements that deform",
             "candidates": "elements of meshes that deform whose boxes come near",
             "closest": "the nearest face of each vertex of meshes that deform"}
CONDITIONS = {"ordinary": "ordinary", "thin": "needles and plates, aspect 1e6", "size_ratio": "size ratio 1e9",
              "far": "1e9 sizes from the origin", "parallel": "parallel to 1e-3 ... 1e-12 rad",
              "touching": "gap or depth 1e-3 ... 1e-12 of the size"}
# Of the first section, and of those whose errors are of another kind.
READING = ("Ordinary pairs by their classes first, then hard conditions with all pairs together. Left is faster, lower is more "
           "exact. A mark is the time of one question and the error that 99\u00a0% of the answers keep; its line goes from the "
           "median to the worst. It is hollow where more than one answer in a hundred failed. It leads to the pair that was worst.")
NOTES = {"overlap": "A wrong yes or no is off by the distance or the depth of the pair. Of meshes that deform the error is the share of "
                    "crossings that are missed or too many.",
         "candidates": "One question is asked of a whole mesh in one step. The error is the share of pairs that are missed or too many.",
         "closest": "One question is asked of a whole mesh in one step. An error is that of one vertex."}
FLOOR = 1e-18  # errors below it, 0 among them, are drawn there


def class_of(pair):
    """Such as "round and polytope" of "box-sphere"; of a ray against one kind its class; of ground that of the ground."""
    first = pair.split("-")[0]
    if first in WHOLES:
        return WHOLES[first]
    classes = sorted((CLASSES.get(kind, kind) for kind in pair.split("-")), key=lambda name: (ORDER + (name,)).index(name))
    return " and ".join(classes)


def together(rows):
    """Rows of several pairs of kinds by one contender as one: the median of times and medians, else the worst."""
    def values(name):
        return [row[name] for row in rows if row.get(name) is not None]

    times = [row["nanoseconds"] for row in rows if row["nanoseconds"] > 0]
    failures = {name: sum(row["failures"].get(name, 0) for row in rows) for name in words.FAILURES}
    worst = max(rows, key=lambda row: (words.failed(row) > 0, row.get("worst") or 0))
    return {"question": rows[0]["question"], "contender": rows[0]["contender"], "pairs": len(rows),
            "nanoseconds": statistics.median(times) if times else 0,
            "median": statistics.median(values("median")) if values("median") else None,
            "p99": max(values("p99"), default=None), "worst": max(values("worst"), default=None),
            "cases": sum(row["cases"] for row in rows), "failures": failures, "worst_pair": worst.get("worst_pair")}


def grouped(rows, key):
    groups = {}
    for row in rows:
        groups.setdefault(key(row), []).append(row)
    return groups


def _height(value):
    return max(value, FLOOR)


def _curve(axes, points):
    """Error bounds of abut, from the coarsest on."""
    bounds = sorted((row for row in points if row["contender"].startswith("abut 1e-") and row["p99"] is not None),
                    key=lambda row: -float(row["contender"].split()[1]))
    if len(bounds) > 1:
        axes.plot([row["nanoseconds"] for row in bounds], [_height(row["p99"]) for row in bounds], color=chart.style_of("abut 1e-2")[0],
                  linewidth=1, zorder=2)


def _panel(title, points, book):
    figure, axes = chart.new()
    drawn = [row for row in points if row["p99"] is not None and row["nanoseconds"] > 0]
    axes.set(xscale="log", yscale="log", title=title, xlabel="time of one question", ylabel="error by the size")
    _curve(axes, drawn)
    for row in drawn:
        colour, marker = chart.style_of(row["contender"])
        is_hollow = words.failed(row) > 0.01 * row["cases"]
        low, middle, high = (_height(row[name]) for name in ("median", "p99", "worst"))
        axes.plot([row["nanoseconds"]] * 2, [low, high], color=colour, linewidth=1, alpha=0.6, zorder=1)
        axes.plot([row["nanoseconds"]], [high], color=colour, marker="_", markersize=6, zorder=2)
        mark = axes.scatter([row["nanoseconds"]], [middle], s=14 if row["contender"].startswith("abut 1e-") else 44, marker=marker, linewidths=0.8, zorder=3, edgecolors=colour,
                            facecolors=chart.GROUND if is_hollow else colour)
        anchor = book.anchor("accuracy", row)
        mark.set_urls([f"#{anchor}" if anchor else ""])
    if drawn:
        times = [math.log10(row["nanoseconds"]) for row in drawn]
        low, high = math.floor(min(times)), max(math.ceil(max(times)), math.floor(min(times)) + 2)
        axes.set_xlim(10.0 ** low, 10.0 ** high)
        ticks = list(range(low, high + 1))
        axes.set_xticks([10.0 ** tick for tick in ticks], [words.time(10.0 ** tick) for tick in ticks])
        axes.xaxis.set_minor_formatter(chart.matplotlib.ticker.NullFormatter())
    axes.set_ylim(FLOOR / 3, 3)
    chart.power_labels(axes.yaxis, (-18, 0), 7)
    axes.grid(True)
    return chart.svg(figure, f"{title}: error over time, {len(drawn)} contenders")


def _table(points, book):
    head = ["contender", "time", "median", "99 %", "worst", "cases", "failed"]
    rows = []
    for row in points:
        anchor = book.anchor("accuracy", row)
        rows.append([row["contender"], words.time(row["nanoseconds"]), words.error(row["median"]), words.error(row["p99"]),
                     {"text": words.error(row["worst"]), "link": anchor}, str(row["cases"]), words.failures(row)])
    return {"head": head, "rows": rows}


def _one(title, rows, book):
    points = [together(group) for group in grouped(rows, lambda row: row["contender"]).values()]
    return {"svg": _panel(title, points, book), "table": _table(points, book), "caption": title}


def panels(rows):
    """Rows by question and panel: ordinary pairs by their classes, then hard conditions."""
    def name_of(row):
        return row["question"], class_of(row["pair"]) if row["condition"] == "ordinary" else row["condition"]

    order = {question: i for i, question in enumerate(QUESTIONS)}
    return grouped(sorted(rows, key=lambda row: (order.get(row["question"], len(order)), row["condition"] != "ordinary")), name_of)


def all_rows(document):
    """Those of pairs, and those of meshes that deform."""
    return [row for part in ("accuracy", "deforming") for row in document.get(part, {}).get("rows", [])]


def sections(document, book):
    rows = all_rows(document)
    every = panels(rows)
    contenders = list(dict.fromkeys(row["contender"] for row in rows))
    is_told = False
    for question, what in QUESTIONS.items():
        of_question = [row for row in rows if row["question"] == question]
        if not of_question:
            continue
        figures = [_one(CONDITIONS.get(name, name), group, book) for (its, name), group in every.items() if its == question]
        yield {"id": f"work-{question}", "title": f"Error over time: {what}", "figures": figures,
               "keys": [name for name in contenders if any(row["contender"] == name for row in of_question)],
               "text": [*([] if is_told else [READING]), *([NOTES[question]] if question in NOTES else [])]}
        is_told = True


def promise_rows(document):
    """Of each error bound that convex pairs were asked for: the worst error as a part of it, and promises that were broken."""
    rows = [row for row in all_rows(document) if row["contender"].startswith("abut 1e-") and "broken" in row
            and row["pair"].split("-")[0] not in WHOLES]
    found = []
    for (question, contender), group in grouped(rows, lambda row: (row["question"], row["contender"])).items():
        bound = float(contender.split()[1])
        worst = max((row.get("worst") or 0 for row in group), default=0)
        found.append({"question": question, "bound": bound, "worst_by_bound": worst / bound, "nanoseconds": together(group)["nanoseconds"],
                      "failed": sum(words.failed(row) for row in group)}
                     | {name: sum(row["broken"][name] for row in group) for name in ("beyond", "outside")})
    return found


def promises(document):
    rows = document.get("promises") or promise_rows(document)
    head = ["question", "bound asked", "worst error / bound", "time", "failed", "beyond the bound", "outside of its interval"]
    table = [[row["question"], words.error(row["bound"]), f"{row['worst_by_bound']:.2g}", words.time(row["nanoseconds"]),
              str(row["failed"]), str(row["beyond"]), str(row["outside"])] for row in rows]
    if table:
        yield {"id": "promises", "title": "What error bounds cost, and whether they are kept", "figures": [], "keys": [],
               "tables": [{"head": head, "rows": table}],
               "text": ["Over all conditions and pairs of convex shapes. The worst error may exceed a narrow bound by the rounding of the "
                        "coordinates, which the columns to the right leave out."]}
