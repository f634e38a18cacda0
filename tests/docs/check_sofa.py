# SPDX-License-Identifier: Apache-2.0
"""Compares the rows of docs/sofa.md with the tests of tests/sofa.

usage: check_sofa.py ROOT
A row has the names of SOFA, the answer, and what differs. Its test is named after its heading and its first name, with a
capital and letters alone, and calls everything that the answer names. A row whose answer is a dash says why in a sentence, and has no test.
"""

import dataclasses
import pathlib
import re
import sys

HEADER = ["SOFA", "here", "mind"]
TEST = re.compile(r"^TEST\((\w+), (\w+)\) \{\n(.*?)^\}", re.MULTILINE | re.DOTALL)
CODE = re.compile(r"`([^`]+)`")


@dataclasses.dataclass
class Row:
    line: int
    test: str  # suite.name
    answer: list  # of names; empty for a dash
    mind: str


def rows_of(text):
    suite, found = "", []
    for number, line in enumerate(text.split("\n"), 1):
        if line.startswith("## "):
            suite = "".join(word.capitalize() for word in line[3:].split())
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if not line.startswith("|") or len(cells) != 3 or cells == HEADER or set(line) <= set("|- "):
            continue
        name = re.sub(r"[^0-9A-Za-z]", "", (CODE.findall(cells[0]) or [""])[0])
        found.append(Row(number, f"{suite}.{name[:1].upper()}{name[1:]}",
                         [] if cells[1] == "-" else CODE.findall(cells[1]), cells[2]))
    return found


def tests_of(text):
    return {f"{suite}.{name}": body for suite, name, body in TEST.findall(text)}


def failures_of(rows, tests):
    seen = set()
    for row in rows:
        if row.test in seen:
            yield f"line {row.line}: {row.test} has two rows"
        seen.add(row.test)
        if not row.answer:
            if row.test in tests:
                yield f"line {row.line}: {row.test} is a test, and the row gives no answer"
            if len(row.mind.split()) < 4 or not row.mind.endswith("."):
                yield f"line {row.line}: {row.test} has neither an answer nor a sentence that says why"
        elif row.test not in tests:
            yield f"line {row.line}: there is no test {row.test}"
        else:
            for name in row.answer:
                if not re.search(rf"\b{re.escape(name)}\b", tests[row.test]):
                    yield f"line {row.line}: the test {row.test} does not name {name}"
    for test in sorted(set(tests) - seen):
        yield f"there is no row for the test {test}"


def main(root):
    rows = rows_of((root / "docs" / "sofa.md").read_text(encoding="utf-8"))
    tests = {}
    for path in sorted((root / "tests" / "sofa").glob("*_test.cpp")):
        tests |= tests_of(path.read_text(encoding="utf-8"))
    failures = list(failures_of(rows, tests))
    print(*failures, f"{len(rows)} rows, {len(tests)} tests, {len(failures)} failures", sep="\n")
    return 1 if failures or not rows else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
