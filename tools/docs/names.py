# SPDX-License-Identifier: Apache-2.0
"""The names that the C headers declare, and the pages of the site with the names that each of them speaks of."""

import re

HEADERS = ("abut", "picking", "response")
ROOT_PAGES = ("README", "CHANGELOG", "CONTRIBUTING", "SECURITY")

NAME = re.compile(r"\b(?:abut|ABUT)_\w+")
_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)
_DECLARED = (
    re.compile(r"\bABUT_API\b[^;{}()]*?\b(abut_\w+)\s*\("),        # functions
    re.compile(r"\btypedef\b[^;{}()]*\(\s*\*\s*(abut_\w+)\s*\)"),  # types of functions
    re.compile(r"\btypedef\b[^;{}()]*?\b(abut_\w+)\s*;"),          # handles and numbers
    re.compile(r"^}\s*(abut_\w+)\s*;", re.MULTILINE),              # structs
    re.compile(r"^#define\s+(ABUT_\w+)(?=[ (])", re.MULTILINE),
    re.compile(r"^ +(ABUT_\w+)\s*=", re.MULTILINE),                # enumerators
)


def declared(text):
    """The names that a C header declares."""
    code = _COMMENT.sub("", text)
    return {match[1] for pattern in _DECLARED for match in pattern.finditer(code)}


def label(path):
    """What Doxygen calls a page; `path` is that of the page in the tree."""
    return "mainpage" if path == "README.md" else "page_" + path.removeprefix("docs/").removesuffix(".md").lower()


def anchor(heading):
    """The anchor of a heading, as GitHub makes it."""
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")


class Site:
    """What the pages and headers of a tree say of each other."""

    def __init__(self, pages, headers):
        """`pages` and `headers` are texts by path."""
        self.names = set().union(*map(declared, headers.values()))
        self.titles, self.pages_of = {}, {}
        for path, text in sorted(pages.items()):
            title = re.search(r"^# (.+)$", text, re.MULTILINE)
            self.titles[path] = title[1].replace("`", "") if title else path
            if path.startswith("docs/"):
                for name in set(NAME.findall(text)) & self.names:
                    self.pages_of.setdefault(name, []).append(path)


def read(root):
    """The Site of a tree on disk."""
    paths = [root / f"{name}.md" for name in ROOT_PAGES] + sorted((root / "docs").glob("*.md"))
    pages = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in paths}
    headers = {name: (root / f"include/abut/{name}.h").read_text(encoding="utf-8") for name in HEADERS}
    return Site(pages, headers)
