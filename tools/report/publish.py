# SPDX-License-Identifier: Apache-2.0
"""The tables of README.md, docs/benchmarks.md and docs/numerics.md out of docs/report/report.json.

A table stands between two comments, <!-- report: NAME --> and <!-- report: end -->."""

import json
import re

import document
import measure
import questions
import words
import work

COMMITTED = measure.ROOT / "docs" / "report" / "report.json"
_BLOCK = re.compile(r"<!-- report: (\w+) -->\n.*?<!-- report: end -->", re.DOTALL)


def _table(head, rows, right=1):
    """`right`: the columns from there on are aligned to the right."""
    line = "|" + "|".join("---" if i < right else "---:" for i in range(len(head))) + "|"
    return "\n".join(["| " + " | ".join(head) + " |", line, *("| " + " | ".join(row) + " |" for row in rows)])


def _digits(value):
    return f"{value:,.0f}" if value >= 99.5 else f"{value:.2g}"


def _in_unit(answers):
    """Nanoseconds while all are small, or else microseconds: the unit, and what they are divided by."""
    return ("ns", 1) if answers["abut"]["nanoseconds"] < 1000 else ("µs", 1000)


def _cell(answers, name, size):
    if name not in answers:
        return "-"
    return _digits(answers[name]["nanoseconds"] / size) + ("*" if answers[name]["is_other"] else "")


def speed(report):
    """The first table of docs/benchmarks.md, from which docs/images/speed.svg is drawn."""
    rows = []
    for one in report["questions"]:
        answers = one["answers"]
        unit, size = _in_unit(answers)
        right = [its["nanoseconds"] for name, its in answers.items() if name != "abut" and not its["is_other"]]
        rows.append([one["question"], unit, *(_cell(answers, name, size) for name in questions.PEERS),
                     f"{min(right) / answers['abut']['nanoseconds']:.1f}" if right else "-"])
    return _table(["question", "unit", *questions.PEERS, "fastest of them / abut"], rows, 2)


def times_and_errors(report):
    """The table of README.md."""
    rows = []
    for one in report["questions"]:
        answers = one["answers"]
        unit, size = _in_unit(answers)
        cells = []
        for name in questions.PEERS:
            cell = _cell(answers, name, size)
            worst = answers.get(name, {}).get("worst")
            cells.append(cell if cell == "-" else f"{cell} {unit}" + (f", {words.error(worst)}" if worst is not None else ""))
        rows.append([one["question"], *cells])
    return _table(["question", *questions.PEERS], rows)


def machine(report):
    return _table(["of the run", ""], [[name, str(value)] for name, value in report["machine"].items()], 2)


def _of_abut(report, condition):
    return [row for row in report["accuracy"]["rows"] if row["contender"] == "abut" and row["condition"] == condition]


def _error_cell(row):
    if row is None:
        return "-"
    failed = words.failures(row)
    return words.error(row.get("worst")) + ("" if failed == "-" else f" ({failed})")


def worst_by_class(report):
    rows = _of_abut(report, "ordinary")
    its = {(row["pair"], row["question"]): row for row in rows}
    asked = [name for name in work.QUESTIONS if any(row["question"] == name for row in rows)]
    return _table(["class of pair", *asked], [[pair, *(_error_cell(its.get((pair, name))) for name in asked)]
                                             for pair in dict.fromkeys(row["pair"] for row in rows)])


def worst_by_condition(report):
    rows = [row for name in work.CONDITIONS if name != "ordinary" for row in _of_abut(report, name)]
    its = {(row["condition"], row["question"]): row for row in rows}
    asked = [name for name in work.QUESTIONS if any(row["question"] == name for row in rows)]
    return _table(["condition", *asked], [[work.CONDITIONS[name], *(_error_cell(its.get((name, one))) for one in asked)]
                                          for name in dict.fromkeys(row["condition"] for row in rows)])


def promises(report):
    return _table(["question", "error bound", "worst error / bound", "time", "beyond the bound", "outside of its interval"],
                  [[row["question"], words.error(row["bound"]), f"{row['worst_by_bound']:.2g}", words.time(row["nanoseconds"]),
                    str(row["beyond"]), str(row["outside"])] for row in report["promises"]])


def extremes(report):
    return _table(["extreme", "question", "library", "worst error", "at", "places that failed", "the first", "how"],
                  [[row["map"], row["question"], row["contender"], words.error(row["worst"]), row["worst_at"],
                    f"{row['places_failed']} of {row['places']}", row["first_failure"] or "-", words.failures(row)]
                   for row in report["extremes_by_map"]], 3)


def steadiness(report):
    names = ("flicker", "lost", "churn", "lean", "drift")
    return _table(["ground", *names], [[row["ground"], *(words.error(row[name]) for name in names)]
                                       for row in report["steadiness_by_ground"]])


BLOCKS = {function.__name__: function for function in (speed, times_and_errors, machine, worst_by_class, worst_by_condition, promises,
                                                      extremes, steadiness)}
PARTS = ("accuracy", "promises", "extremes_by_map", "steadiness_by_ground", "universe", "questions")
PAGES = ("README.md", "docs/benchmarks.md", "docs/numerics.md")


def filled(text, report, where):
    """The text with its tables made of the report."""
    def block(found):
        name = found[1]
        if name not in BLOCKS:
            raise document.Wrong(f"{where} has a table {name}; there are: {', '.join(BLOCKS)}")
        return f"<!-- report: {name} -->\n\n{BLOCKS[name](report)}\n\n<!-- report: end -->"

    return _BLOCK.sub(block, text)


def stale(root=measure.ROOT):
    """The pages that differ from the committed report."""
    report = document.read(root / COMMITTED.relative_to(measure.ROOT))
    texts = {name: (root / name).read_text(encoding="utf-8") for name in PAGES}
    return [name for name, text in texts.items() if filled(text, report, name) != text]


def write(report):
    absent = [name for name in PARTS if name not in report]
    if absent:
        raise document.Wrong(f"the report lacks {', '.join(absent)}; expected one of all parts to be published")
    COMMITTED.parent.mkdir(parents=True, exist_ok=True)
    lines = ",\n".join(f"{json.dumps(name)}: {_lines(value)}" for name, value in report.items())
    COMMITTED.write_text("{" + lines + "}\n", encoding="utf-8")
    for name in PAGES:
        path = measure.ROOT / name
        path.write_text(filled(path.read_text(encoding="utf-8"), report, name), encoding="utf-8")


def _lines(value):
    """A row to a line, so that changes can be read."""
    if isinstance(value, dict) and "rows" in value:
        return "{" + ",\n".join(f"{json.dumps(name)}: {_lines(its)}" for name, its in value.items()) + "}"
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return "[\n" + ",\n".join(json.dumps(its, ensure_ascii=False, separators=(",", ":")) for its in value) + "]"
    return json.dumps(value, ensure_ascii=False)
