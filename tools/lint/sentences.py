# SPDX-License-Identifier: Apache-2.0
"""The rules on the length of sentences in comments and in documents."""

import re

WORDS = 25
_COMMENT = re.compile(r"^\s*(?://+<?|/\*\*?<?|\*)(?: (?!SPDX)(.*))?$")
_END = re.compile(r"(?<=[.!?;:])\s+")
_ITEM = re.compile(r"^\s*[-*@] |^\s*@\w+|^\s{3,}\S")


def _paragraphs(text):
    """(line, words in one string) of each paragraph or list item of the comments that fill whole lines."""
    start, parts = 0, []
    for number, line in enumerate([*text.split("\n"), ""], 1):
        match = _COMMENT.match(line)
        body = (match[1] or "") if match else ""
        if parts and (not body.strip() or _ITEM.match(body)):
            yield start, " ".join(parts)
            parts = []
        if body.strip():
            start = start if parts else number
            parts.append(body.strip())


def sentence_length(source):
    """A sentence of a comment has at most 25 words; 20 are better."""
    if not (source.is_cxx or source.is_c):
        return
    for line, paragraph in _paragraphs(source.text):
        for sentence in _END.split(paragraph):
            words = [word for word in sentence.split() if re.search("[A-Za-z]", word)]
            if len(words) > WORDS:
                yield line, f"{len(words)} words in a sentence: {' '.join(words[:6])} ..."


_FENCE = re.compile(r"^\s*```")
_CODE = re.compile(r"^ {4}\S")
_MARKED = re.compile(r"^\s*(?:[-*]|\d+\.)\s|^\s*$")
_ROW = re.compile(r"^\s*\||^#")
_PLAIN = ((re.compile(r"`[^`]*`"), "code"), (re.compile(r"!\[[^\]]*\]\([^)]*\)|<!--.*?-->"), ""), (re.compile(r"\[([^\]]*)\]\([^)]*\)"), r"\1"))


def _prose(text):
    """(line, words in one string) of each paragraph, heading, list item and cell of a document; code is left out."""
    start, parts, is_fenced, may_be_code = 0, [], False, True
    for number, line in enumerate([*text.split("\n"), ""], 1):
        is_row, is_border = bool(_ROW.match(line)), bool(_FENCE.match(line))
        is_code = is_fenced or is_border or (may_be_code and bool(_CODE.match(line)))
        if parts and (is_row or is_code or _MARKED.match(line)):
            yield start, " ".join(parts)
            parts = []
        is_fenced ^= is_border
        may_be_code = is_code or not line.strip()
        if is_row:
            yield from ((number, cell) for cell in line.split("|"))
        elif line.strip() and not is_code:
            start = start if parts else number
            parts.append(line.strip())


def prose_length(source):
    """A sentence of a document has at most 25 words; 20 are better."""
    if source.suffix != ".md" or source.name == "CHANGELOG.md":
        return
    for line, paragraph in _prose(source.text):
        for pattern, plain in _PLAIN:
            paragraph = pattern.sub(plain, paragraph)
        for sentence in _END.split(paragraph):
            words = [word for word in sentence.split() if re.search("[A-Za-z]", word)]
            if len(words) > WORDS:
                yield line, f"{len(words)} words in a sentence: {' '.join(words[:6])} ..."
