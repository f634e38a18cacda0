#!/usr/bin/env python3
"""Checks the rules of the tree that no compiler checks.

usage: lint.py [root]

Exceptions stand in expect.txt, one per line: `rule path  # reason`. It is a ratchet: a finding that
is not listed fails, and so does a line whose file has become clean.
"""

import re
import sys
from pathlib import Path

from rules import FILE_RULES, count_unsafe, is_long
from source import read_tree
from tree_rules import TREE_RULES

EXPECT = "tools/lint/expect.txt"


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


def main(root):
    sources = read_tree(root)
    if not any(source.path == "include/abut/abut.h" for source in sources):
        print(f"lint: {root} is not the root of the tree", file=sys.stderr)
        return 2
    expect = Path(root, EXPECT)
    failures = judge(findings_of(sources), expect.read_text(encoding="utf-8") if expect.exists() else "")
    for source in filter(is_long, sources):
        print(f"{source.path}: note: {source.length} lines, more than a file should have")
    unsafe = {source.path: count_unsafe(source) for source in sources if not source.within("tools/lint")}
    print(f"lint: {len(sources)} files, {sum(unsafe.values())} unsafe blocks in {sum(map(bool, unsafe.values()))} files")
    for failure in failures:
        print(failure)
    if failures:
        print(f"lint: {len(failures)} failure(s)")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]))
