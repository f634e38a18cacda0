#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the rules of the tree that no compiler checks.

usage: lint.py [--lower] [root]

Exceptions stand in expect.txt, one per line: `rule path  # reason`. It is a ratchet: a finding that
is not listed fails, and so does a line whose file has become clean.

What is known and shall only become less stands in ratchet.txt, one per line: `rule path count`. More findings
in a file fail, and so do fewer; --lower writes the lower counts.
"""

import re
import sys
from collections import Counter
from pathlib import Path

from rules import FILE_RULES, count_unsafe, is_long
from source import read_tree
from tree_rules import TREE_RULES

EXPECT = "tools/lint/expect.txt"
RATCHET = "tools/lint/ratchet.txt"
RATCHETED = ("line_length", "sentence_length", "prose_length", "concept_place", "unused_import", "closed_source")


def findings_of(sources):
    """All findings as (rule, path, line, message), in order of path and line."""
    by_path = {source.path: source for source in sources}
    found = []
    for rule in FILE_RULES:
        for source in sources:
            found += [(rule.__name__, source.path, line, message) for line, message in rule(source)]
    for rule in TREE_RULES:
        found += [(rule.__name__, path, line, message) for path, line, message in rule(by_path)]
    return sorted(found, key=lambda finding: (finding[1], finding[2], finding[0]))


def parse_expectations(text):
    """{(rule, path): line number}, and what is wrong with the list itself."""
    known = {rule.__name__ for rule in FILE_RULES + TREE_RULES}
    expected, wrong = {}, []
    for number, line in enumerate(text.split("\n"), 1):
        if not line.strip() or line.startswith("#"):
            continue
        match = re.fullmatch(r"(\w+) (\S+) +# (\S.*)", line)
        if not match:
            wrong.append(f"{EXPECT}:{number}: expected `rule path  # reason`")
        elif match[1] not in known:
            wrong.append(f"{EXPECT}:{number}: there is no rule {match[1]}")
        elif (match[1], match[2]) in expected:
            wrong.append(f"{EXPECT}:{number}: listed twice")
        else:
            expected[match[1], match[2]] = number
    return expected, wrong


def judge(found, expectations):
    """The lines to print; none when the tree is as expected."""
    expected, failures = parse_expectations(expectations)
    failures += [f"{path}:{line}: {rule}: {message}" for rule, path, line, message in found if (rule, path) not in expected]
    clean = set(expected) - {(rule, path) for rule, path, _, _ in found}
    failures += [
        f"{EXPECT}:{expected[key]}: {key[1]} has become clean of {key[0]}; take the line out" for key in sorted(clean)
    ]
    return failures


def parse_ratchet(text):
    """{(rule, path): count}"""
    lines = [line.split() for line in text.split("\n") if line and not line.startswith("#")]
    return {(rule, path): int(count) for rule, path, count in lines}


def judge_ratchet(found, text):
    """The lines to print for the rules that are counted; none when the counts are as listed."""
    listed = parse_ratchet(text)
    counts = Counter((rule, path) for rule, path, _, _ in found)
    failures = []
    for rule, path, line, message in found:
        if counts[rule, path] > listed.get((rule, path), 0):
            failures.append(f"{path}:{line}: {rule}: {message}")
    for (rule, path), count in sorted(listed.items()):
        if counts[rule, path] < count:
            failures.append(f"{path}: {rule}: {counts[rule, path]} left of {count}; run scripts/lint --lower")
    return failures


def lowered(found, text):
    """The list with what has become less; what has become more stays and fails."""
    comments = [line for line in text.split("\n") if line.startswith("#")]
    counts = Counter((rule, path) for rule, path, _, _ in found)
    kept = {key: min(count, counts[key]) for key, count in parse_ratchet(text).items()}
    return "\n".join(comments + [f"{rule} {path} {count}" for (rule, path), count in sorted(kept.items()) if count > 0]) + "\n"


def read_list(root, name):
    path = Path(root, name)
    return path.read_text(encoding="utf-8") if path.exists() else ""


def main(root, lower):
    sources = read_tree(root)
    if not any(source.path == "include/abut/abut.h" for source in sources):
        print(f"lint: {root} is not the root of the tree", file=sys.stderr)
        return 2
    found = findings_of(sources)
    counted = [finding for finding in found if finding[0] in RATCHETED]
    if lower:
        Path(root, RATCHET).write_text(lowered(counted, read_list(root, RATCHET)), encoding="utf-8")
    failures = judge([finding for finding in found if finding[0] not in RATCHETED], read_list(root, EXPECT))
    failures += judge_ratchet(counted, read_list(root, RATCHET))
    for source in filter(is_long, sources):
        print(f"{source.path}: note: {source.length} lines, more than a file should have")
    unsafe = {source.path: count_unsafe(source) for source in sources if not source.within("tools/lint")}
    print(f"lint: {len(sources)} files, {sum(unsafe.values())} unsafe blocks in {sum(map(bool, unsafe.values()))} files")
    print("lint: known and to become less: " + ", ".join(f"{rule} {sum(f[0] == rule for f in counted)}" for rule in RATCHETED))
    for failure in failures:
        print(failure)
    if failures:
        print(f"lint: {len(failures)} failure(s)")
    return 1 if failures else 0


if __name__ == "__main__":
    arguments = sys.argv[1:]
    is_lowering = "--lower" in arguments
    roots = [argument for argument in arguments if argument != "--lower"]
    sys.exit(main(roots[0] if roots else Path(__file__).resolve().parents[2], is_lowering))
