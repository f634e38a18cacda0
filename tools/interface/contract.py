# SPDX-License-Identifier: Apache-2.0
"""What a call may be given: facts about parameters and fields that follow from types, names and comments.

The comments of the headers say these in words that people read as well:
 - `name` may be null, also in the comment of a struct. Pointers that do not say so must not be.
 - @param name  count * 3 numbers. The length of an array comes first.
 - positive, above 0, not negative, at least 1, below 64, from 2 to 64, name > 0, name >= 0. The range of a number.
 - may be infinite; or NaN. Other numbers are finite.
 - of any length. Other vectors have coordinates of at most 1e70.
 - zero. A reserved field. Not read where ...: one that the good arguments leave out.
 - The same for ..., abut_f with ..., parameters as those of abut_f. What is not said is as there.
"""

import math
import re
from dataclasses import dataclass, field

from header import Alias, Function, Opaque, Struct


@dataclass
class Range:
    least: float = -math.inf
    most: float = math.inf
    is_open: bool = False  # without `least`
    may_be_infinite: bool = False
    may_be_nan: bool = False
    may_be_far: bool = False
    is_reserved: bool = False
    is_unread: bool = False


@dataclass
class Fact:
    """A parameter, or a field of a struct."""

    name: str
    type: object
    # number, choice (of an enumeration), bits, id, structure, handle, handles, text, texts (that are answered), bytes,
    # callback, context, made (a handle that is answered) or lent (a pointer that is answered)
    role: str
    is_array: bool = False
    length: str = ""  # of an array, in names of others
    is_output: bool = False
    may_be_null: bool = False
    range: Range = field(default_factory=Range)


NUMBER = r"(-?\d[\d.]*(?:e[+-]?\d+)?)"
LENGTH = r"`?(\w+)`?((?: [*+] \w+)*) (?:numbers|indices|bytes|answers|shapes|poses|parts|geometries)\b"


def same_as(interface, function):
    """The function that a comment refers to for what it does not say itself; None for most."""
    said = " ".join(function.doc.split())
    named = re.search(r"(?:parameters as those of|answered as by) (abut_\w+)|^(abut_\w+) with ", said, re.IGNORECASE)
    if named:
        return interface.find(named[1] or named[2], Function)
    if not re.match(r"The same\b", function.doc):
        return None
    header = next(header for header in interface.headers if function in header.items)
    return header.functions[header.functions.index(function) - 1]


def _paragraphs(doc):
    """What is said of each parameter, and the rest."""
    first, *others = re.split(r"^@param ", doc, flags=re.MULTILINE)
    first = " ".join(first.split())
    told = {}
    for other in others:
        name, _, text = other.partition(" ")
        # Lines that go on are indented.
        lines = text.split("\n")
        mine = [lines[0], *[line for line in lines[1:] if line.startswith("  ")]]
        told[name] = " ".join(line.strip() for line in mine)
    return first, told


def said_of(interface, function, name):
    """What comments say of a parameter: the nearest that speaks of it."""
    first, told = _paragraphs(function.doc)
    if name in told:
        return told[name]
    words = re.findall(rf"`{name}` [^.;]*|\b{name} >=? 0", first)
    if words:
        return "; ".join(words)
    other = same_as(interface, function)
    return said_of(interface, other, name) if other else ""


def range_of(text):
    range_ = Range(may_be_infinite="infinite" in text, may_be_nan="or NaN" in text,
                   may_be_far="of any length" in text or "infinite" in text, is_reserved=text == "zero",
                   is_unread="Not read where" in text)
    if match := re.search(rf"in \[{NUMBER}, {NUMBER}\]|(?:from )?{NUMBER} to {NUMBER}", text):
        range_.least, range_.most = (float(match[side] or match[side + 2]) for side in (1, 2))
    elif re.search(r"\bpositive\b|above 0|\w > 0", text):
        range_.least, range_.is_open = 0, True
    elif re.search(r"not negative|at least 0|>= 0", text):
        range_.least = 0
    elif match := re.search(rf"at least {NUMBER}", text):
        range_.least = float(match[1])
    if match := re.search(r"\bbelow (\d+)", text):
        range_.most = float(match[1]) - 1
    return range_


