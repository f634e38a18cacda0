# SPDX-License-Identifier: Apache-2.0
"""The documents of the tree, and the blocks of code in them."""

import dataclasses
import re
import textwrap

FENCE = re.compile(r"^( *)```(\S*)[^`]*$")
COMMENT = re.compile(r"<!--(.*?)-->", re.DOTALL)
MARKERS = ("no-run", "no-check", "given", "from", "continues", "file scope", "run")
# What nobody wrote as a document: builds, and files that come from elsewhere.
SKIPPED = {"build", "out", ".git", "node_modules", "corpus", "regress"}


@dataclasses.dataclass
class Block:
    page: str  # path below the root
    line: int  # of the first line of code
    language: str
    code: str
    markers: dict  # {name: what follows the colon}
    output: str | None = None  # what it prints: the block of `text` directly below

    @property
    def place(self):
        return f"{self.page}:{self.line}"

    def wrong_output(self, printed):
        """What differs from the output that the page shows; empty where nothing does, or where it shows none."""
        if self.output is None or printed.rstrip() == self.output.rstrip():
            return ""
        return f"{self.place}: prints\n{printed.rstrip()}\ninstead of\n{self.output.rstrip()}\n"


class BadPage(Exception):
    """A page that breaks the rules of CONTRIBUTING.md."""


def documents(root):
    """Paths of all documents below root."""
    found = sorted(root.rglob("*.md"))
    return [path for path in found if not SKIPPED & set(path.relative_to(root).parts)]


def _markers_of(page, line, text):
    markers = {}
    for comment in COMMENT.findall(text):
        name, _, rest = comment.strip().partition(":")
        name = name.strip()
        if name in MARKERS:
            markers[name] = textwrap.dedent(rest.strip("\n")).strip()
            if name in ("no-run", "no-check", "from", "given") and not markers[name].strip():
                raise BadPage(f"{page}:{line}: the marker {name} says nothing after its colon")
    return markers


def _is_text(lines):
    """Whether something else stands there than comments, of which the last may not have ended yet."""
    rest = COMMENT.sub("", lines).strip()
    return rest != "" and not rest.startswith("<!--")


def blocks(page, text):
    """The fenced blocks of a page, each with the comments that stand directly before it."""
    lines = text.split("\n")
    found, start, before, is_directly_below = [], None, [], False
    for number, line in enumerate(lines, 1):
        fence = FENCE.match(line)
        if start is None and fence:
            start = (number, len(fence[1]), fence[2])
        elif start is not None and line.strip() == "```":
            opened, indent, language = start
            code = "\n".join(part[indent:] for part in lines[opened : number - 1]) + "\n"
            if language == "text" and found and is_directly_below:
                found[-1].output = code
            else:
                found.append(Block(page, opened + 1, language, code, _markers_of(page, opened, "\n".join(before))))
            start, before, is_directly_below = None, [], True
        elif start is None:
            before.append(line)
            is_directly_below = is_directly_below and not line.strip()
            if _is_text("\n".join(before)):
                before = []
    if start is not None:
        raise BadPage(f"{page}:{start[0]}: a block that does not end")
    return found
