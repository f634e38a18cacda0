# SPDX-License-Identifier: Apache-2.0
"""Owns one pointer of the library."""

from __future__ import annotations

from typing import Any


class Owner:
    """Released by `with`, by close(), or when it is collected."""

    _pointer: Any = None

    def __init__(self, pointer: Any) -> None:
        self._pointer = pointer

    @property
    def pointer(self) -> Any:
        """The pointer of C; a closed object has none."""
        if not self._pointer:
            raise ValueError(f"this {type(self).__name__.lower()} is closed")
        return self._pointer

    def __reduce_ex__(self, protocol: Any) -> Any:
        # What copy and pickle would do on their own: two owners of one pointer.
        raise TypeError(f"a {type(self).__name__} cannot be copied or pickled")

    def __enter__(self):
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __del__(self) -> None:
        if self._pointer:
            self.close()

    def close(self) -> None:
        """Releases it now. Closing twice does nothing."""
        pointer, self._pointer = self._pointer, None
        if pointer:
            self._release(pointer)

    def _release(self, pointer: Any) -> None:
        raise NotImplementedError
