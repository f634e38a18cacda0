# SPDX-License-Identifier: Apache-2.0
"""The raw layer of C#: enumerations, structs, delegates and functions, for P/Invoke."""

import re
import textwrap
from xml.sax.saxutils import escape

import contract
from header import Alias, Struct
from layout import of_struct

PATH = "bindings/csharp/Abut/Raw.cs"
NUMBERS = {"double": "double", "uint64_t": "ulong", "size_t": "UIntPtr", "uint32_t": "uint", "int32_t": "int", "char": "byte"}
# What the wrapper calls otherwise. Hits of both libraries have the same fields.
NAMES = {"abut_vec3": "Vector", "abut_quat": "Quaternion", "abut_query_hit": "Hit", "abut_pick": "Hit"}
# Classes of the wrapper that hold a handle.
HANDLES = {"abut_shape": "Shape", "abut_universe": "Universe", "abut_picker": "Picker"}


def _pascal(name):
    return "".join(word[0].upper() + word[1:].lower() for word in name.removeprefix("abut_").split("_"))


def _camel(name):
    pascal = _pascal(name)
    lower = pascal[0].lower() + pascal[1:]
    return f"@{lower}" if lower in ("event", "object", "params", "ref", "out", "in") else lower


def _name(name):
    return NAMES.get(name, _pascal(name))


def _value_type(interface, type_):
    alias = interface.find(type_.name, Alias)
    if interface.struct(type_) or (alias and alias.values):
        return _name(type_.name)
    return NUMBERS[interface.number_of(type_.name)]


def _summary(item):
    """The first sentence of a comment."""
    text = re.split(r"(?<=[.:]) ", " ".join(item.doc.split()))[0].rstrip(":")
    if text:
        yield f"/// <summary>{escape(text)}</summary>"


def _enum(alias):
    names = [value.name.split("_") for value in alias.values]
    shared = 1
    while shared < min(map(len, names)) - 1 and len({tuple(name[:shared + 1]) for name in names}) == 1:
        shared += 1
    if alias.name == "abut_status":
        shared = 1
    values = [(_pascal("_".join(name[shared:])), value.value) for name, value in zip(names, alias.values)]
    is_bits = all(number != 0 for _, number in values)
    yield from _summary(alias)
    if is_bits:
        yield "[Flags]"
        values.insert(0, ("None", 0))
    yield f"public enum {_name(alias.name)} : {NUMBERS[alias.type.name]}"
    yield "{"
    yield from textwrap.wrap(", ".join(f"{name} = {number}" for name, number in values), 108,
                             initial_indent="    ", subsequent_indent="    ")
    yield "}"


def _struct(interface, struct):
    name = _name(struct.name)
    yield from _summary(struct)
    yield "[StructLayout(LayoutKind.Sequential)]"
    yield f"public partial struct {name}"
    yield "{"
    for field in struct.fields:
        type_ = "IntPtr" if field.type.pointers else _value_type(interface, field.type)
        if field.type.length:
            yield f"    [MarshalAs(UnmanagedType.ByValArray, SizeConst = {field.type.length})] public {type_}[] {_pascal(field.name)};"
        elif field.name == "reserved":
            yield f"    private readonly {type_} reserved;"
        else:
            # A member may not have the name of its type.
            own = _pascal(field.name)
            yield f"    public {type_} {'Value' if own == name else own};"
    yield "}"


def _parameter(interface, function, fact):
    if fact.role in ("context", "lent"):
        return "IntPtr" if fact.role == "context" else "out IntPtr"
    if fact.role == "handle":
        return HANDLES.get(fact.type.name, "IntPtr") if function.result.name != "void" else "IntPtr"
    if fact.role in ("made", "handles"):
        return "out IntPtr" if fact.role == "made" else "IntPtr[]"
    if fact.role == "callback":
        return _name(fact.type.name)
    if fact.role == "texts":
        return "[Out] IntPtr[]"
    if fact.role in ("text", "bytes"):
        return ("[Out] byte[]" if fact.is_output else "string") if fact.role == "text" else \
            "[Out] byte[]" if fact.is_output else "byte[]" if fact.is_array else "IntPtr"
    type_ = _value_type(interface, fact.type)
    if not fact.type.pointers:
        return type_
    if fact.is_array or fact.may_be_null:
        return f"[Out] {type_}[]" if fact.is_output else f"{type_}[]"
    struct = interface.struct(fact.type)
    # What the library reads of a struct before it writes it.
    is_read = struct and not function.name.endswith("_init") and \
        (struct.fields[0].name == "struct_size" or fact.name == "memory")
    return f"out {type_}" if fact.is_output and not is_read else f"ref {type_}"


def _function(interface, function, library):
    if function.result.pointers:
        result = "IntPtr"
    else:
        result = "void" if function.result.name == "void" else _value_type(interface, function.result)
    parameters = ", ".join(f"{_parameter(interface, function, fact)} {_camel(fact.name)}"
                           for fact in contract.arguments(interface, function))
    yield f'[DllImport("{library}")] internal static extern {result} {function.name}({parameters});'


def _delegate(interface, callback):
    def type_of(type_):
        return "IntPtr" if type_.pointers else "void" if type_.name == "void" else _value_type(interface, type_)

    parameters = ", ".join(f"{type_of(each.type)} {_camel(each.name)}" for each in callback.parameters)
    yield "[UnmanagedFunctionPointer(CallingConvention.Cdecl)]"
    yield f"internal delegate {type_of(callback.result)} {_name(callback.name)}({parameters});"


def _indented(lines, by):
    return [" " * by + line if line else line for line in lines]


def files(interface, notice):
    structs = {_name(struct.name): struct for header in interface.headers for struct in header.all(Struct)}
    types = []
    for header in interface.headers:
        for alias in (alias for alias in header.all(Alias) if alias.values):
            types += [*_enum(alias), ""]
    for struct in structs.values():
        types += [*_struct(interface, struct), ""]
    for callback in interface.callbacks:
        types += [*_delegate(interface, callback), ""]
    calls = []
    for header in interface.headers:
        library = "abut" if header is interface.headers[0] else f"abut_{header.name}"
        calls += [line for function in header.functions for line in _function(interface, function, library)]
    sizes = [f"{{ typeof({name}), {of_struct(interface, struct)[0]} }}," for name, struct in structs.items()]
    version = [f"internal const uint {part} = {interface.by_name[f'ABUT_VERSION_{part.upper()}'].value};" for part in ("Major", "Minor")]
    lines = ["// SPDX-License-Identifier: Apache-2.0", f"// {notice}", "#pragma warning disable 1591", "using System;",
             "using System.Collections.Generic;", "using System.Runtime.InteropServices;", "", "namespace Abut", "{",
             *_indented(types, 4), "    internal static partial class Native", "    {", *_indented(version, 8), "",
             *_indented(calls, 8), "", "        /// <summary>Sizes of the structs in C.</summary>",
             "        internal static readonly Dictionary<Type, int> Sizes = new Dictionary<Type, int>", "        {",
             *_indented(sizes, 12), "        };", "    }", "}", ""]
    return {PATH: "\n".join(lines)}
