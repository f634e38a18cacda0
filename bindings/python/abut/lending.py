# SPDX-License-Identifier: Apache-2.0
"""Answers that stay in the memory of a universe, and what keeps them from being read when they are over.

The library lends contacts until the next change of the universe. A Borrowed knows the number of changes at which it was
lent, and raises StaleError after the next one. Arrays of NumPy cannot look at a number. While one of them still looks at
lent memory, the universe refuses to change, with BufferError, as a bytearray does.
"""

from __future__ import annotations

import ctypes
import gc
import threading
import weakref
from typing import Any

from .owner import Owner
from .records import Records

__all__ = ["Borrowed", "StaleError"]


class StaleError(RuntimeError):
    """Borrowed records were used after the universe had changed."""


class Borrowed(Records):
    """Records in the memory of a universe, good until it changes. copy() has no such end; one record is a copy, too."""

    __slots__ = ("_address", "_changes", "_count", "_kind", "_universe")

    def __init__(self, universe: Lender, kind: Any, address: int, count: int, changes: int) -> None:
        self._universe = universe
        self._kind = kind
        self._address = address
        self._count = count
        self._changes = changes

    @property
    def kind(self) -> Any:
        return self._kind

    @property
    def is_stale(self) -> bool:
        """Whether the universe has changed since."""
        return self._changes != self._universe.change_count

    @property
    def memory(self) -> ctypes.Array:
        return self._universe.lend(self._kind, self._address, self._count, self._changes)

    def _one(self, index):
        return self._kind.from_buffer_copy(self.memory[index])

    def __getitem__(self, index: Any) -> Any:
        # A slice is a copy like one record, so that only arrays hold a universe back.
        return super().__getitem__(index).copy() if isinstance(index, slice) else super().__getitem__(index)

    def __repr__(self) -> str:
        return f"<stale {self._kind.__name__}>" if self.is_stale else super().__repr__()


class Lender(Owner):
    """Any number of threads may read, or one may change. Arrays that look at lent memory hold changes back."""

    def __init__(self, pointer: Any) -> None:
        self.change_count = 0
        self._loans: list[weakref.ref] = []
        self._lock = threading.RLock()  # a collected object may come back here
        self._reader_count = 0
        self._changing_thread: int | None = None
        super().__init__(pointer)

    def _read(self, function: Any, *arguments: Any) -> None:
        """A call that may run together with others that read. A filter may read while its own thread changes."""
        with self._lock:
            if self._changing_thread not in (None, threading.get_ident()):
                raise RuntimeError("another thread changes this universe; wait for it before you use the universe")
            self._reader_count += 1
        try:
            function(self.pointer, *arguments)
        finally:
            with self._lock:
                self._reader_count -= 1

    def _change(self, function: Any, *arguments: Any) -> None:
        """A call that must run alone. From a filter, which runs within another one, the library refuses most of them."""
        is_outermost = self._begin_change()
        try:
            pointer = self.pointer
            if is_outermost:
                self._end_loans()
            function(pointer, *arguments)
        finally:
            if is_outermost:
                self._changing_thread = None

    def _begin_change(self):
        with self._lock:
            if self._changing_thread == threading.get_ident():
                return False
            if self._changing_thread is not None or self._reader_count:
                doing = "reads" if self._changing_thread is None else "changes"
                raise RuntimeError(f"another thread {doing} this universe; wait for it before you change the universe")
            self._changing_thread = threading.get_ident()
            return True

    def lend(self, kind: Any, address: int, count: int, changes: int) -> ctypes.Array:
        """Memory of the library as an array, which holds back changes for as long as it lives."""
        with self._lock:
            if changes != self.change_count:
                raise StaleError(f"the universe has changed since these {count} records were borrowed; "
                                 "borrow them again, or copy() them before the change")
            if self._changing_thread is not None:
                raise RuntimeError("a filter cannot borrow, since its step overwrites what it would get; copy instead")
            if not count:
                return (kind * 0)()
            memory: Any = (kind * count).from_address(address)
            memory.keeps = self
            self._loans.append(weakref.ref(memory))
            return memory

    def _is_lent(self):
        self._loans = [loan for loan in self._loans if loan() is not None]
        return bool(self._loans)

    def _end_loans(self):
        if self._is_lent():
            gc.collect()  # an array may be held by nothing but a cycle
            if self._is_lent():
                raise BufferError("an array still looks at borrowed records, which this would overwrite; "
                                  "delete the array, or make it from a copy()")
        self.change_count += 1

    def close(self) -> None:
        if not self._pointer:
            return
        if not self._begin_change():
            raise RuntimeError("a filter cannot close the universe that asks it")
        try:
            self._end_loans()
            super().close()
        finally:
            self._changing_thread = None
