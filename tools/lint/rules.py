# SPDX-License-Identifier: Apache-2.0
"""Rules for one file at a time. Each is a function of a Source that yields (line, message)."""

import re

from members import borrowed_members
from sentences import prose_length, sentence_length

COLUMNS = 120
HARD_LENGTH = 600
SOFT_LENGTH = 300
MADE = "Made by scripts/interface"  # nobody reads such a file from top to bottom, or edits it
RAW = "modules/core/raw"
LICENSED = {".py", ".sh", ".map", ".yml", ".yaml", ".rs", ".go", ".cs", ".lua", ".mjs", ".ts", ""}
LICENCE = "SPDX-License-Identifier: Apache-2.0"

# The only folders that may touch a library, by the name of its include folder.
LIBRARY_OWNERS = {
    "Eigen": ("modules/math", "modules/response"),
    "embree[34]?": ("modules/picking", "bench"),
    "boost": ("modules/deforming",),
    "ccd": ("modules/narrow", "bench"),
    "libqhull(?:_r)?": ("modules/shapes", "bench"),
}

def _in_code(source, pattern, message):
    for line, match in source.find(pattern, source.code):
        yield line, message.format(match[0].strip())


def raw_memory(source):
    """memcpy and its kin outside modules/core/raw*. Tests of bad input make bytes that are no value of any type."""
    if source.is_cxx and not source.path.startswith(RAW) and not source.within("tests/interface"):
        yield from _in_code(
            source, r"\b(?:mem(?:cpy|set|move)|str(?:len|n?cpy|n?cat)|alloca)\b(?=\s*\()", "{} outside modules/core/raw*"
        )


def unsafe_word(source):
    """Casts that lie, manual ownership and jumps."""
    if not source.is_cxx:
        return
    words = r"\b(?:reinterpret_cast|const_cast|union|goto|malloc|calloc|realloc|shared_ptr)\b"
    yield from _in_code(source, words, "{} needs a place in expect.txt")
    yield from _in_code(source, r"(?<!<)\bnew\b", "{}: values, containers and make_unique instead")
    for line, _ in source.find(r"\bdelete\b", re.sub(r"=(\s*)delete\b", r"=\1      ", source.code)):
        yield line, "delete: owners free by themselves"
    yield from _in_code(source, r"\bunique_ptr\s*<[^;<>]*\[\s*\]", "{}: vector instead")


def unsafe_block(source):
    """ABUT_UNSAFE_BEGIN with its reason, in the folders that may have it, and closed."""
    if not (source.is_cxx or source.is_c):
        return
    depth = 0
    lines = source.text.split("\n")
    for line, match in source.find(r"(?<!define )\bABUT_UNSAFE_(?:BEGIN|END)\b", source.code):
        if match[0].endswith("END"):
            depth -= 1
            if depth < 0:
                yield line, "ABUT_UNSAFE_END without a beginning"
                depth = 0
            continue
        depth += 1
        if depth > 1:
            yield line, "ABUT_UNSAFE_BEGIN inside another"
            depth = 1
        if not _has_reason(lines, line - 2):
            yield line, "ABUT_UNSAFE_BEGIN without a `// SAFETY:` reason on the line above"
    if depth:
        yield len(lines), "ABUT_UNSAFE_BEGIN without an end"


def _has_reason(lines, i):
    """Goes up through a block of // comments to the line that begins the reason."""
    while i >= 0 and lines[i].lstrip().startswith("//"):
        if re.match(r"\s*// SAFETY: \S", lines[i]):
            return True
        i -= 1
    return False


def unsafe_place(source):
    """Unsafe blocks stay at the edges: the C ABI, raw memory and the wrapper of a foreign handle."""
    if not source.is_cxx or source.within("capi", "modules/picking") or source.path.startswith((RAW, "modules/core/check")):
        return
    yield from _in_code(source, r"\bABUT_UNSAFE_BEGIN\b", "{} outside capi, modules/picking and modules/core/raw*")


def count_unsafe(source):
    if not (source.is_cxx or source.is_c):
        return 0
    return len(re.findall(r"(?<!define )\bABUT_UNSAFE_BEGIN\b", source.code))


