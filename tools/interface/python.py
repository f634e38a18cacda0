# SPDX-License-Identifier: Apache-2.0
"""The raw layer of Python: constants, structs and functions for ctypes."""

import textwrap

from header import Alias, Function, Macro, Struct

FOLDER = "bindings/python/abut/c"
NUMBERS = {"double": "c_double", "uint64_t": "c_uint64", "size_t": "c_size_t", "uint32_t": "c_uint32",
           "int32_t": "c_int32"}
FIELDS = {"double": "Double", "uint64_t": "UInt64", "uint32_t": "UInt32"}
ARRAYS = {"double": "Doubles", "uint32_t": "UInt32s"}


def class_name(name):
    return "".join(word.capitalize() for word in name.removeprefix("abut_").split("_"))


def _c_type(interface, type_):
    """A type as ctypes has it; None for nothing."""
    if interface.struct(type_) or interface.find(type_.name, Function):
        base, depth = class_name(type_.name), type_.pointers
    elif type_.name == "abut_status":
        base, depth = "Status", type_.pointers
    elif type_.name == "char":
        base, depth = "c_char_p", type_.pointers - 1
    elif number := interface.number_of(type_.name):
        base, depth = NUMBERS[number], type_.pointers
    elif type_.pointers == 0:
        return "None"
    else:
        base, depth = "c_void_p", type_.pointers - 1
    return "POINTER(" * depth + base + ")" * depth


def _field_type(interface, type_):
    number = interface.number_of(type_.name)
    if type_.length:
        element = "c_char" if number == "char" else NUMBERS[number]
        return f"Annotated[{'bytes' if number == 'char' else 'Any'}, {element} * {type_.length}]"
    if not type_.pointers:
        return FIELDS[number] if number else class_name(type_.name)
    return "Text" if number == "char" else ARRAYS[number] if number else "Address"


def _base(struct):
    if struct.name.endswith("_id"):
        return "Id"
    return "Numbers" if all(str(field.type) == "double" and not field.type.length for field in struct.fields) else "Struct"


def _list(name, values):
    return textwrap.fill(f"{name} = [{', '.join(values)}]", 120, subsequent_indent="    ", break_on_hyphens=False)


def _constants(interface):
    yield '"""Constants of the headers, without their prefix."""'
    for header in interface.headers:
        groups = [header.all(Macro), *(alias.values for alias in header.all(Alias))]
        for group in (group for group in groups if group):
            yield ""
            yield from (f"{value.name.removeprefix('ABUT_')} = {value.value}" for value in group)


def _structs(interface):
    structs = [struct for header in interface.headers for struct in header.all(Struct)]
    yield '"""Structs of the headers, field by field."""\n\nfrom __future__ import annotations\n'
    yield "from ctypes import c_char, c_double, c_uint32, c_uint64\nfrom typing import Annotated, Any\n"
    yield "from .base import Address, Double, Doubles, Id, Numbers, Struct, Text, UInt32, UInt32s, UInt64, struct\n"
    yield _list("__all__", [f'"{class_name(struct.name)}"' for struct in structs])
    for struct in structs:
        yield f"\n\n@struct\nclass {class_name(struct.name)}({_base(struct)}):"
        yield from (f"    {field.name}: {_field_type(interface, field.type)}" for field in struct.fields)


def _functions(interface):
    def types(function):
        return [_c_type(interface, parameter.type) for parameter in function.parameters]

    def table(header):
        return "FUNCTIONS" if header is interface.headers[0] else f"{header.name.upper()}_FUNCTIONS"

    names = [class_name(callback.name) for callback in interface.callbacks]
    names += [table(header) for header in interface.headers]
    yield '"""Functions of the headers: what each answers and takes."""\n'
    yield "from ctypes import CFUNCTYPE, POINTER, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64, c_void_p\n"
    yield "from .structs import *\n"
    yield _list("__all__", [f'"{name}"' for name in names])
    yield "\nStatus = c_int32\n\n# Functions of the caller."
    for callback in interface.callbacks:
        yield f"{class_name(callback.name)} = CFUNCTYPE({', '.join([_c_type(interface, callback.result), *types(callback)])})"
    for header in interface.headers:
        yield f"\n{table(header)} = {{"
        for function in header.functions:
            entry = f'"{function.name}": ({_c_type(interface, function.result)}, [{", ".join(types(function))}]),'
            yield textwrap.fill(entry, 120, initial_indent="    ", subsequent_indent="        ", break_on_hyphens=False)
        yield "}"


def files(interface, notice):
    head = f"# SPDX-License-Identifier: Apache-2.0\n# {notice}\n"
    writers = {"constants": _constants, "structs": _structs, "functions": _functions}
    return {f"{FOLDER}/{name}.py": head + "\n".join(writer(interface)) + "\n" for name, writer in writers.items()}
