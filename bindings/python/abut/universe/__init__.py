# SPDX-License-Identifier: Apache-2.0
"""A universe: parts that hold geometries, steps that find what touches what, and queries."""

from __future__ import annotations

import weakref
from ctypes import byref, c_ubyte, c_void_p
from typing import Any

from .. import answers, c, options
from ..c import library
from .detection import Detection
from .geometries import Geometries
from .parts import Parts
from .queries import Queries, shape_cast_rays

__all__ = ["Universe", "shape_cast_rays"]


class Universe(Parts, Geometries, Detection, Queries):
    """A space in which parts meet; the fields are those of UniverseOptions.

    Methods that only read may run on several threads at once. Those that change something run alone.
    """

    def __init__(self, **fields: Any) -> None:
        out = c_void_p()
        library.abut_universe_create(byref(options.filled(c.UniverseOptions, library.abut_universe_options_init, fields)),
                                     byref(out))
        self._begin(out)

    def _begin(self, pointer):
        self._attached: weakref.WeakSet = weakref.WeakSet()
        super().__init__(pointer)

    @classmethod
    def load(cls, data: bytes) -> Universe:
        """A universe from the bytes of another one. Ids name what they named there; a filter has to be set again."""
        kept, out = bytes(data), c_void_p()
        library.abut_universe_load(kept, len(kept), byref(out))
        universe = cls.__new__(cls)
        universe._begin(out)
        return universe

    def save(self) -> bytes:
        """All of it but the filter, for files and for going back."""
        return bytes(answers.filled(c_ubyte, lambda *rest: self._read(library.abut_universe_save, *rest), 1 << 16))

    def __copy__(self) -> Universe:
        return type(self).load(self.save())

    def __deepcopy__(self, memo: Any) -> Universe:
        return self.__copy__()

    def __reduce_ex__(self, protocol: Any) -> Any:
        return type(self).load, (self.save(),)

    def close(self) -> None:
        """Destroys it with everything in it, and closes its pickers and responses before."""
        for guest in list(self._attached):
            guest.close()
        super().close()

    def _release(self, pointer):
        library.abut_universe_destroy(pointer)

    def __repr__(self) -> str:
        if not self._pointer:
            return "<Universe, closed>"
        return (f"<Universe of {len(self.parts())} parts and {len(self.geometries())} geometries, "
                f"{self.stats().contacts} contacts in the last step>")
