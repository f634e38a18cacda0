# SPDX-License-Identifier: Apache-2.0
"""Data members of classes, found by following braces; enough of C++ for code that is formatted."""

import re

_CLASS = re.compile(r"\b(?<!enum )(?:class|struct)\b[^;(){}=]*$")
_ATTRIBUTE = re.compile(r"\[\[.*?\]\]|\balignas\s*\([^)]*\)", re.S)
_LOOKS = re.compile(r"\[\[gsl::Pointer\]\]")
_NOT_DATA = re.compile(r"^\s*(?:using|friend|typedef|template|static_assert|enum|public|private|protected|requires|concept)\b")
_STATIC = re.compile(r"\bstatic\b")
_BORROWED = re.compile(r"\b(?:span|basic_string_view|string_view|mdspan|reference_wrapper)\b|[*&]")


def _opens_class(statement):
    """True when a brace after this text opens a class body."""
    return bool(_CLASS.search(_without_angles(_ATTRIBUTE.sub("", statement))))


def _without_angles(text):
    """Drops template arguments, so that a parenthesis that is left is one of a function."""
    previous = None
    while previous != text:
        previous = text
        text = re.sub(r"<[^<>]*>", "", text)
    return text


def _borrowed(statement):
    """What a member declaration stores that belongs to somebody else, or None."""
    declaration = re.sub(r"^\s*(?:(?:public|private|protected)\s*:\s*)+", "", statement)
    declaration = _ATTRIBUTE.sub("", declaration)
    if not declaration.strip() or _NOT_DATA.match(declaration) or _STATIC.search(declaration):
        return None
    declaration = re.split(r"(?<![<>=!])=(?!=)", declaration, maxsplit=1)[0]
    if "(" in _without_angles(declaration) or "operator" in declaration:
        return None  # a function, or a pointer to one
    match = _BORROWED.search(declaration)
    return match[0] if match else None


def borrowed_members(code):
    """Yields (line, what) for each member that is a view, a pointer or a reference, in classes that do not say so."""
    stack = []  # True for the body of a class that owns what it holds
    start = 0  # where the present statement begins
    parens = 0
    i = 0
    while i < len(code):
        c = code[i]
        if c == "#" and code[code.rfind("\n", 0, i) + 1 : i].strip() == "":
            end = code.find("\n", i)
            i = start = len(code) if end < 0 else end + 1
            continue
        if c == "(":
            parens += 1
        elif c == ")":
            parens -= 1
        elif c == "{" and parens == 0:
            statement = code[start:i]
            opens_class = _opens_class(statement)
            if stack and stack[-1] and not opens_class and "(" not in _without_angles(statement):
                # The initializer of a member: what counts stands before it.
                yield from _report(code, start, statement)
            stack.append(opens_class and not _LOOKS.search(statement))
            start = i + 1
        elif c == "{":
            i = _matching(code, i)
        elif c == "}" and parens == 0:
            if stack:
                stack.pop()
            start = i + 1
        elif c == ";" and parens == 0:
            if stack and stack[-1]:
                yield from _report(code, start, code[start:i])
            start = i + 1
        i += 1


def _report(code, start, statement):
    what = _borrowed(statement)
    if what:
        offset = start + len(statement) - len(statement.lstrip())
        yield code.count("\n", 0, offset) + 1, what


def _matching(code, i):
    depth = 0
    while i < len(code):
        depth += {"{": 1, "}": -1}.get(code[i], 0)
        if depth == 0:
            return i
        i += 1
    return i
