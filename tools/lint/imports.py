# SPDX-License-Identifier: Apache-2.0
"""The graph of module imports and includes, and the rule on who may reach a kernel."""

import posixpath
import re

_MODULE = re.compile(r"^\s*export\s+module\s+([\w.]+)\s*;", re.MULTILINE)
_NAMED = re.compile(r"^\s*(?:(?:export\s+)?import|module)\s+([\w.]+)\s*;", re.MULTILINE)
_INCLUDED = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)

# Those who ask the table of pairs, and so see no kernel.
ASKERS = ("modules/pairs/table.cppm", "modules/pairs/routes.cppm", "modules/pairs/any_shape", "modules/pairs/two_shapes", "modules/pairs/shape_handle.cppm.in", "modules/narrow/manifold", "modules/scene", "modules/detect", "modules/queries", "modules/report", "modules/universe", "modules/picking", "modules/response", "capi")
KERNELS = ("modules/narrow", "modules/pairs/rows")
# Records that callers keep or read, and what works on records alone.
RECORDS = (
    "modules/narrow/apart/pair_hint.cppm",
    "modules/narrow/warm/pair_memory.cppm",
    "modules/narrow/warm/side_memory.cppm",
    "modules/narrow/manifold",
    "modules/narrow/cast/cast_search.cppm",
    "modules/narrow/cast/linear_cast.cppm",
    "modules/narrow/cast/parts_in_order.cppm",
)


def import_graph(sources):
    """{path: paths of what it imports, implements or includes}"""
    files = {}
    for path, source in sources.items():
        if source.is_cxx and (match := _MODULE.search(source.code)):
            files[match[1]] = path
    graph = {}
    for path, source in sources.items():
        if source.is_cxx:
            near = posixpath.dirname(path)
            included = [posixpath.normpath(posixpath.join(folder, name)) for name in _INCLUDED.findall(source.bare)
                        for folder in dict.fromkeys((near, "capi"))]
            named = [files[name] for name in _NAMED.findall(source.code) if name in files]
            graph[path] = [other for other in named + included if other in sources and other != path]
    return graph


def reached_from(graph, path):
    """{path: the file through which it is reached} of all files below one."""
    through, stack = {}, [path]
    while stack:
        current = stack.pop()
        for other in graph.get(current, []):
            if other not in through:
                through[other] = current
                stack.append(other)
    return through


def kernel_reach(sources):
    """A change of a kernel compiles the rows of the table again, and none of those who ask it."""
    graph = import_graph(sources)
    for path in graph:
        if sources[path].within(*ASKERS):
            through = reached_from(graph, path)
            for other in sorted(through):
                if sources[other].within(*KERNELS) and not sources[other].within(*RECORDS):
                    yield path, 1, f"reaches the kernel {other} through {through[other]}"
                    break


_DECLARED = (
    re.compile(r"\b(?:struct|class|concept|enum|union)\s+(?:(?:class|struct)\s+)?(?:\[\[[^\]]*\]\]\s*|alignas\s*\([^)]*\)\s*)*(\w+)"),
    re.compile(r"\busing\s+(\w+)\s*="),
    re.compile(r"\b(\w+)\s*\("),
    re.compile(r"\b(\w+)\s*(?:\{[^{}]*\}\s*)?(?:=|\[|$)"),
)
_SPECIFIERS = re.compile(r"\[\[[^\]]*\]\]|\btemplate\b|\brequires\b|\balignas\s*\([^)]*\)")
_FOREIGN = re.compile(r"^\s*(?:export\s+)?using\s+(?:\w+::)+(\w+)\s*;", re.MULTILINE)


def declared_names(code):
    """Names that stand at the level of namespaces, and so may be seen by importers."""
    names, depth, levels, start = set(_FOREIGN.findall(code)), 0, [], 0
    for i, c in enumerate(code):
        if c == "{":
            statement = code[start:i]
            is_outer = re.search(r"\bnamespace\b[^;(){}]*$|\bexport\s*$", statement) is not None
            if depth == 0 and not is_outer:
                names.update(_names_of(statement))
            depth += 0 if is_outer else 1
            levels.append(is_outer)
            start = i + 1
        elif c == "}" and levels:
            depth -= 0 if levels.pop() else 1
            start = i + 1
        elif c == ";":
            if depth == 0:
                names.update(_names_of(code[start:i]))
            start = i + 1
    return names


def _names_of(statement):
    statement = _SPECIFIERS.sub(" ", statement)
    return {match[1] for pattern in _DECLARED for match in pattern.finditer(statement)}


def unused_import(sources):
    """A file names something of each module that it imports."""
    files = {match[1]: path for path, source in sources.items() if source.is_cxx and (match := _MODULE.search(source.code))}
    offered = {}

    def offer(module, seen):
        if module in offered:
            return offered[module]
        names = declared_names(sources[files[module]].code)
        for again in re.findall(r"^\s*export\s+import\s+([\w.]+)\s*;", sources[files[module]].code, re.MULTILINE):
            if again in files and again not in seen:
                names |= offer(again, seen | {again})
        offered[module] = names
        return names

    for path, source in sources.items():
        if not source.is_cxx or source.within("tests/compile_fail"):
            continue
        words = set(re.findall(r"\b\w+\b", _NAMED.sub("", source.code)))
        for line, match in source.find(r"^\s*import\s+([\w.]+)\s*;", source.code):
            if match[1] in files and not words & offer(match[1], {match[1]}):
                yield path, line, f"names nothing of {match[1]}"
