# SPDX-License-Identifier: Apache-2.0
"""Checks the links of all documents to files and headings of the tree.

usage: check_links.py ROOT
Links to other hosts are not followed.
"""

import pathlib
import re
import sys
import urllib.parse

from pages import documents

LINK = re.compile(r"!?\[[^\]\[]*(?:\[[^\]]*\][^\]\[]*)*\]\(<?([^)>\s]+)>?(?:\s+\"[^\"]*\")?\)")
IMAGE = re.compile(r"<(?:img|source)\b[^>]*\bsrc(?:set)?=\"([^\"]+)\"")
HEADING = re.compile(r"^#{1,6} +(.*?)\s*#*$", re.MULTILINE)


def without_code(text):
    """Blanks blocks and spans of code, which may look like links."""
    text = re.sub(r"^( *```).*?^ *```$", lambda match: re.sub(r"[^\n]", " ", match[0]), text, flags=re.MULTILINE | re.DOTALL)
    return re.sub(r"`[^`\n]*`", lambda match: " " * len(match[0]), text)


def anchors(text):
    """What a heading is called in a link: lower case, hyphens for spaces, no other marks, and a number where it repeats."""
    without_blocks = re.sub(r"^( *```).*?^ *```$", "", text, flags=re.MULTILINE | re.DOTALL)
    found, seen = set(re.findall(r"<a\s+(?:id|name)=\"([^\"]+)\"", text)), {}
    for heading in HEADING.findall(without_blocks):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        name = re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")
        count = seen.get(name, 0)
        seen[name] = count + 1
        found.add(f"{name}-{count}" if count else name)
    return found


def failures_of(path, root):
    text = path.read_text(encoding="utf-8")
    code = without_code(text)
    for match in [*LINK.finditer(code), *IMAGE.finditer(code)]:
        place = f"{path.relative_to(root)}:{code.count(chr(10), 0, match.start()) + 1}"
        if re.match(r"[a-z]+:", match[1]):
            continue
        target, _, anchor = urllib.parse.unquote(match[1]).partition("#")
        file = (path.parent / target).resolve() if target else path
        if not file.exists():
            yield f"{place}: there is no {target}"
        elif root not in [file, *file.parents]:
            yield f"{place}: {target} lies outside of the tree"
        elif anchor and file.suffix == ".md" and anchor not in anchors(file.read_text(encoding="utf-8")):
            yield f"{place}: {target or 'this page'} has no heading #{anchor}"


def main(root):
    pages = documents(root)
    failures = [failure for path in pages for failure in failures_of(path, root)]
    print(*failures, f"{len(pages)} documents, {len(failures)} broken links", sep="\n")
    return 1 if failures or not pages else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]).resolve()))
