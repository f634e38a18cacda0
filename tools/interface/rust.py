# SPDX-License-Identifier: Apache-2.0
"""The raw layer of Rust: what abut.h and picking.h declare, as extern "C" and repr(C)."""

from header import Alias, Function, Macro, Opaque, Struct
from layout import of_struct

PATHS = {"abut": "bindings/rust/src/raw.rs", "picking": "bindings/rust/src/raw_picking.rs"}
SCALARS = {"double": "f64", "uint64_t": "u64", "size_t": "usize", "uint32_t": "u32", "int32_t": "i32",
           "char": "::std::os::raw::c_char", "void": "::std::os::raw::c_void"}
WORDS = {"type"}  # names of C that are words of Rust

ZEROED = """impl Default for {0} {{
    fn default() -> Self {{
        unsafe {{ ::std::mem::zeroed() }}
    }}
}}"""


def _name(name):
    return f"{name}_" if name in WORDS else name


def _type(type_):
    name = SCALARS.get(type_.name, type_.name)
    for depth in range(type_.pointers):
        # Pointers of an array of pointers are only read where it is const itself.
        is_const = type_.is_const and (depth == 0 or "*const" in str(type_))
        name = f"*{'const' if is_const else 'mut'} {name}"
    return f"[{name}; {type_.length}]" if type_.length else name


def _has_default(interface, struct):
    """Pointers and long arrays have none of their own."""
    return all(not field.type.pointers and field.type.length <= 32 and
               (not interface.struct(field.type) or _has_default(interface, interface.struct(field.type)))
               for field in struct.fields)


def _signature(function):
    parameters = ", ".join(f"{_name(each.name)}: {_type(each.type)}" for each in function.parameters)
    is_void = function.result.name == "void" and not function.result.pointers
    return f"({parameters})" + ("" if is_void else f" -> {_type(function.result)}")


def _declared(interface, item):
    if isinstance(item, Macro):
        yield f"pub const {item.name}: {'u32' if item.value < 2**32 else 'u64'} = {item.value};"
    elif isinstance(item, Alias):
        yield f"pub type {item.name} = {_type(item.type)};"
        yield from (f"pub const {value.name}: {item.name} = {value.value};" for value in item.values)
    elif isinstance(item, Opaque):
        yield f"#[repr(C)]\n#[derive(Debug, Copy, Clone)]\npub struct {item.name} {{\n    _unused: [u8; 0],\n}}"
    elif isinstance(item, Struct):
        derived = "Debug, Default, Copy, Clone" if _has_default(interface, item) else "Debug, Copy, Clone"
        fields = "".join(f"    pub {_name(field.name)}: {_type(field.type)},\n" for field in item.fields)
        yield f"#[repr(C)]\n#[derive({derived})]\npub struct {item.name} {{\n{fields}}}"
        if not _has_default(interface, item):
            yield ZEROED.format(item.name)
        yield f"const _: [(); {of_struct(interface, item)[0]}] = [(); ::std::mem::size_of::<{item.name}>()];"
    elif isinstance(item, Function) and item.is_callback:
        yield f"pub type {item.name} = ::std::option::Option<unsafe extern \"C\" fn{_signature(item)}>;"


def files(interface, notice):
    made = {}
    for header in interface.headers:
        if header.name not in PATHS:
            continue
        lines = ["// SPDX-License-Identifier: Apache-2.0", f"// {notice}", ""]
        if header is not interface.headers[0]:
            lines += ["use crate::raw::*;", ""]
        lines += [line for item in header.items for line in _declared(interface, item)]
        lines += ['extern "C" {', *(f"    pub fn {each.name}{_signature(each)};" for each in header.functions), "}", ""]
        made[PATHS[header.name]] = "\n".join(lines)
    return made
