#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The code in docs/languages.md stands in the first queries, which are built and run.

usage: check_page.py root
"""

import re
import sys
import textwrap
from pathlib import Path

FIRST_QUERIES = {
    "rust": "rust/examples/first_query.rs",
    "js": "node/first_query.mjs",
    "lua": "lua/first_query.lua",
    "csharp": "csharp/FirstQuery/FirstQuery.cs",
    "go": "go/first_query/main.go",
}


def lines_of(text):
    return [line.strip() for line in textwrap.dedent(text).strip().split("\n")]


def main(root):
    page = Path(root, "docs/languages.md").read_text(encoding="utf-8")
    blocks = re.findall(r"^```(\w+)\n(.*?)^```$", page, flags=re.DOTALL | re.MULTILINE)
    missing = set(FIRST_QUERIES) - {language for language, _ in blocks}
    failures = [f"there is no block of {language}" for language in sorted(missing)]
    for language, text in blocks:
        if language in FIRST_QUERIES:
            source = Path(root, "bindings", FIRST_QUERIES[language]).read_text(encoding="utf-8")
            if "\n".join(lines_of(text)) not in "\n".join(lines_of(source)):
                failures.append(f"the block of {language} is not in bindings/{FIRST_QUERIES[language]}")
    print("\n".join(failures))
    return 1 if failures else 0


sys.exit(main(sys.argv[1]))
