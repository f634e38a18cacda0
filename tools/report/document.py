# SPDX-License-Identifier: Apache-2.0
"""report.json: what is in it, and what is wrong with one that is not."""

import json
import math

VERSION = 1

_NUMBER, _TEXT, _LIST, _OBJECT = (int, float), (str,), (list,), (dict,)
_WORDS = {_NUMBER: "a number", _TEXT: "a text", _LIST: "a list", _OBJECT: "an object"}

# The members that rows have, by the part of the document; more are allowed.
_ACCURACY = {"question": _TEXT, "contender": _TEXT, "nanoseconds": _NUMBER, "cases": _NUMBER, "failures": _OBJECT}
ROWS = {
    "accuracy": _ACCURACY | {"condition": _TEXT, "pair": _TEXT},
    "deforming": _ACCURACY | {"condition": _TEXT, "pair": _TEXT},
    "extremes": _ACCURACY | {"map": _TEXT, "x": _NUMBER},
    "response": {"trial": _TEXT, "error_is": _TEXT, "contender": _TEXT, "effort": _TEXT, "milliseconds": _NUMBER, "course": _LIST},
    "steadiness": {"ground": _TEXT, "body": _TEXT, "motion": _TEXT, "jitter": _TEXT, "lost": _NUMBER, "flicker": _NUMBER,
                   "churn": _NUMBER, "lean": _NUMBER, "drift": _NUMBER, "microseconds": _NUMBER},
    "universe": {"scene": _TEXT, "contender": _TEXT, "milliseconds": _NUMBER},
    "builds": {"name": _TEXT, "bytes": _NUMBER, "stripped_bytes": _NUMBER, "start_milliseconds": _NUMBER,
               "resident_bytes": _NUMBER, "step_microseconds": _NUMBER, "libraries": _LIST}}
_MAP_ROW = {"x": _NUMBER, "y": _NUMBER, "contender": _TEXT}


class Wrong(Exception):
    """What is wrong, in one line."""


def _shown(value):
    text = json.dumps(value)
    return text if len(text) <= 60 else text[:57] + "..."


def _expect(where, value, kinds):
    is_kind = isinstance(value, kinds) and not isinstance(value, bool)
    if not is_kind or (kinds == _NUMBER and not math.isfinite(value)):
        raise Wrong(f"{where} is {_shown(value)}; expected {_WORDS[kinds]}")


def _member(where, value, name, kinds):
    _expect(where, value, _OBJECT)
    if name not in value:
        raise Wrong(f"{where} has no member {name}; there are: {', '.join(value) or 'none'}")
    _expect(f"{where}.{name}", value[name], kinds)
    return value[name]


def _check_rows(where, rows, members):
    for i, row in enumerate(rows):
        for name, kinds in members.items():
            _member(f"{where}[{i}]", row, name, kinds)


def _check_pairs(where, part):
    shapes, pairs = _member(where, part, "shapes", _LIST), _member(where, part, "pairs", _LIST)
    for i, pair in enumerate(pairs):
        for side in ("a", "b"):
            number = _member(f"{where}.pairs[{i}]", pair, side, _NUMBER)
            if not 0 <= number < len(shapes):
                raise Wrong(f"{where}.pairs[{i}].{side} is {number}; there are {len(shapes)} shapes")
    for i, row in enumerate(part["rows"]):
        number = row.get("worst_pair")
        if number is not None and not 0 <= number < len(pairs):
            raise Wrong(f"{where}.rows[{i}].worst_pair is {number}; there are {len(pairs)} pairs")


def check(document):
    """Raises Wrong where a page cannot be made of it. Every part may be missing."""
    version = _member("the document", document, "version", _NUMBER)
    if version != VERSION:
        raise Wrong(f"version is {version}; expected {VERSION}")
    _member("the document", document, "machine", _OBJECT)
    for name, members in ROWS.items():
        if name in document:
            _check_rows(f"{name}.rows", _member(name, document[name], "rows", _LIST), members)
    for name in ("accuracy", "extremes"):
        if name in document:
            _check_pairs(name, document[name])
    if "response_maps" in document:
        for i, one in enumerate(_member("response_maps", document["response_maps"], "maps", _LIST)):
            where = f"response_maps.maps[{i}]"
            for name in ("name", "error", "x", "y"):
                _member(where, one, name, _TEXT)
            _check_rows(f"{where}.rows", _member(where, one, "rows", _LIST), _MAP_ROW)
    return document


def read(path):
    try:
        with open(path, encoding="utf-8") as file:
            document = json.load(file)
    except OSError as error:
        raise Wrong(f"{path} cannot be read: {error.strerror}") from None
    except ValueError as error:
        raise Wrong(f"{path} is no JSON: {error}") from None
    try:
        return check(document)
    except Wrong as error:
        raise Wrong(f"{path}: {error}") from None
