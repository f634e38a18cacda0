# SPDX-License-Identifier: Apache-2.0
"""The worst pairs of the report as commands that look at them again."""

import json
import shlex

QUERIES = ("distance", "depth", "contacts")


def scene(part, number):
    """Pair `number` of a part as a scene of the program abut."""
    pair = part["pairs"][number]
    return {"version": 1, "parts": [
        {"name": side, "motion": "static" if side == "a" else "dynamic", "pose": pair[f"pose_{side}"],
         "geometries": [{"shape": part["shapes"][pair[side]]}]} for side in ("a", "b")]}


def command(part, number):
    return f"echo {shlex.quote(json.dumps(scene(part, number), separators=(',', ':')))} | abut explain pair - a b"


class Book:
    """The pairs that marks lead to, each once."""

    def __init__(self, document):
        self._document = document
        self._numbers = {}

    def anchor(self, name, row):
        """Of the pair on which a row was worst; None where it has none."""
        number = row.get("worst_pair")
        if number is None:
            return None
        self._numbers.setdefault((name, number), []).append(row)
        return f"{name}-{number}"

    def entries(self):
        for (name, number), rows in sorted(self._numbers.items()):
            part = self._document[name]
            pair = part["pairs"][number]
            kinds = [part["shapes"][pair[side]]["kind"] for side in ("a", "b")]
            contenders = sorted({f"{row['contender']} ({row['question']})" for row in rows})
            yield {"anchor": f"{name}-{number}", "kinds": " and ".join(kinds), "truth": pair["truth"], "motion": pair.get("motion"), "turn": pair.get("turn"),
                   "contenders": ", ".join(contenders), "command": command(part, number)}
