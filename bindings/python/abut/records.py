# SPDX-License-Identifier: Apache-2.0
"""Answers of batches: structs in one piece of memory, as a sequence and as columns."""

from __future__ import annotations

import ctypes
import operator
import sys
from typing import Any, Iterator

from . import c

__all__ = ["Groups", "Records"]

# Structs that NumPy sees as plain rows of numbers.
ROWS = {c.Vec3: 3, c.Quat: 4, c.Pose: 7, c.Velocity: 6, c.Acceleration: 6, c.Movement: 15}
_SCALARS = {ctypes.c_double: "f8", ctypes.c_uint32: "u4", ctypes.c_uint64: "u8"}


def numpy() -> Any:
    """NumPy, which arrays need and nothing else does."""
    try:
        import numpy as found
    except ImportError:
        raise ImportError("arrays need NumPy, which is not installed: pip install numpy") from None
    return found


def is_numpy_loaded() -> bool:
    """Whether NumPy is in use: nothing here imports it before arrays are asked for."""
    return sys.modules.get("numpy") is not None


def dtype_of(kind: Any) -> Any:
    """What NumPy calls a struct of C: rows of numbers for vectors and poses, named fields for all else."""
    if kind in ROWS:
        return numpy().dtype(("f8", (ROWS[kind],)))
    if kind in _SCALARS:
        return numpy().dtype(_SCALARS[kind])
    if issubclass(kind, ctypes.Structure):
        names = [name for name, _ in kind._fields_]
        return numpy().dtype({"names": names, "formats": [dtype_of(field) for _, field in kind._fields_],
                              "offsets": [getattr(kind, name).offset for name in names],
                              "itemsize": ctypes.sizeof(kind)})
    if issubclass(kind, ctypes.Array):
        is_text = kind._type_ is ctypes.c_char
        return numpy().dtype(f"S{kind._length_}" if is_text else (dtype_of(kind._type_), kind._length_))
    return numpy().dtype("u8")  # a pointer


class Records:
    """Structs of one kind: `records[i]` is one of them, `records.normal` is the column of a field as a NumPy array.

    Arrays look at the memory of the records and copy nothing. Indexing, iteration and len() work without NumPy.
    """

    __slots__ = ("_memory", "__weakref__")

    def __init__(self, memory: ctypes.Array) -> None:
        self._memory = memory

    @classmethod
    def of_array(cls, kind: Any, array: Any) -> Records:
        """A copy of an array as dtype_of(kind) describes it."""
        return _restored(kind, numpy().ascontiguousarray(array, dtype_of(kind).base).tobytes())

    @property
    def kind(self) -> Any:
        """The struct that each of them is."""
        return self._memory._type_

    @property
    def memory(self) -> ctypes.Array:
        """The array of ctypes that holds them."""
        return self._memory

    @property
    def array(self) -> Any:
        """All of them: (N, 7) numbers of poses, (N, 3) of vectors, else N records with named fields."""
        memory = self.memory
        return numpy().frombuffer(memory, dtype_of(self.kind)) if len(memory) else numpy().empty(0, dtype_of(self.kind))

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        array = self.array
        return array.copy() if copy and dtype is None else array if dtype is None else array.astype(dtype)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        kind = self.kind
        fields = dict(kind._fields_)
        if name not in fields:
            raise AttributeError(f"records of {kind.__name__} have no field {name!r}; they have {', '.join(fields)}")
        memory = self.memory
        dtype = dtype_of(fields[name])
        if not len(memory):
            return numpy().empty((0, *dtype.shape), dtype.base)
        return numpy().ndarray((len(memory), *dtype.shape), dtype.base, memory, getattr(kind, name).offset,
                               (ctypes.sizeof(kind), *_packed_strides(dtype)))

    def __len__(self) -> int:
        return len(self.memory)

    def __iter__(self) -> Iterator[Any]:
        return (self[index] for index in range(len(self)))

    def __getitem__(self, index: Any) -> Any:
        """One record by its number; a part of them by a slice, a mask or an array of numbers."""
        if isinstance(index, slice):
            memory = self.memory
            wanted = range(*index.indices(len(memory)))
            if wanted.step == 1:
                return Records(part_of(memory, wanted.start, len(wanted)))
            return Records((self.kind * len(wanted))(*(memory[i] for i in wanted)))
        if hasattr(index, "__len__"):
            return Records.of_array(self.kind, self.array[index])
        return self._one(operator.index(index))

    def _one(self, index):
        return self.memory[index]

    def copy(self) -> Records:
        """The same in memory of their own."""
        return Records(type(self.memory).from_buffer_copy(self.memory))

    def __reduce__(self) -> Any:
        return _restored, (self.kind, bytes(self.memory))

    def __repr__(self) -> str:
        shown = [repr(self[i]) for i in range(min(3, len(self)))] + ["..."] * (len(self) > 3)
        return f"<{len(self)} {self.kind.__name__}: [{', '.join(shown)}]>"


def _restored(kind, data):
    """Records from their bytes, as pickle keeps them."""
    return Records((kind * (len(data) // ctypes.sizeof(kind))).from_buffer_copy(data))


def empty(kind: Any, count: int) -> ctypes.Array:
    """Memory for an answer. Where NumPy is in use it is not zeroed, since C writes all of it."""
    if is_numpy_loaded() and count:
        return (kind * count).from_buffer(numpy().empty(count * ctypes.sizeof(kind), "u1"))
    return (kind * count)()


def part_of(memory: ctypes.Array, first: int, count: int) -> ctypes.Array:
    """A piece of an array, in place."""
    kind = memory._type_
    if count <= 0:
        return (kind * 0)()
    return (kind * count).from_buffer(memory, first * ctypes.sizeof(kind))


def _packed_strides(dtype):
    strides, size = [], dtype.base.itemsize
    for length in reversed(dtype.shape):
        strides.insert(0, size)
        size *= length
    return strides


class Groups:
    """Records in groups, one for each query of a batch: `groups[i]` are the records of query i."""

    __slots__ = ("offsets", "records")

    def __init__(self, offsets: ctypes.Array, records: Records) -> None:
        self.offsets = offsets
        self.records = records

    @property
    def counts(self) -> Any:
        """How many records each query has, as a NumPy array."""
        return numpy().diff(numpy().frombuffer(self.offsets, "u8")).astype("i8")

    def __len__(self) -> int:
        return len(self.offsets) - 1

    def __getitem__(self, index: int) -> Records:
        wanted = range(len(self))[index]
        return self.records[self.offsets[wanted]:self.offsets[wanted + 1]]

    def __iter__(self) -> Iterator[Records]:
        return (self[index] for index in range(len(self)))

    def __reduce__(self) -> Any:
        return _regrouped, (bytes(self.offsets), self.records)

    def __repr__(self) -> str:
        return f"<{len(self)} groups of {self.records.kind.__name__}, {len(self.records)} in all>"


def _regrouped(offsets, records):
    return Groups(_restored(ctypes.c_uint64, offsets).memory, records)