# Around nothing but includes, for headers of others that do not stand our warnings.
FOREIGN_INCLUDES = re.compile(
    r"^#pragma clang diagnostic push\n(?:#pragma clang diagnostic ignored [^\n]*\n)+"
    r"(?:#include <[^\n]*\n)+#pragma clang diagnostic pop$",
    re.MULTILINE,
)


def silenced_warning(source):
    """Warnings are turned off by cmake/flags.cmake or by ABUT_UNSAFE_BEGIN, nowhere else."""
    if not (source.is_cxx or source.is_c) or source.path == "modules/core/check.hpp":
        return
    code = FOREIGN_INCLUDES.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), source.code)
    pragma = r"^\s*#\s*pragma\s+(?:clang|GCC)\s+(?:diagnostic|unsafe_buffer_usage)\b|\b_Pragma\b"
    for line, match in source.find(pragma, code):
        yield line, f"{match[0].strip()} outside modules/core/check.hpp"


def library_owner(source):
    """Each foreign library is included by one folder."""
    if not (source.is_cxx or source.is_c):
        return
    for library, owners in LIBRARY_OWNERS.items():
        if not source.within(*owners):
            pattern = rf"^\s*#\s*include\s*[<\"]{library}/[^>\"]*"
            for line, match in source.find(pattern, source.bare):
                yield line, f"{match[0].split()[-1]} outside {', '.join(owners)}"


def standard_include(source):
    """Modules import the standard library: of each header that they include every importer would merge a copy."""
    if source.is_cxx and source.within("modules") and not source.within("modules/picking", "modules/response"):
        if source.path != "modules/core/standard.cppm":
            for line, match in source.find(r"^\s*#\s*include\s*<[a-z_]+>", source.bare):
                yield line, f"{match[0].split()[-1]} included, not imported from abut.core.standard"


def bare_tolerance(source):
    """A tolerance of the narrow phase has a name: in math/tolerance, or where the one search that it ends is."""
    if source.is_cxx and source.within("modules/narrow"):
        for number, line in enumerate(source.code.split("\n"), 1):
            if "constexpr" not in line and (match := re.search(r"(?<![\w.])\d[\d.]*e-\d+|\b\d+ \* epsilon\b", line)):
                yield number, f"{match[0]} has no name"


def borrowed_member(source):
    """A class that stores a view, a pointer or a reference is a [[gsl::Pointer]]: clang warns where one dangles."""
    if source.is_cxx and source.within("modules", "capi"):
        for line, what in borrowed_members(source.code):
            yield line, f"a member stores a borrowed `{what}`; the class is no [[gsl::Pointer]]"


def module_path(source):
    """The name of a module mirrors its path; what stands in for an absent feature has the name of the module."""
    if source.suffix != ".cppm" or not source.within("modules"):
        return
    path = ["abut", *source.path.split(".")[0].replace("_absent/", "/").split("/")[1:]]
    if path[-1] == path[-2]:
        path.pop()
    for line, match in source.find(r"^\s*export\s+module\s+([\w.]+)\s*;", source.code):
        if match[1] != ".".join(path):
            yield line, f"module {match[1]} lies in {source.path}"


def interface_linkage(source):
    """Anonymous namespaces in an interface unit are exposed by templates that use them."""
    if source.suffix == ".cppm" and re.search(r"^\s*export\s+module\b", source.code, re.MULTILINE):
        yield from _in_code(source, r"\bnamespace\s*\{", "anonymous {} in an interface unit")


def include_order(source):
    """Includes come before imports."""
    if source.is_cxx:
        first = next(source.find(r"^\s*(?:export\s+)?import\s+[\w.:]+\s*;", source.code), None)
        for line, _ in source.find(r"^\s*#\s*include\b", source.code):
            if first and line > first[0]:
                yield line, "an include after an import"


def macro(source):
    """Macros of modules stand in check.hpp, but for include guards; the C ABI may have its own."""
    if source.is_cxx and source.within("modules") and source.path != "modules/core/check.hpp":
        yield from _in_code(source, r"^\s*#\s*define\s+(?!ABUT_\w+_HPP$)\w+", "{} outside modules/core/check.hpp")


