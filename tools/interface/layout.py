# SPDX-License-Identifier: Apache-2.0
"""Sizes and offsets of structs on targets with 64-bit pointers, and the table of them."""

from header import SCALARS, Struct

PATH = "capi/layout_table.h"


def size_and_alignment(interface, type_):
    if type_.pointers:
        size = alignment = 8
    elif struct := interface.struct(type_):
        size, alignment, _ = of_struct(interface, struct)
    else:
        size = alignment = SCALARS[interface.number_of(type_.name)]
    return size * (type_.length or 1), alignment


def of_struct(interface, struct):
    """The size, the alignment, and for each field its offset and size."""
    end, strictest, places = 0, 1, []
    for field in struct.fields:
        size, alignment = size_and_alignment(interface, field.type)
        offset = -(-end // alignment) * alignment
        places.append((field.name, offset, size))
        end, strictest = offset + size, max(strictest, alignment)
    return -(-end // strictest) * strictest, strictest, places


def _table(interface, header):
    for struct in header.all(Struct):
        size, _, places = of_struct(interface, struct)
        yield f"TYPE({struct.name}, {size})"
        for name, offset, bytes_ in places:
            yield f"FIELD({struct.name}, {name}, {offset}, {bytes_})"


def files(interface, notice):
    lines = [f"/* {notice} */",
             "/* Sizes and offsets of the structs of the C interface, as every binding may rely on them: TYPE(struct, size) and",
             " * FIELD(struct, field, offset, size). On targets with 64-bit pointers, whatever the compiler. */",
             "#ifndef ABUT_LAYOUT_TABLE_H", "#define ABUT_LAYOUT_TABLE_H", "", "/* clang-format off */"]
    for header in interface.headers:
        prefix = "ABUT" if header is interface.headers[0] else f"ABUT_{header.name.upper()}"
        rows = "".join(f" \\\n  {row}" for row in _table(interface, header))
        lines.append(f"#define {prefix}_LAYOUT(TYPE, FIELD){rows}\n")
    lines += ["/* clang-format on */", "", "#endif", ""]
    return {PATH: "/* SPDX-License-Identifier: Apache-2.0 */\n" + "\n".join(lines)}
