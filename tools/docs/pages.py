# SPDX-License-Identifier: Apache-2.0
"""A page as Doxygen reads it: headings get the anchors that links of other pages name, names of the C interface become
links, and files of the tree that no page shows lie below `files`."""

import posixpath
import re

from names import NAME, anchor, label

_FENCED = re.compile(r"(^```.*?^```[ ]*$)", re.MULTILINE | re.DOTALL)
_HIDDEN = re.compile(r"<!--.*?-->", re.DOTALL)
_HEADING = re.compile(r"^(#+) (.+)$", re.MULTILINE)
_LINK = re.compile(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])+)\]\(([^)\s]+)\)")
_PICTURE = re.compile(r"(!\[[^\]]+\]\()[^)\s]*?([^)/\s]+\))")
_CODE = re.compile(r"`([^`\n]+)`")


def target(path, link, site):
    """Where a link of the page at `path` leads on the site."""
    if re.match(r"\w+:", link):
        return link
    file, _, place = link.partition("#")
    file = posixpath.normpath(posixpath.join(posixpath.dirname(path), file)) if file else path
    if file in site.titles:
        return f"@ref {label(file)}" + (f"_{place}" if place else "")
    if re.fullmatch(r"include/abut/\w+\.h", file):
        return f"@ref {posixpath.basename(file)}"
    return f"files/{file}"


def linked_files(text, path, site):
    """The files and folders of the tree below `files` that a page leads to."""
    targets = {target(path, match[2], site) for match in _LINK.finditer(_FENCED.sub("", text))}
    return {found.removeprefix("files/") for found in targets if found.startswith("files/")}


def _heading(path, seen):
    def turn(match):
        place = anchor(match[2])
        seen[place] = seen.get(place, -1) + 1
        place += f"-{seen[place]}" if seen[place] else ""
        # Doxygen shows the signs of code in the titles of pages.
        title = match[2].replace("`", "") if match[1] == "#" else match[2]
        return f"{match[1]} {title} {{#{label(path)}{'_' + place if match[1] != '#' else ''}}}"

    return turn


def _code(site):
    def turn(match):
        name = re.fullmatch(r"(\w+)(\(\))?", match[1])
        return f"<code>@ref {name[1]} \"{match[1]}\"</code>" if name and name[1] in site.names else match[0]

    return turn


def _prose(text, path, site, seen):
    text = _HIDDEN.sub(lambda match: "\n" * match[0].count("\n"), text)
    text = _HEADING.sub(_heading(path, seen), text)
    text = _PICTURE.sub(r"\1\2", text)
    parts, end = [], 0
    for match in _LINK.finditer(text):
        # The text of a link is one line; what breaks it comes before.
        breaks = "".join(re.findall(r"\n\s*", match[1]))
        words = re.sub(r"\s*\n\s*", " ", match[1])
        parts += [_CODE.sub(_code(site), text[end : match.start()]), f"{breaks}[{words}]({target(path, match[2], site)})"]
        end = match.end()
    return "".join(parts) + _CODE.sub(_code(site), text[end:])


def for_doxygen(text, path, site):
    """The text that Doxygen reads in place of the page at `path`, line by line."""
    seen = {}
    parts = _FENCED.split(text)
    return "".join(part if i % 2 else _prose(part, path, site, seen) for i, part in enumerate(parts))
