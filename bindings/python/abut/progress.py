# SPDX-License-Identifier: Apache-2.0
"""Batches in chunks, so that they show how far they are, and so that Ctrl-C ends them between two chunks."""

from __future__ import annotations

import sys
from typing import Callable, Iterator, Union

Progress = Union[None, bool, Callable[[int, int], object]]

CHUNK = 1 << 15


def _to_stderr(done, count):
    end = "\n" if done == count else ""
    print(f"\r{100 * done // max(count, 1):3} %  {done:,} of {count:,}", end=end, file=sys.stderr, flush=True)


def chunks(count: int, progress: Progress = None) -> Iterator[tuple[int, int]]:
    """First element and length of each chunk. `progress` is called with how many are done, and of how many."""
    tell = _to_stderr if progress is True else progress or None
    if tell is not None and not callable(tell):
        raise TypeError(f"progress is of type {type(tell).__name__}; it must be True or callable with (done, count)")
    for first in range(0, max(count, 1), CHUNK):
        length = min(CHUNK, count - first)
        yield first, length
        if tell is not None:
            tell(first + length, count)
