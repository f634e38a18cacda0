# SPDX-License-Identifier: Apache-2.0
"""Bodies that move: error over the time of a step, and over the time of the scene."""

import math

import chart
import words


def _height(value, floor):
    return max(value, floor) if value is not None and math.isfinite(value) else 1e12


def _is_cut(row):
    """Whether the run took too long and is told up to there."""
    return row["effort"].endswith("steps)")


def _over_run_time(trial, rows, floor):
    figure, axes = chart.new()
    axes.set(xscale="log", yscale="log", title=trial, xlabel="time of a step", ylabel=rows[0]["error_is"])
    for contender in dict.fromkeys(row["contender"] for row in rows):
        its = [row for row in rows if row["contender"] == contender]
        colour, marker = chart.style_of(contender)
        axes.plot([row["milliseconds"] for row in its], [_height(row.get("error"), floor) for row in its], color=colour)
        for row in its:
            axes.plot([row["milliseconds"]], [_height(row.get("error"), floor)], color=colour, marker=marker, markersize=6,
                      markerfacecolor=chart.GROUND if _is_cut(row) else colour)
    _limit(axes, [_height(row.get("error"), floor) for row in rows])
    times = [math.log10(row["milliseconds"]) for row in rows if row["milliseconds"] > 0]
    low, high = math.floor(min(times)), max(math.ceil(max(times)), math.floor(min(times)) + 1)
    axes.set_xticks([10.0 ** tick for tick in range(low, high + 1)], [words.time(10.0 ** tick * 1e6) for tick in range(low, high + 1)])
    axes.xaxis.set_minor_formatter(chart.matplotlib.ticker.NullFormatter())
    axes.grid(True)
    return chart.svg(figure, f"{trial}: {rows[0]['error_is']} over the time of a step")


def _limit(axes, values):
    low, high = math.floor(math.log10(min(values))) - 1, math.ceil(math.log10(max(values))) + 1
    axes.set_ylim(10.0 ** low, 10.0 ** high)
    chart.power_labels(axes.yaxis, (low, high), 7)


def _over_time(trial, rows, floor):
    """Of each contender the effort with the least error."""
    figure, axes = chart.new()
    axes.set(yscale="log", title=f"{trial}, over time", xlabel="time in the scene, s", ylabel=rows[0]["error_is"])
    drawn = []
    for contender in dict.fromkeys(row["contender"] for row in rows):
        its = [row for row in rows if row["contender"] == contender and row["course"]]
        if not its:
            continue
        best = min(its, key=lambda row: (_is_cut(row), row["error"] if row.get("error") is not None else math.inf))
        values = [_height(error, floor) for _, error in best["course"]]
        drawn += values
        axes.plot([time for time, _ in best["course"]], values, color=chart.style_of(contender)[0], label=f"{contender} {best['effort']}")
    if drawn:
        _limit(axes, drawn)
    axes.grid(True)
    return chart.svg(figure, f"{trial}: {rows[0]['error_is']} over time")


def _table(rows):
    return {"head": ["contender", "effort", "time of a step", "error"],
            "rows": [[row["contender"], row["effort"], words.time(row["milliseconds"] * 1e6), words.error(row.get("error"))] for row in rows]}


def sections(document):
    rows = document["response"]["rows"]
    figures = []
    for trial in dict.fromkeys(row["trial"] for row in rows):
        its = [row for row in rows if row["trial"] == trial]
        positive = [row["error"] for row in its if row.get("error")]
        floor = min(positive, default=1e-18) / 10
        figures.append({"svg": _over_run_time(trial, its, floor), "table": _table(its), "caption": trial})
        figures.append({"svg": _over_time(trial, its, floor), "table": None, "caption": f"{trial}, over time"})
    yield {"id": "moving", "title": "Bodies that move: error over run time and over time", "figures": figures,
           "keys": list(dict.fromkeys(row["contender"] for row in rows)),
           "text": ["A curve over the time of a step joins the efforts of one solver: error bounds of abut, iterations of the others. Over the "
                    "time of the scene each contender is shown at the effort with its least error. A hollow mark is a run that took too long: it is told up to there."]}
