# SPDX-License-Identifier: Apache-2.0
"""A report.json that is small enough to be committed: the marks of the page in place of all pairs of kinds.

It is a report.json itself, from which the page can be drawn, with fewer parts and fewer pairs to look at again."""

import copy
import json

import maps
import questions
import words
import work

MOST_PAIR_BYTES = 2000  # of a pair as text; hulls of 200 points are left out


def _short(value):
    """Three digits of each number that is not whole."""
    if isinstance(value, float):
        return value if value == int(value) and abs(value) < 1e6 else float(f"{value:.3g}")
    if isinstance(value, dict):
        return {key: _short(its) for key, its in value.items()}
    return [_short(its) for its in value] if isinstance(value, list) else value


class _Pairs:
    """The pairs and shapes that are kept, by their new numbers."""

    def __init__(self, part):
        self._part, self._numbers, self._shapes = part, {}, {}
        self.pairs, self.shapes = [], []

    def _shape(self, number):
        if number not in self._shapes:
            self._shapes[number] = len(self.shapes)
            self.shapes.append(self._part["shapes"][number])
        return self._shapes[number]

    def kept(self, number):
        """Its new number; None where it is too long."""
        if number is None:
            return None
        pair = self._part["pairs"][number]
        if sum(len(json.dumps(self._part["shapes"][pair[side]])) for side in ("a", "b")) > MOST_PAIR_BYTES:
            return None
        if number not in self._numbers:
            self._numbers[number] = len(self.pairs)
            self.pairs.append(pair | {side: self._shape(pair[side]) for side in ("a", "b")})
        return self._numbers[number]


def _accuracy(part):
    kept = _Pairs(part)
    rows = []
    for (question, group), its in work.panels(part["rows"]).items():
        for contender, same in work.grouped(its, lambda row: row["contender"]).items():
            one = work.together(same)
            number = kept.kept(one.pop("worst_pair")) if contender == "abut" else one.pop("worst_pair") and None
            one = {"question": question, "condition": group if group in work.CONDITIONS else "ordinary", "pair": group} | one
            one["failures"] = {name: count for name, count in one["failures"].items() if count}
            rows.append(_short(one) | ({"worst_pair": number} if number is not None else {}))
    return {"shapes": kept.shapes, "pairs": kept.pairs, "rows": rows}


def _extremes(part):
    rows = []
    for (name, question, contender), its in work.grouped(part["rows"], lambda row: (row["map"], row["question"], row["contender"])).items():
        failed = {key: sum(row["failures"].get(key, 0) for row in its) for key in words.FAILURES}
        worst = max(its, key=lambda row: row.get("worst") or 0)
        bad = [row for row in its if words.failed(row)]
        rows.append(_short({"map": name, "question": question, "contender": contender, "worst": worst.get("worst"),
                            "worst_at": maps.place(worst), "places": len(its), "places_failed": len(bad),
                            "cases": sum(row["cases"] for row in its), "failures": {key: count for key, count in failed.items() if count},
                            "first_failure": maps.place(bad[0]) if bad else None}))
    return rows


def _steadiness(part):
    rows = []
    for ground, its in work.grouped(part["rows"], lambda row: row["ground"]).items():
        rows.append(_short({"ground": ground} | {name: max(row[name] for row in its) for name in ("flicker", "lost", "churn", "lean", "drift")}))
    return rows


def condensed(document):
    if document.get("condensed"):
        return document
    result = {"version": document["version"], "condensed": True, "machine": document["machine"]}
    if "accuracy" in document:
        result["accuracy"] = _accuracy(document["accuracy"])
        result["promises"] = work.promise_rows(document)
    if "extremes" in document:
        result["extremes_by_map"] = _extremes(document["extremes"])
    if "steadiness" in document:
        result["steadiness_by_ground"] = _steadiness(document["steadiness"])
    for name in ("deforming", "universe", "builds"):
        if name in document:
            result[name] = _short(copy.deepcopy(document[name]))
    result["questions"] = _short(questions.rows(document))
    return result
