# SPDX-License-Identifier: Apache-2.0
"""A file of the tree as the rules see it: raw, without comments, and without comments and strings."""

import functools
import os
import re
from pathlib import Path, PurePosixPath

CXX = {".cppm", ".cpp", ".hpp"}
C = {".c", ".h"}
TEXT = CXX | C | {".cmake", ".in", ".txt", ".py", ".sh", ".md", ".json", ".jsonl", ".map", ".yml", ".yaml", ".js",
                  ".rs", ".go", ".cs", ".lua", ".mjs", ".ts"}
SKIPPED_FOLDERS = {".git", "build", "out", "__pycache__", "data", "corpus", "regress"}

_RAW_STRING = re.compile(r'R"([^()\\ \t\n]{0,16})\(')


def _blank(text):
    return re.sub(r"[^\n]", " ", text)


def strip_cxx(text, strings):
    """Blanks comments, and with `strings` also what stands between quotes. Keeps every offset."""
    out = []
    i = 0
    while i < len(text):
        two = text[i : i + 2]
        if two == "//":
            end = text.find("\n", i)
            end = len(text) if end < 0 else end
            out.append(_blank(text[i:end]))
        elif two == "/*":
            end = text.find("*/", i + 2)
            end = len(text) if end < 0 else end + 2
            out.append(_blank(text[i:end]))
        elif two == 'R"' and (start := _RAW_STRING.match(text, i)):
            end = text.find(f'){start[1]}"', i)
            end = len(text) if end < 0 else end + len(start[1]) + 2
            out.append('R"' + _blank(text[i + 2 : end - 1]) + '"' if strings else text[i:end])
        elif text[i] in "\"'" and not _is_digit_separator(text, i):
            end = _end_of_literal(text, i)
            inner = text[i + 1 : end - 1]
            out.append(text[i] + (_blank(inner) if strings else inner) + text[end - 1 : end])
        else:
            out.append(text[i])
            end = i + 1
        i = end
    return "".join(out)


def _is_digit_separator(text, i):
    return text[i] == "'" and i > 0 and text[i - 1].isalnum() and text[i + 1 : i + 2].isalnum()


def _end_of_literal(text, i):
    end = i + 1
    while end < len(text) and text[end] not in (text[i], "\n"):
        end += 2 if text[end] == "\\" else 1
    return min(end + 1, len(text))


def strip_hash(text):
    """Blanks the comments of CMake, Python and shell: from a # that no quote surrounds."""
    lines = []
    for line in text.split("\n"):
        quote = ""
        for i, c in enumerate(line):
            if quote:
                quote = "" if c == quote else quote
            elif c in "\"'":
                quote = c
            elif c == "#":
                line = line[:i] + " " * (len(line) - i)
                break
        lines.append(line)
    return "\n".join(lines)


class Source:
    def __init__(self, path, text):
        self.path = str(PurePosixPath(path))
        self.text = text
        # A template of a source is read as the source.
        template = self.path.removesuffix(".in")
        inner = PurePosixPath(template if PurePosixPath(template).suffix in CXX else path)
        self.suffix = inner.suffix
        self.name = inner.name
        self.stem = inner.stem

    @property
    def is_cxx(self):
        return self.suffix in CXX

    @property
    def is_c(self):
        return self.suffix in C

    @property
    def is_cmake(self):
        return self.suffix == ".cmake" or self.name in ("CMakeLists.txt", "CMakePresets.json")

    def within(self, *folders):
        return any(self.path == folder or self.path.startswith(folder.rstrip("/") + "/") for folder in folders)

    @functools.cached_property
    def bare(self):
        """Without comments; strings are kept."""
        return strip_cxx(self.text, strings=False) if self.is_cxx or self.is_c else strip_hash(self.text)

    @functools.cached_property
    def code(self):
        """Without comments and without what stands in strings. Includes keep their names."""
        if not (self.is_cxx or self.is_c):
            return self.bare
        return strip_cxx(self.text, strings=True)

    def find(self, pattern, text):
        """Yields (line number, match) for each match of a pattern."""
        for match in re.finditer(pattern, text, re.MULTILINE):
            yield text.count("\n", 0, match.start()) + 1, match

    @functools.cached_property
    def length(self):
        return sum(1 for line in self.text.split("\n") if line.strip())


def read_tree(root):
    """All text files below root that somebody wrote, in order of their paths."""
    root = Path(root)
    sources = []
    for folder, folders, names in os.walk(root):
        # A folder with a cache of CMake is a build, wherever it lies.
        is_build = "CMakeCache.txt" in names
        folders[:] = [] if is_build else sorted(set(folders) - SKIPPED_FOLDERS)
        for name in [] if is_build else names:
            path = Path(folder, name)
            if path.is_symlink() or not path.is_file():
                continue
            if path.suffix in TEXT or (path.suffix == "" and path.read_bytes()[:2] == b"#!"):
                sources.append(Source(path.relative_to(root).as_posix(), path.read_text(encoding="utf-8")))
    return sorted(sources, key=lambda source: source.path.split("/"))
