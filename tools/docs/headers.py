# SPDX-License-Identifier: Apache-2.0
"""A C header as Doxygen reads it: sections become groups, names and pages in comments become links.

No line is added or taken away, so warnings of Doxygen name lines of the header.
"""

import re

from names import NAME, label

_HEAD = re.compile(r"\A(/\* SPDX[^\n]*\n)?/\*\n \* \w+\.h - ")
_SECTION = re.compile(r"^/\* -{20,}\n \* ([^\n]+)\n((?: \*(?! -{20,})[^\n]*\n)*) \* -{20,} \*/$", re.MULTILINE)
_COMMENT = re.compile(r"/\*\*.*?\*/", re.DOTALL)
_THREAD_RULE = re.compile(r"\[(?:any|const|exclusive)\]")
_PAGE = re.compile(r"\bdocs/(\w[\w-]*)\.md\b")
_INIT = re.compile(r"^(?=ABUT_API void (abut_\w+)_init\()", re.MULTILINE)
_ENUM = re.compile(r"^(?=enum (abut_\w+)_value\b)", re.MULTILINE)
_STRUCT = re.compile(r"^(?=typedef struct (abut_\w+) \{)", re.MULTILINE)
_NUMBER = re.compile(r"^(?=typedef \w+ abut_\w+;\nenum (abut_\w+) )", re.MULTILINE)
_FIELD = re.compile(r"^  (?!return\b)[a-z][\w ]*[ *](\w+)(?:\[\w+\])*;$", re.MULTILINE)
_ENUMERATOR = re.compile(r"^  ABUT_(\w+) = [^,\n/]+,?$", re.MULTILINE)
_MACRO = re.compile(r"^#define ABUT_(\w+) [\w.-]+$", re.MULTILINE)
_DOCUMENTED = re.compile(r"\*/(?=\n(?:ABUT_API[^;{}()]*?\b|typedef (?:struct )?(?:[^;{}()]*?\(\*|[\w ]*?))(abut_\w+)\)?\s*(?:\(|;|\{))")


def _sections(text, stem):
    count = 0

    def begin(match):
        nonlocal count
        count += 1
        end = " @} */ /**" if count > 1 else ""
        # Lists of all sections show what stands before a colon.
        title, _, rest = match[1].partition(":")
        name = re.sub(r"\W+", "_", f"section {stem} {title}".lower())
        rest = rest.strip().removesuffix(".")
        return f"/**{end} @defgroup {name} {title}\n * {rest + '.' if rest else ''}\n{match[2]} * @{{ */"

    text = _SECTION.sub(begin, text)
    return text.rstrip("\n") + (" /** @} */\n" if count else "\n")


def _links(comment, site):
    def page(match):
        path = match[0]
        return f'@ref {label(path)} "{site.titles[path]}"' if path in site.titles else path

    comment = NAME.sub(lambda match: f'@ref {match[0]} "{match[0]}"' if match[0] in site.names else match[0], comment)
    comment = _PAGE.sub(page, comment)
    return _THREAD_RULE.sub(lambda match: f'@ref page_threads "{match[0]}"', comment)


def _described(match):
    """Whether a comment stands above; one behind `/**<` is that of the line before."""
    before = match.string[: match.start()]
    start = before.rfind("/*")
    return before.endswith("*/\n") and before.startswith("/**", start) and not before.startswith("/**<", start)


def _describe(pattern, text, before="", after=""):
    """Describes what a comment of the header does not: `before` and `after` are formats of the name."""

    def turn(match):
        words = {"struct_size": "size of the struct as the caller knows it", "reserved": "zero"}
        name = match[1]
        words = words.get(name, name.lower().replace("_", " "))
        return match[0] if _described(match) else before.format(name=name) + match[0] + after.format(words=words)

    return pattern.sub(turn, text)


def _pages_about(site):
    def see(match):
        pages = site.pages_of.get(match[1], [])
        links = ", ".join(f'@ref {label(path)} "{site.titles[path]}"' for path in pages)
        return f" @see {links} */" if links else "*/"

    return see


def for_doxygen(text, stem, site):
    """The text that Doxygen reads in place of the header `stem`.h."""
    text = _HEAD.sub(lambda match: f"{match[1] or ''}/** @file\n * ", text)
    text = _sections(text, stem)
    text = _describe(_INIT, text, "/** Fills {name} with defaults; `struct_size` is the size that the caller knows. */ ")
    text = _describe(_NUMBER, text, "/** One of {name}. */ ")
    text = _describe(_ENUM, text, "/** Values of {name}. */ ")
    text = _describe(_STRUCT, text, "/** Each field is described beside it. */ ")
    for named in (_FIELD, _ENUMERATOR, _MACRO):
        text = _describe(named, text, after=" /**< {words} */")
    text = _COMMENT.sub(lambda match: _links(match[0], site), text)
    return _DOCUMENTED.sub(_pages_about(site), text)
