# SPDX-License-Identifier: Apache-2.0
"""Structs of C from annotated fields, which editors and type checkers read as well."""

from __future__ import annotations

import re
from ctypes import POINTER, Structure, c_char_p, c_double, c_uint32, c_uint64, c_void_p
from typing import Annotated, Any, Iterator, TypeVar, get_type_hints

T = TypeVar("T", bound=Structure)

Double = Annotated[float, c_double]
UInt32 = Annotated[int, c_uint32]
UInt64 = Annotated[int, c_uint64]
Text = Annotated[bytes, c_char_p]
Address = Annotated[Any, c_void_p]
Doubles = Annotated[Any, POINTER(c_double)]
UInt32s = Annotated[Any, POINTER(c_uint32)]


def struct(cls: type[T]) -> type[T]:
    """Lays out the annotated fields of a class in their order, as C does."""
    hints = get_type_hints(cls, include_extras=True)
    name_of_c = re.sub(r"(?<!^)(?=[A-Z])", "_", cls.__name__).lower()
    cls.__doc__ = f"The struct abut_{name_of_c} of the headers, with the fields {', '.join(cls.__annotations__)}."
    cls._fields_ = [(name, getattr(hints[name], "__metadata__", [hints[name]])[0]) for name in cls.__annotations__]
    return cls


class Struct(Structure):
    """A struct of C that prints its fields."""

    def __repr__(self) -> str:
        fields = ", ".join(f"{name}={getattr(self, name)!r}" for name, _ in self._fields_)
        return f"{type(self).__name__}({fields})"


class Numbers(Struct):
    """A struct of numbers that unpacks: x, y, z = contact.normal."""

    def __iter__(self) -> Iterator[float]:
        return (getattr(self, name) for name, _ in self._fields_)


class Id(Struct):
    """An id is a value: equal ids are equal keys, and a null id is false."""

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Id) or type(other) is not type(self):
            return False
        return (self.slot, self.generation) == (other.slot, other.generation)

    def __hash__(self) -> int:
        return hash((self.slot, self.generation))

    def __bool__(self) -> bool:
        return self.slot != 0
