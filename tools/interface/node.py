# SPDX-License-Identifier: Apache-2.0
"""The raw layer of Node: structs and prototypes, as koffi takes them."""

import textwrap

import contract
from header import Alias, Opaque, Struct

PATH = "bindings/node/raw.mjs"
# What the package calls otherwise.
NAMES = {"abut_vec3": "vector", "abut_quat": "quaternion", "abut_query_hit": "hit"}


def _camel(name):
    first, *rest = name.removeprefix("abut_").split("_")
    return first + "".join(word.capitalize() for word in rest)


def _name(name):
    return NAMES.get(name, _camel(name))


def _base(interface, type_):
    alias = interface.find(type_.name, Alias)
    return alias.type.name if alias else type_.name


def _field(interface, field):
    type_ = field.type
    if type_.length:
        text = f"koffi.array('{_base(interface, type_)}', {type_.length})"
    elif type_.pointers:
        is_text = type_.name == "char"
        text = "'str'" if is_text else "'void *'" if interface.find(type_.name, Opaque) else f"'{_base(interface, type_)} *'"
    else:
        text = _name(type_.name) if interface.struct(type_) else f"'{_base(interface, type_)}'"
    return f"{_camel(field.name)}: {text}"


def _struct(interface, struct):
    # Lines end between fields.
    fields = ", ".join(_field(interface, field).replace(" ", "\0") for field in struct.fields)
    text = f"const {_name(struct.name)} = koffi.struct('{struct.name}', {{ {fields} }});"
    return textwrap.fill(text, 120, subsequent_indent="  ", break_on_hyphens=False).replace("\0", " ")


def _parameter(interface, function, fact):
    base, const = _base(interface, fact.type), "const " if fact.type.is_const else ""
    if fact.role == "context":
        return "void *"
    if fact.role == "handle":
        return f"{base} *"
    if fact.role in ("made", "handles"):
        return f"{'_Out_ ' if fact.role == 'made' else ''}{base} **"
    if fact.role == "lent":
        return "_Out_ void **"
    if fact.role == "callback":
        return f"{base} *"
    if not fact.type.pointers:
        return f"{base} "
    # Arrays that are filled are memory of the caller.
    if fact.is_array and fact.is_output or fact.role == "bytes":
        return f"{const}void *"
    struct = interface.struct(fact.type)
    if not fact.is_output:
        return f"{const}{base} *"
    if struct and not function.name.endswith("_init"):
        return f"_Inout_ {base} *" if struct.fields[0].name == "struct_size" or fact.name == "memory" else f"_Out_ {base} *"
    return f"_Out_ {base} *"


def _result(interface, type_):
    spelled = str(type_) if type_.pointers else _base(interface, type_)
    return spelled if spelled.endswith("*") else spelled + " "


def _prototype(interface, function):
    parameters = ", ".join(_parameter(interface, function, fact) + fact.name
                           for fact in contract.arguments(interface, function))
    return f"{_result(interface, function.result)}{function.name}({parameters})"


def _callback(interface, callback):
    parameters = ", ".join(("void *" if each.type.pointers else f"{_base(interface, each.type)} ") + each.name
                           for each in callback.parameters)
    return f"{_result(interface, callback.result)}{callback.name}({parameters})"


def files(interface, notice):
    structs = [struct for header in interface.headers for struct in header.all(Struct)]
    lines = ["// SPDX-License-Identifier: Apache-2.0", f"// {notice}", "import koffi from 'koffi';", ""]
    lines += [_struct(interface, struct) for struct in structs]
    lines += [f"koffi.opaque('{opaque.name}');" for header in interface.headers for opaque in header.all(Opaque)]
    names = ", ".join(_name(struct.name) for struct in structs)
    lines += ["", textwrap.fill(f"export const structs = {{ {names} }};", 120, subsequent_indent="  "), "",
              "export const callbacks = {",
              *(f"  {_name(each.name)}: koffi.pointer(koffi.proto('{_callback(interface, each)}'))," for each in interface.callbacks),
              "};", "", "export const prototypes = {"]
    for header in interface.headers:
        lines += [f"  {header.name}: [", *(f"    '{_prototype(interface, each)}'," for each in header.functions), "  ],"]
    major, minor = (interface.by_name[f"ABUT_VERSION_{part}"].value for part in ("MAJOR", "MINOR"))
    lines += ["};", "", f"export const version = {{ major: {major}, minor: {minor} }};", ""]
    return {PATH: "\n".join(lines)}
