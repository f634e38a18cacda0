# SPDX-License-Identifier: Apache-2.0
"""The rule on the length of sentences in comments."""

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
