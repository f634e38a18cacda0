# SPDX-License-Identifier: Apache-2.0
"""What callers give, as memory of C: checked, converted at most once, and used where it lies when it fits."""

from __future__ import annotations

import ctypes
from ctypes import c_double, c_uint32, c_uint64
from typing import Any

from . import c, rotations
from .records import ROWS, Records, dtype_of, numpy

_LIMITS = {c_uint32: 2**32 - 1, c_uint64: 2**64 - 1}
_ALSO = {c.Pose: rotations.pose_rows, c.Quat: rotations.quaternions}  # what else is one than its numbers
# What makes one, for messages.
_MAKERS = {c.Pose: "; abut.pose(x, y, z) makes one", c.Ray: "; abut.ray(origin, direction) makes one"}
_LETTERS = {c_double: "d", c_uint32: "I", c_uint64: "QL"}


class Given:
    """One argument: structs or numbers in memory of C, and whether the caller gave a single one for all."""

    __slots__ = ("is_one", "memory", "name")

    def __init__(self, name: str, memory: ctypes.Array, is_one: bool = False) -> None:
        self.name = name
        self.memory = memory
        self.is_one = is_one

    def __len__(self) -> int:
        return len(self.memory)


def together(*arguments: Given) -> int:
    """How many elements arguments have that belong together; a single one is repeated as often as the others need."""
    many = [argument for argument in arguments if not argument.is_one]
    if len({len(argument) for argument in many}) > 1:
        lengths = " and ".join(f"{argument.name} has {len(argument)}" for argument in many)
        raise ValueError(f"{lengths}; they must have as many elements")
    count = len(many[0]) if many else 1
    for argument in arguments:
        if argument.is_one and count != 1:
            kind = argument.memory._type_
            argument.memory = (kind * count).from_buffer_copy(bytes(argument.memory) * count)
    return count


def is_array(values: Any) -> bool:
    """Whether NumPy reads this directly: its own arrays, and those of others that speak its protocols."""
    return hasattr(values, "__array_interface__") or hasattr(values, "__array__")


