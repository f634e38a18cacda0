# SPDX-License-Identifier: Apache-2.0
"""The raw layer of LuaJIT: all declarations, as ffi.cdef takes them."""

from header import Alias, Function, Opaque, Struct

PATH = "bindings/lua/abut_cdef.lua"


def _named(variable):
    spelled = str(variable.type)
    array = f"[{variable.type.length}]" if variable.type.length else ""
    return f"{spelled}{'' if spelled.endswith('*') else ' '}{variable.name}{array}"


def _parameters(function):
    return ", ".join(_named(parameter) for parameter in function.parameters) or "void"


def _declared(item):
    if isinstance(item, Alias):
        yield f"typedef {item.type} {item.name};"
        if item.values:
            values = ", ".join(f"{value.name} = {value.value}" for value in item.values)
            yield f"enum {item.name}_value {{ {values} }};"
    elif isinstance(item, Opaque):
        yield f"typedef struct {item.name} {item.name};"
    elif isinstance(item, Struct):
        fields = " ".join(f"{_named(field)};" for field in item.fields)
        yield f"typedef struct {item.name} {{ {fields} }} {item.name};"
    elif isinstance(item, Function):
        result = f"{item.result}{'' if item.result.pointers else ' '}"
        if item.is_callback:
            yield f"typedef {result}(*{item.name})({_parameters(item)});"
        else:
            yield f"{result}{item.name}({_parameters(item)});"


def files(interface, notice):
    lines = ["-- SPDX-License-Identifier: Apache-2.0", f"-- {notice}", 'require("ffi").cdef [[']
    for header in interface.headers:
        lines += [line for item in header.items for line in _declared(item)]
    major, minor = (interface.by_name[f"ABUT_VERSION_{part}"].value for part in ("MAJOR", "MINOR"))
    lines += ["]]", f"return {{major = {major}, minor = {minor}}}", ""]
    return {PATH: "\n".join(lines)}
