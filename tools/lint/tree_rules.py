# SPDX-License-Identifier: Apache-2.0
"""Rules that look at several files: layers, the registry of shapes, the C headers and their symbols.
Each is a function of {path: Source} that yields (path, line, message)."""

import re

from imports import kernel_reach, unused_import

REGISTRY = "cmake/registry.cmake"
SHAPE_LINE = r"^\s*abut_shape\s*\(\s*(\w+)\s+(\w+)\s+(\d+)[^)]*\)"
HEADERS = {"include/abut/abut.h": "capi/symbols.txt", "include/abut/picking.h": "capi/picking_symbols.txt",
           "include/abut/response.h": "capi/response_symbols.txt"}
PROTOTYPE = r"\bABUT_API\b[^;{}()]*?\b(abut_\w+)\s*\("

# Two surfaces that move are asked for each triangle, and programs in C++ may use any shape.
MAY_SEE_SHAPES = ("modules/shapes", "modules/pairs", "modules/motion/impacts/moving_surfaces.cpp", "modules/abut.cppm.in")
# Besides the shape's own file, which is checked by name: the typed shorthands of the C interface may name shapes, and so may
# libraries of their own, which ask through the C interface what a kind is.
EXTENSIONS = ("modules/picking", "modules/response", "capi/picking", "capi/response")
MAY_NAME_SHAPES = (*EXTENSIONS, "capi/shapes/shape.cpp", "capi/shapes/shape_simple.cpp", "capi/shapes/shape_particles.cpp", "capi/absent.cpp")

# Files of a folder of modules.
MOST_FILES = 14

DECLARES = r"\b(?:struct|class)\s+(?:alignas\s*\([^)]*\)\s*|\[\[[^\]]*\]\]\s*)*"

# Rank of a module by its folder; imports go from higher to lower or stay level.
LAYERS = [
    ("core", "core/memory", "core/threads"),
    ("math",),
    ("capability", "capability/cores", "capability/parts"),
    ("triangles", "triangles/elements"),
    ("trees/volumes", "trees/inside"),
    ("trees/boxes", "trees/grids", "trees/samples"),
    ("trees/elements",),
    ("shapes", "shapes/distance_field", "shapes/height_field", "shapes/hull", "shapes/mesh", "shapes/particles",
     "broadphase", "broadphase/kept"),
    ("narrow/cores",),
    ("narrow/apart", "narrow/fan", "narrow/manifold"),
    ("narrow/fan/discs",),
    ("narrow/polytope", "narrow/libccd", "narrow/libccd/query"),
    ("narrow/points",),
    ("narrow/convex",),
    ("narrow/warm", "narrow/triangle", "narrow/cast"),
    ("narrow/parts",),
    ("narrow/ways",),
    ("narrow/field",),
    ("narrow/walls",),
    ("narrow/surface",),
    ("narrow/sides", "narrow/two_surfaces", "narrow/overlap", "narrow/overlap/surfaces"),
    ("pairs", "deforming"),
    ("elements",),
    ("proximity", "proximity/search"),
    ("pairs/rows",),
    ("pairs/registry", "pairs/composites", "pairs/composites/rows", "pairs/surfaces", "pairs/surfaces/met"),
    ("pairs/any_shape", "pairs/any_shape/fields"),
    ("pairs/any_shape/casts", "pairs/two_shapes", "pairs/taken_apart"),
    ("motion", "motion/impacts", "motion/paths"),
    ("scene", "scene/state", "scene/meetings", "scene/rest"),
    ("detect", "detect/elements", "detect/pairs"),
    ("detect/lists",),
    ("queries", "queries/motion", "report", "detect/paths", "detect/continuous"),
    ("universe", "universe/motion"),
    ("picking", "picking/tracer", "picking/view", "response", "response/bodies", "response/manager", "response/report",
     "response/solver", "response/steps", "gpu"),
]
RANKS = {folder: rank for rank, folders in enumerate(LAYERS) for folder in folders}


def _folder(source):
    """The folder below modules that a module file lies in; None for what lies above all layers.
    What stands in for an absent feature lies in the layer of the feature."""
    parts = source.path.split("/")
    return "/".join(parts[1:-1]).removesuffix("_absent") if parts[0] == "modules" and len(parts) > 2 else None


def layer_order(sources):
    """Imports run one way."""
    module = r"^\s*(?:export\s+)?{}\s+([\w.]+)\s*;"
    folders = {}
    for source in sources.values():
        if source.suffix == ".cppm" and source.within("modules"):
            folders.update((match[1], _folder(source)) for _, match in source.find(module.format("module"), source.code))
    for path, source in sources.items():
        if not source.is_cxx or _folder(source) is None:
            continue
        if _folder(source) not in RANKS:
            yield path, 1, f"{_folder(source)} is no layer"
            continue
        for line, match in source.find(module.format("import"), source.code):
            if match[1].split(".")[0] != "abut":
                continue
            if match[1] not in folders:
                yield path, line, f"there is no module {match[1]}"
            elif RANKS.get(folders[match[1]], len(LAYERS)) > RANKS[_folder(source)]:
                yield path, line, f"{match[1]} lies above this file; imports run one way"


def room_size(sources):
    """What lies in one folder of modules is seen at one look."""
    files = {}
    for path in sources:
        if path.startswith("modules/"):
            files.setdefault(path.rpartition("/")[0], []).append(path)
    for folder, paths in files.items():
        if len(paths) > MOST_FILES:
            yield min(paths), 1, f"{folder} holds {len(paths)} files; {MOST_FILES} are allowed"


