# SPDX-License-Identifier: Apache-2.0
"""Reads the C headers with clang: what they declare, in their order, with the comments.

All that is generated from the headers goes through this description.
"""

import json
import re
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

# Each header is the interface of one library. The first one is included by the others.
HEADERS = ("abut", "picking", "response")

COMPILER = "clang-19"
SCALARS = {"double": 8, "uint64_t": 8, "size_t": 8, "uint32_t": 4, "int32_t": 4, "char": 1}


@dataclass(frozen=True)
class Type:
    """A type as it is written: a name, const or not, how many pointers, and the length of an array."""

    name: str
    is_const: bool = False
    pointers: int = 0
    length: int = 0
    spelling: str = ""

    def __str__(self):
        return self.spelling


@dataclass
class Variable:
    """A field of a struct or a parameter of a function."""

    name: str
    type: Type
    doc: str = ""


@dataclass
class Alias:
    """A number with a name of its own, such as a status or flags. `values` are the enumerators beside it."""

    name: str
    type: Type
    doc: str = ""
    values: list = field(default_factory=list)


@dataclass
class Struct:
    name: str
    fields: list
    doc: str = ""


@dataclass
class Opaque:
    name: str
    doc: str = ""


@dataclass
class Function:
    """A function, or the type of one that the caller gives."""

    name: str
    result: Type
    parameters: list
    doc: str = ""
    is_callback: bool = False

    @property
    def can_fail(self):
        return self.result.name == "abut_status"

    @property
    def threads(self):
        """The thread rule, the last of those in the comment: any, const or exclusive."""
        rules = re.findall(r"\[(any|const|exclusive)\]", self.doc)
        return rules[-1] if rules else ""


@dataclass
class Macro:
    name: str
    value: int


class Header:
    """What one header declares."""

    def __init__(self, name, items):
        self.name = name
        self.items = items

    def all(self, kind):
        return [item for item in self.items if isinstance(item, kind)]

    @property
    def functions(self):
        return [item for item in self.all(Function) if not item.is_callback]

    @property
    def callbacks(self):
        return [item for item in self.all(Function) if item.is_callback]


class Interface:
    """All headers, their declarations by name, and the folder of the project."""

    def __init__(self, headers, root):
        self.headers = headers
        self.root = root
        self.by_name = {item.name: item for header in headers for item in header.items}

    @property
    def callbacks(self):
        return [callback for header in self.headers for callback in header.callbacks]

    def find(self, name, kind):
        found = self.by_name.get(name)
        return found if isinstance(found, kind) else None

    def struct(self, type_):
        return self.find(type_.name, Struct)

    def number_of(self, name):
        """The scalar that a name stands for: that of the typedef, or the name itself. None for what is no number."""
        alias = self.find(name, Alias)
        return alias.type.name if alias else name if name in SCALARS else None


def parsed_type(text):
    text = re.sub(r"\bstruct ", "", text)
    array = re.search(r"\[(\d+)\]$", text)
    spelling = (text[:array.start()] if array else text).strip()
    words = re.findall(r"\w+", spelling)
    is_const = words[0] == "const"
    return Type(words[is_const], is_const, text.count("*"), int(array[1]) if array else 0, spelling)


def tidy(comment):
    """A comment as plain lines."""
    lines = [re.sub(r"^\s*\* ?", "", line).rstrip() for line in comment.lstrip("*<").split("\n")]
    return "\n".join(lines).strip()


class _Reader:
    """Makes our description of the syntax tree of one header."""

    def __init__(self, text):
        self.bytes = text.encode()

    def source(self, node):
        begin, end = (self._place(node["range"][side]) for side in ("begin", "end"))
        return self.bytes[begin["offset"]:end["offset"] + end["tokLen"]].decode()

    @staticmethod
    def _place(location):
        return location.get("expansionLoc", location)

    def doc(self, node):
        comment = next((inner for inner in node.get("inner", []) if inner["kind"] == "FullComment"), None)
        if comment is None:
            return ""
        begin = comment["range"]["begin"]["offset"]
        return tidy(self.bytes[begin:self.bytes.index(b"*/", begin)].decode())

    def variables(self, node, kind):
        return [Variable(inner["name"], parsed_type(inner["type"]["qualType"]), self.doc(inner))
                for inner in node.get("inner", []) if inner["kind"] == kind]

    def function(self, node):
        result = parsed_type(node["type"]["qualType"].partition("(")[0])
        return Function(node["name"], result, self.variables(node, "ParmVarDecl"), self.doc(node))

    def callback(self, node):
        # The tree has no names for the parameters of a type.
        result, _, rest = re.sub(r"\s+", " ", self.source(node)).removeprefix("typedef ").partition("(*")
        parameters = []
        for parameter in rest.partition(")(")[2].rstrip(")").split(", "):
            type_, name = re.fullmatch(r"(.*?)(\w+)", parameter).groups()
            parameters.append(Variable(name, parsed_type(type_)))
        return Function(node["name"], parsed_type(result), parameters, self.doc(node), is_callback=True)

    def enumerators(self, node):
        values, next_value = [], 0
        for inner in (inner for inner in node["inner"] if inner["kind"] == "EnumConstantDecl"):
            constants = [int(each["value"]) for each in inner.get("inner", []) if "value" in each]
            value = constants[0] if constants else next_value
            values.append(Macro(inner["name"], value))
            next_value = value + 1
        return values

    def items(self, nodes):
        found, records = [], {}
        for node in nodes:
            name, kind = node["name"], node["kind"]
            if kind == "FunctionDecl":
                found.append(self.function(node))
            elif kind == "RecordDecl":
                records[name] = node
            elif kind == "EnumDecl":
                alias = next(item for item in found if item.name + "_value" == name)
                alias.values = self.enumerators(node)
            elif kind == "TypedefDecl":
                spelled = node["type"]["qualType"]
                if "(*)" in spelled:
                    found.append(self.callback(node))
                elif name not in records:
                    found.append(Alias(name, parsed_type(spelled), self.doc(node)))
                elif records[name].get("completeDefinition"):
                    fields = self.variables(records[name], "FieldDecl")
                    found.append(Struct(name, fields, self.doc(node) or self.doc(records[name])))
                else:
                    found.append(Opaque(name, self.doc(node) or self.doc(records[name])))
        return found


def _tree(path):
    command = [COMPILER, "-x", "c", "-std=c11", "-fsyntax-only", "-Xclang", "-ast-dump=json", str(path)]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


# Numbers only; other macros are no part of what languages see.
def _macros(text):
    found = re.findall(r"^#define (ABUT_\w+) (0x[0-9A-F]+|\d+)u?$", text, re.MULTILINE)
    return [Macro(name, int(value, 0)) for name, value in found]


def read(root):
    headers = []
    for name in HEADERS:
        path = Path(root, "include/abut", f"{name}.h")
        text = path.read_text(encoding="utf-8")
        own = [node for node in _tree(path)["inner"]
               if node.get("name", "").startswith("abut_") and "includedFrom" not in str(node["loc"])]
        headers.append(Header(name, _macros(text) + _Reader(text).items(own)))
    return Interface(headers, root)