def _is_limited(source):
    is_code = source.is_cxx or source.is_c or source.is_cmake or source.suffix in (".py", ".sh", "")
    return is_code and MADE not in source.text


def length(source):
    """Files stay readable."""
    if _is_limited(source) and source.length > HARD_LENGTH:
        yield 1, f"{source.length} lines; the limit is {HARD_LENGTH}"


def is_long(source):
    return _is_limited(source) and SOFT_LENGTH < source.length <= HARD_LENGTH


def line_length(source):
    """Lines fit a screen, and two fit beside each other."""
    if (source.is_cxx or source.is_c) and MADE not in source.text:
        for number, line in enumerate(source.text.split("\n"), 1):
            if len(line) > COLUMNS:
                yield number, f"{len(line)} columns; the limit is {COLUMNS}"


def licence_line(source):
    """Every source names its licence, in the first line, or below the line that names its interpreter."""
    limited = source.is_cxx or source.is_c or source.is_cmake or source.suffix in LICENSED
    if limited and source.suffix != ".json" and LICENCE not in "\n".join(source.text.split("\n")[:2]):
        yield 1, f"no line {LICENCE}"


def concept_place(source):
    """What a kernel may ask a shape for stands in one room, documented."""
    if source.is_cxx and source.within("modules") and not source.within("modules/capability"):
        yield from _in_code(source, r"^\s*(?:export\s+)?concept\s+\w+(?=\s*=)", "{} outside modules/capability")


def flag(source):
    """Compiler flags are named by cmake/flags.cmake alone."""
    if not source.is_cmake or source.path == "cmake/flags.cmake":
        return
    flags = (
        r"(?<![\w./-])-(?:W(?!no-dev)[a-z][\w-]*|f[a-z][\w-]{3,}|m(?:arch|tune|cpu|avx|sse|fma)[\w-]*|O[0-3sgz]\b|g[0-3]?\b"
        r"|std(?:lib)?=\S+|D_\w+|Wl,\S+)"
    )
    yield from _in_code(source, flags, "{} outside cmake/flags.cmake")
    commands = r"\b(?:(?:add|target)_(?:compile|link)_options|add_compile_definitions|CMAKE_\w+_FLAGS\w*)\b"
    yield from _in_code(source, commands, "{} outside cmake/flags.cmake")


def word(source):
    """What must not be in the tree."""
    if source.within("tools/lint"):
        return
    for line, match in source.find(r"(?<![\w.}>)])/(?:work|tmp|root|home)(?=/|\b(?!\.))", source.text):
        yield line, f"{match[0]}: a path of one machine"
    for line, match in source.find(r"\b(?:TODO|FIXME|XXX|HACK)\b", source.text):
        yield line, f"{match[0]}: finish it or leave it out"


def closed_source(source):
    """Sources are papers, standards and files of this tree."""
    if not source.within("tools/lint"):
        for line, match in source.find(r"\bSPEC\b(?= [A-Z])", source.text):
            yield line, f"{match[0]}: a source that no reader can open"


def test_name(source):
    """TEST(Subject, FactInPresentTense)."""
    if not source.is_cxx or not source.within("tests", "fuzz"):
        return
    for line, match in source.find(r"^\s*(?:TYPED_)?TEST(?:_[FP])?\s*\(\s*(\w+)\s*,\s*(\w+)\s*\)", source.code):
        if not all(re.fullmatch(r"[A-Z][A-Za-z0-9]*", name) for name in match.groups()):
            yield line, f"{match[1]}, {match[2]}: PascalCase without underscores"


FILE_RULES = [
    raw_memory,
    unsafe_word,
    unsafe_block,
    unsafe_place,
    silenced_warning,
    library_owner,
    standard_include,
    bare_tolerance,
    borrowed_member,
    module_path,
    interface_linkage,
    include_order,
    macro,
    length,
    line_length,
    licence_line,
    sentence_length,
    prose_length,
    concept_place,
    flag,
    word,
    closed_source,
    test_name,
]
