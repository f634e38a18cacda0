# SPDX-License-Identifier: Apache-2.0
"""Checks that the headers for C++ reach every function of the C headers, and name every option.

usage: reach_all.py ROOT

A function is reached when its name stands in the code of a header below include/abut/cpp, or in picking.hpp for those
of picking.h, and so for response.h. Whoever adds a function to a C header adds a method there; the list of what is missing says which.
An option is named when a method with_... sets the field, which stands there as `C::field` or `abut_struct::field`.
"""

import pathlib
import re
import sys

PROTOTYPE = re.compile(r"\bABUT_API\b[^;{}()]*?\b(abut_\w+)\s*\(")
STRUCT = re.compile(r"typedef struct (abut_\w+) \{\s*uint32_t struct_size;([^{}]*)\}")
# What is no option: answers, and what the constructors of shapes fill in.
NO_OPTIONS = {"abut_hull_report", "abut_distance_field_report", "abut_mesh_report", "abut_geometry_info", "abut_step_stats",
              "abut_height_field_desc", "abut_distance_field_desc", "abut_distance_field_options", "abut_shape_desc", "abut_contact_problem"}
# What languages call whose callbacks take no structs. C++ has the other form.
OTHER_FORMS = {"abut_universe_set_pointer_filter"}
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def code_of(path):
    return COMMENT.sub(" ", path.read_text(encoding="utf-8"))


def unnamed_options(header, sources):
    """Fields of structs of options that no header for C++ sets."""
    for struct, body in STRUCT.findall(header):
        # The body of a struct of C++ that begins with this one.
        own = re.search(rf"\b{struct}_init>\s*\{{(.*?)\n\}};", sources, re.DOTALL)
        for field in re.findall(r"(\w+);", body) if struct not in NO_OPTIONS else []:
            if field != "reserved" and (own is None or not re.search(rf"::{field}\b", own[1])):
                yield f"{struct} has the field {field}; no method with_... sets it"


def main(root):
    include = root / "include" / "abut"
    rooms = {"abut.h": sorted((include / "cpp").glob("*.hpp")), "picking.h": [include / "picking.hpp"],
             "response.h": [include / "response.hpp"]}
    missing, count = [], 0
    for header, sources in rooms.items():
        declared = PROTOTYPE.findall(code_of(include / header))
        text = "\n".join(map(code_of, sources))
        reached = set(re.findall(r"\babut_\w+", text))
        missing += unnamed_options(code_of(include / header), text)
        count += len(declared)
        missing += [f"{header} declares {name}; no header for C++ calls it" for name in declared if name not in reached | OTHER_FORMS]
    print(*missing, f"{count} functions, {len(missing)} not reached", sep="\n")
    return 1 if missing or not count else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