def borrowed(array: Any, kind: Any) -> ctypes.Array:
    """A packed array as an array of ctypes, in place; it keeps the array alive."""
    memory = (kind * (array.nbytes // ctypes.sizeof(kind))).from_address(array.ctypes.data)
    memory.keeps = array
    return memory


def converted(name: str, values: Any, kind: Any) -> Any:
    """An array of numbers as packed numbers of one kind."""
    np = numpy()
    array = np.asarray(values)
    if kind is c_double:
        if array.dtype.kind not in "fiu":
            raise TypeError(f"{name} holds {array.dtype}; it must hold numbers")
        return np.ascontiguousarray(array, "f8")
    if array.dtype.kind not in "iu":
        raise TypeError(f"{name} holds {array.dtype}; it must hold whole numbers")
    if array.size and not 0 <= int(array.min()) <= int(array.max()) <= _LIMITS[kind]:
        wrong = int(array.min()) if array.min() < 0 else int(array.max())
        raise ValueError(f"{name} has the number {wrong}; it must be in [0, {_LIMITS[kind]}]")
    return np.ascontiguousarray(array, dtype_of(kind))


def numbers(name: str, values: Any, kind: Any = c_double) -> ctypes.Array:
    """Numbers of one kind, in one dimension."""
    if is_array(values):
        array = converted(name, values, kind)
        if array.ndim != 1:
            raise ValueError(f"{name} has shape {array.shape}; it must be (N,)")
        return borrowed(array, kind)
    lying = _buffer(kind, values)
    return lying if lying is not None else _packed(name, list(values), kind)


def rows(name: str, values: Any, width: int, kind: Any = c_double) -> tuple[ctypes.Array, int]:
    """Rows of numbers, such as points, flat or row by row, and how many rows there are."""
    if is_array(values):
        array = converted(name, values, kind)
        is_flat = array.ndim == 1 and array.size % width == 0
        if not is_flat and (array.ndim != 2 or array.shape[1] != width):
            raise ValueError(f"{name} has shape {array.shape}; it must be (N, {width})")
        return borrowed(array, kind), array.size // width
    flat = _buffer(kind, values)
    if flat is None:
        flat = _packed(name, _flattened(name, values, width), kind)
    if len(flat) % width:
        raise ValueError(f"{name} has {len(flat)} numbers; it must be a multiple of {width}")
    return flat, len(flat) // width


def _flattened(name, values, width):
    flat = []
    for value in values:
        if not hasattr(value, "__iter__"):
            flat.append(value)
            continue
        row = tuple(value)
        if len(row) != width:
            raise ValueError(f"{name} has a row of {len(row)} numbers; each must have {width}")
        flat.extend(row)
    return flat


def _buffer(kind, values):
    """A writable buffer of the right kind, such as array.array, where it lies."""
    try:
        view = memoryview(values)
    except TypeError:
        return None
    if view.ndim != 1 or not view.contiguous or view.readonly or view.format.lstrip("<@=") not in tuple(_LETTERS[kind]):
        return None
    if view.itemsize != ctypes.sizeof(kind):
        return None
    return (kind * len(view)).from_buffer(view.cast("B")) if len(view) else (kind * 0)()


def _packed(name, flat, kind):
    if kind is not c_double:
        for value in flat:
            if not 0 <= value <= _LIMITS[kind]:
                raise ValueError(f"{name} has the number {value}; it must be in [0, {_LIMITS[kind]}]")
    try:
        return (kind * len(flat))(*flat)
    except TypeError as failure:
        raise TypeError(f"{name}: {failure}") from None


def structs(kind: Any, name: str, values: Any) -> Given:
    """Structs of one kind: one, several, records of them, or rows of numbers where they are made of numbers only."""
    if isinstance(values, kind):
        return Given(name, (kind * 1)(values), True)
    if isinstance(values, Records) and values.kind is kind:
        return Given(name, values.memory)
    if isinstance(values, ctypes.Array) and values._type_ is kind:
        return Given(name, values)
    if kind in _ALSO:
        values = _ALSO[kind](name, values)
    if is_array(values):
        return _structs_of_array(kind, name, values)
    items = list(values)
    width = ROWS.get(kind)
    if width and items and not any(isinstance(item, kind) or hasattr(item, "__iter__") for item in items):
        return Given(name, (kind * 1)(_row(kind, name, items)), True)
    return Given(name, (kind * len(items))(*(_row(kind, name, item) for item in items)))


def _structs_of_array(kind, name, values):
    width = ROWS.get(kind)
    if width is None:
        array = numpy().asarray(values)
        if array.dtype != dtype_of(kind) or array.ndim > 1:
            raise TypeError(f"{name} holds {array.dtype} of shape {array.shape}; it must hold one {kind.__name__} each")
        return Given(name, borrowed(numpy().ascontiguousarray(array), kind), array.ndim == 0)
    array = converted(name, values, c_double)
    if array.shape != (width,) and (array.ndim != 2 or array.shape[1] != width):
        raise ValueError(f"{name} has shape {array.shape}; it must be (N, {width}), or ({width},) for one of them")
    return Given(name, borrowed(array, kind), array.ndim == 1)


def _row(kind, name, item):
    """One struct, from itself or from its numbers."""
    if isinstance(item, kind):
        return item
    if kind in _ALSO:
        item = _ALSO[kind](name, item)
    width = ROWS.get(kind)
    if width is None or not hasattr(item, "__iter__"):
        raise TypeError(f"{name} is of type {type(item).__name__}; it must be a {kind.__name__}{_MAKERS.get(kind, '')}")
    found = item.tolist() if hasattr(item, "tolist") else tuple(item)
    if len(found) != width:
        raise ValueError(f"{name} has {len(found)} numbers; it must have {width}{_MAKERS.get(kind, '')}")
    return kind.from_buffer(_packed(name, found, c_double))


def one(kind: Any, name: str, value: Any) -> Any:
    """A single struct, from itself or from its numbers."""
    return value if isinstance(value, kind) else _row(kind, name, value)


def pose(name: str, value: Any) -> c.Pose:
    """A single pose: a Pose, x, y, z and then w, x, y, z of its quaternion, or a homogeneous 4 x 4 matrix."""
    return one(c.Pose, name, value)


def vec3(name: str, value: Any) -> c.Vec3:
    return one(c.Vec3, name, value)


def reals(**named: Any) -> list[float]:
    """Real numbers, which are refused by their names when they are none."""
    for name, value in named.items():
        if not hasattr(value, "__float__") and not hasattr(value, "__index__"):
            raise TypeError(f"{name} is {value!r}; it must be a number")
    return [float(value) for value in named.values()]


def text(name: str, value: Any) -> bytes:
    """A name as C takes it."""
    if not isinstance(value, str):
        raise TypeError(f"{name} is of type {type(value).__name__}; it must be a str")
    return value.encode()


def shape_pointers(name: str, shapes: Any) -> Given:
    """Pointers of one shape or of several."""
    if hasattr(shapes, "pointer"):
        return Given(name, (ctypes.c_void_p * 1)(shapes.pointer), True)
    pointers = [shape_pointer(name, shape) for shape in shapes]
    return Given(name, (ctypes.c_void_p * len(pointers))(*pointers))


def shape_pointer(name: str, shape: Any) -> Any:
    if not hasattr(shape, "pointer"):
        raise TypeError(f"{name} is of type {type(shape).__name__}; it must be a Shape")
    return shape.pointer