def _shapes(sources):
    registry = sources.get(REGISTRY)
    return [(line, match[1], match[2], match[3]) for line, match in registry.find(SHAPE_LINE, registry.bare)] if registry else []


def _is_of_shape(source, name):
    """A shape is one file, or a folder of its name."""
    return source.path == f"modules/shapes/{name}.cppm" or source.within(f"modules/shapes/{name}")


def registry(sources):
    """Each shape has one line, one file and a number of its own."""
    seen = {}
    for line, name, kind, tag in _shapes(sources):
        for what, value in (("name", name), ("type", kind), ("tag", tag)):
            if (what, value) in seen:
                yield REGISTRY, line, f"{what} {value} is taken by line {seen[what, value]}"
            seen[what, value] = line
        if not any(f"{place}.cppm" in sources for place in (f"modules/shapes/{name}", f"modules/shapes/{name}/{name}")):
            yield REGISTRY, line, f"shape {name} has no file modules/shapes/{name}.cppm"
    names = [name for _, name, _, _ in _shapes(sources)]
    for path, source in sources.items():
        if source.suffix == ".cppm" and source.within("modules/shapes") and names:
            if not any(_is_of_shape(source, name) for name in names):
                yield path, 1, f"no line of {REGISTRY} names this shape"


def shape_name(sources):
    """Adding a shape touches one file and one line: nobody else knows shapes by name."""
    for _, name, kind, _ in _shapes(sources):
        # A folder that declares a type of the same name means its own.
        own = {
            path.rpartition("/")[0]
            for path, source in sources.items()
            if not source.within("modules/shapes") and re.search(rf"{DECLARES}{kind}\b[^;()]*\{{", source.code)
        }
        for path, source in sources.items():
            if not source.is_cxx or not source.within("modules", "capi") or source.within(*MAY_NAME_SHAPES):
                continue
            if _is_of_shape(source, name):
                continue
            if path.rpartition("/")[0] not in own:
                for line, _ in source.find(rf"\b{kind}\b", source.code):
                    yield path, line, f"names the shape {kind}"
            for line, match in source.find(rf'"{name}"|\babut\.shapes\.{name}\b', source.bare):
                yield path, line, f"names the shape {match[0]}"


def sees_shapes(sources):
    """What sees a kind of shape is compiled again where one changes: nobody above pairs does."""
    for path, source in sources.items():
        if source.is_cxx and source.within("modules", "capi") and not source.within(*MAY_SEE_SHAPES):
            for line, match in source.find(r"^\s*(?:export\s+)?import\s+abut\.(?:pairs\.registry|shapes\.\w+)\s*;", source.code):
                yield path, line, f"sees every shape: {match[0].strip()}"


def glossary(sources):
    """Each word has one meaning."""
    page = sources.get("docs/glossary.md")
    seen = {}
    for line, match in page.find(r"^\| ([^|]+?) \|", page.text) if page else []:
        if match[1] in seen and match[1] != "term":
            yield page.path, line, f"{match[1]} has a meaning in line {seen[match[1]]} already"
        seen.setdefault(match[1], line)


def _struct_bodies(code):
    for match in re.finditer(r"\bstruct\s+\w+\s*\{([^{}]*)\}", code):
        yield match.start(1), match[1]


def header(sources):
    """The C headers hold what every language can call."""
    for path, source in sources.items():
        if not (source.within("include/abut") and source.suffix == ".h"):
            continue
        code = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: re.sub(r"[^\n]", " ", m[0]), source.code, flags=re.MULTILINE)

        def line_of(offset):
            return code.count("\n", 0, offset) + 1

        for match in re.finditer(r"\b(?:bool|_Bool|long|short|int|unsigned|signed|float|union|inline|static|wchar_t|ssize_t)\b|\.\.\.", code):
            yield path, line_of(match.start()), f"{match[0]} in a C header"
        for match in re.finditer(r"\benum\b(?!\s+\w+\s+ABUT_ENUM\s*\()", code):
            yield path, line_of(match.start()), "an enum type where its integer typedef belongs"
        for start, body in _struct_bodies(code):
            for match in re.finditer(r"\bsize_t\b", body):
                yield path, line_of(start + match.start()), "size_t in a struct"
            for match in re.finditer(r":\s*\d+\s*;", body):
                yield path, line_of(start + match.start()), "a bit-field"
            for match in re.finditer(r"\[\s*\]\s*;", body):
                yield path, line_of(start + match.start()), "a flexible array"
        for line, match in source.find(r'^\s*#\s*include\s*[<"]([^>"]*)[>"]', source.bare):
            if match[1] not in ("stddef.h", "stdint.h", "abut.h"):
                yield path, line, f"includes {match[1]}"


def prototypes(source):
    """Names of the functions that a C header declares."""
    return sorted(match[1] for match in re.finditer(PROTOTYPE, source.code))


def symbol_list(sources):
    """The committed list of symbols is what the header declares, sorted."""
    for path, listed_in in HEADERS.items():
        if path not in sources or listed_in not in sources:
            continue
        listed = sources[listed_in].text.split()
        declared = prototypes(sources[path])
        for name in sorted(set(declared) - set(listed)):
            yield listed_in, 1, f"{name} of {path} is missing"
        for name in sorted(set(listed) - set(declared)):
            yield listed_in, listed.index(name) + 1, f"{name} is not in {path}"
        if listed != sorted(set(listed)):
            yield listed_in, 1, "not sorted, or a name occurs twice"


TREE_RULES = [layer_order, room_size, glossary, kernel_reach, unused_import, registry, sees_shapes, shape_name, header, symbol_list]