def _role(interface, type_):
    item = interface.by_name.get(type_.name)
    if isinstance(item, Function):
        return "callback"
    if isinstance(item, Opaque):
        return "handle" if type_.pointers == 1 else "handles" if type_.is_const else "made"
    if type_.name == "void":
        return "bytes"
    if type_.name == "char":
        return "texts" if type_.pointers == 2 else "text"
    if type_.pointers == 2:
        return "lent"
    if isinstance(item, Struct):
        return "id" if item.name.endswith("_id") else "structure"
    if isinstance(item, Alias) and item.values:
        return "choice" if any(value.value == 0 for value in item.values) else "bits"
    return "number"


def _counts(function):
    return [each.name for each in function.parameters if str(each.type) == "size_t" and re.search(r"count$|^size$", each.name)]


def _is_plural(parameter, type_):
    """Whether a name is that of several. Options and a focus are one thing."""
    name = re.sub(r"_[ab]$", "", parameter)
    return name.endswith("s") and not type_.name.endswith(f"_{name}")


def _length(function, fact, index, text):
    """The length of an array; None for a single value."""
    names = [each.name for each in function.parameters]
    if match := re.match(LENGTH, text):
        if set(re.findall(r"[a-z]\w*", match[1] + match[2])) <= set(names):
            return match[1] + match[2]
    following = names[index + 1] if index + 1 < len(names) else ""
    if fact.is_output and following.endswith("capacity"):
        return following
    counts = _counts(function)
    if "array of `count`" in text:
        return "count"
    counts = ["count"] if "count" in counts else counts
    if fact.role in ("lent", "made", "handle", "callback") or len(counts) != 1:
        return None
    if fact.is_output:
        return counts[0] if counts[0] == "count" or _is_plural(fact.name, fact.type) else None
    is_list = fact.role in ("handles", "id", "number", "choice", "bits") or _is_plural(fact.name, fact.type)
    return counts[0] if is_list or fact.role == "bytes" else None


def arguments(interface, function):
    """Facts about the parameters of a function."""
    facts = []
    for index, parameter in enumerate(function.parameters):
        text = said_of(interface, function, parameter.name)
        role = "context" if parameter.name == "context" else _role(interface, parameter.type)
        fact = Fact(parameter.name, parameter.type, role, range=range_of(text))
        is_pointer = parameter.type.pointers > 0
        is_answer = is_pointer and not parameter.type.is_const and role not in ("handle", "context")
        fact.is_output = is_answer or role in ("lent", "texts")
        struct = interface.struct(parameter.type)
        said = text + struct.doc if struct and parameter.type.is_const else text
        fact.may_be_null = role == "context" or bool(re.search(r"may be null|, or null", said))
        if role == "callback":
            fact.may_be_null = is_optional(interface, function)
        if is_pointer:
            length = _length(function, fact, index, text)
            fact.is_array, fact.length = length is not None, length or ""
        facts.append(fact)
    return facts


def fields(interface, struct):
    """Facts about the fields of a struct."""
    facts = []
    for each in struct.fields:
        text = " ".join(each.doc.split())
        fact = Fact(each.name, each.type, _role(interface, each.type), range=range_of(text))
        match = re.match(LENGTH, text)
        fact.is_array = bool(each.type.pointers or each.type.length)
        fact.length = match[1] + match[2] if match and each.type.pointers else ""
        fact.may_be_null = bool(re.search(r"\bnull\b", text, re.IGNORECASE)) and (each.type.pointers > 0 or fact.role == "id")
        facts.append(fact)
    return facts


def may_be_called_back(interface, function):
    """Whether a filter may make an [exclusive] call."""
    other = same_as(interface, function)
    return "that a filter may make" in " ".join(function.doc.split()) or bool(other and may_be_called_back(interface, other))


def is_optional(interface, function):
    """Whether the functions of the caller that it takes may be null."""
    other = same_as(interface, function)
    return "null for " in function.doc or bool(other and is_optional(interface, other))
