# SPDX-License-Identifier: Apache-2.0
"""Structs of options: their defaults, and then what the caller sets."""

from __future__ import annotations

import ctypes
from ctypes import byref, c_uint32, c_uint64
from typing import Any

from . import c, given
from .records import Records, is_numpy_loaded

_LIMITS = {c_uint32: 2**32 - 1, c_uint64: 2**64 - 1}


def _value(kind, name, value):
    """A value as a field takes it. Whole numbers that do not fit are refused, since ctypes would cut them."""
    if kind in (c.Pose, c.Vec3):
        return given.one(kind, name, value)
    if kind in _LIMITS and not 0 <= value <= _LIMITS[kind]:
        raise ValueError(f"{name} is {value}; it must be in [0, {_LIMITS[kind]}]")
    return value


def _known_fields(struct, fields):
    known = dict(struct._fields_)
    for name in fields:
        if name not in known or name == "struct_size":
            raise TypeError(f"{struct.__name__} has no field {name}; it has {', '.join(list(known)[1:])}")
    return known


def set_fields(options: Any, fields: dict) -> None:
    """Sets fields of a struct. An unknown one is an error, which lists those that exist."""
    known = _known_fields(type(options), fields)
    for name, value in fields.items():
        try:
            setattr(options, name, _value(known[name], name, value))
        except TypeError as failure:
            raise TypeError(f"{name}: {failure}") from None


def filled(struct: Any, init: Any, fields: dict) -> Any:
    """An options struct with its defaults and then the given fields."""
    options = struct()
    init(byref(options), ctypes.sizeof(struct))
    set_fields(options, fields)
    return options


def of_each(struct: Any, init: Any, count: int, fields: dict) -> ctypes.Array:
    """Options of `count` things: a field is the same for all, or a sequence with a value for each."""
    known = _known_fields(struct, fields)
    several = {name: value for name, value in fields.items() if _is_for_each(known[name], value)}
    one = filled(struct, init, {name: value for name, value in fields.items() if name not in several})
    options = (struct * count).from_buffer_copy(bytes(one) * count)
    for name, value in several.items():
        _set_column(options, name, known[name], value)
    return options


def _is_for_each(kind, value):
    if kind in (c.Pose, c.Vec3):
        return not given.structs(kind, "value", value).is_one
    return hasattr(value, "__len__")


def _set_column(options, name, kind, value):
    memory = given.structs(kind, name, value).memory if kind in (c.Pose, c.Vec3) else given.numbers(name, value, kind)
    if len(memory) != len(options):
        raise ValueError(f"{name} has {len(memory)} elements; it must have {len(options)}")
    if is_numpy_loaded():
        getattr(Records(options), name)[...] = Records(memory).array
        return
    for option, each in zip(options, memory):
        setattr(option, name, each)


def query(fields: dict) -> Any:
    """QueryOptions; the library knows the defaults without them."""
    return byref(filled(c.QueryOptions, c.library.abut_query_options_init, fields)) if fields else None


def filter_of(fields: dict) -> Any:
    """A QueryFilter; the library knows the default without it."""
    return byref(filled(c.QueryFilter, c.library.abut_query_filter_init, fields)) if fields else None


def elements_options_of(fields: dict) -> Any:
    """A pointer to options of searches of elements; none for the defaults."""
    return byref(filled(c.ElementsOptions, c.library.abut_elements_options_init, fields)) if fields else None


def impact_options_of(fields: dict) -> Any:
    """A pointer to options of times of impact; none for the defaults."""
    return byref(filled(c.ImpactOptions, c.library.abut_impact_options_init, fields)) if fields else None
