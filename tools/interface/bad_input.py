# SPDX-License-Identifier: Apache-2.0
"""The table that the tests of bad input run over: every function that can fail, every parameter, every field."""

import math

import contract
from header import Alias, Struct
from layout import of_struct, size_and_alignment

FOLDER = "tests/interface"
HEAD = """// SPDX-License-Identifier: Apache-2.0
// {notice}
#include "table.hpp"

#include <abut/{header}.h>

namespace abut_test::table {{

"""


def _number(value):
    return repr(float(value))


def _range(range_):
    parts = []
    if range_.least > -math.inf:
        parts.append(f".least = {_number(range_.least)}")
    if range_.is_open:
        parts.append(".is_open = true")
    if range_.most < math.inf:
        parts.append(f".most = {_number(range_.most)}")
    parts += [f".{name} = true" for name in ("may_be_infinite", "may_be_nan", "may_be_far", "is_reserved", "is_unread") if getattr(range_, name)]
    return f", .range = {{{', '.join(parts)}}}" if parts else ""


def _row(interface, fact, offset=None):
    type_ = fact.type
    size = 8 if fact.role in ("handle", "handles", "made", "lent", "callback", "context", "text", "texts") else \
        1 if fact.role == "bytes" else size_and_alignment(interface, type(type_)(type_.name))[0]
    if fact.role == "text" and type_.pointers == 1:
        size = 1
    text = f'{{.name = "{fact.name}", .role = Role::{fact.role}, .type = "{type_.name}", .size = {size}'
    if offset is not None:
        text += f", .offset = {offset}"
    if type_.pointers:
        text += ", .is_pointer = true"
    if type_.length:
        text += f", .fixed_count = {type_.length}"
    if fact.is_array and fact.length:
        text += f', .length = "{fact.length}"'
    text += "".join(f", .{name} = true" for name in ("is_output", "may_be_null") if getattr(fact, name))
    if fact.role in ("choice", "bits"):
        values = [value.value for value in interface.find(type_.name, Alias).values]
        text += f", .known = {max(values) if fact.role == 'choice' else sum(values)}"
    if interface.number_of(type_.name) == "double" and fact.role == "number":
        text += ", .is_real = true"
    return text + _range(fact.range) + "}"


def _function(interface, function):
    facts = contract.arguments(interface, function)
    values = ", ".join(f"given[{index}]" for index in range(len(facts)))
    given = "given" if facts else ""
    rows = "".join(f"\n        {_row(interface, fact)}," for fact in facts)
    is_asked = contract.may_be_called_back(interface, function)
    return (f'    {{.name = "{function.name}",\n     .call = [](const Given& {given}) {{ return {function.name}({values}); }},\n'
            f"     .is_exclusive = {'true' if function.threads == 'exclusive' and not is_asked else 'false'},\n"
            f"     .arguments = {{{rows}\n     }}}},\n")


def _struct(interface, struct):
    _, _, places = of_struct(interface, struct)
    rows = "".join(f"\n        {_row(interface, fact, offset)},"
                   for fact, (_, offset, _) in zip(contract.fields(interface, struct), places))
    init = f"{struct.name}_init"
    call = f"[](void* place, std::uint32_t size) {{ {init}(static_cast<{struct.name}*>(place), size); }}" \
        if init in interface.by_name else "nullptr"
    return (f'    {{.name = "{struct.name}", .size = sizeof({struct.name}),\n     .init = {call},\n'
            f"     .fields = {{{rows}\n     }}}},\n")


def files(interface, notice):
    made = {}
    for header in interface.headers:
        functions = [function for function in header.functions if function.can_fail]
        made[f"{FOLDER}/rows_{header.name}.cpp"] = (
            HEAD.format(notice=notice, header=header.name) + "// clang-format off\n"
            + f"std::vector<Function> functions_of_{header.name}() {{\n  return {{\n"
            + "".join(_function(interface, function) for function in functions) + "  };\n}\n\n"
            + f"std::vector<Struct> structs_of_{header.name}() {{\n  return {{\n"
            + "".join(_struct(interface, struct) for struct in header.all(Struct)) + "  };\n}\n"
            + "// clang-format on\n\n}  // namespace abut_test::table\n")
    return made
