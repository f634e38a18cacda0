# SPDX-License-Identifier: Apache-2.0
"""abut, 3D collision detection, in Python: shapes, distances and contacts of pairs, universes, picking.

    with Shape.sphere(1.0) as ball, Shape.box(1.0, 1.0, 1.0) as box:
        print(pair_distance(ball, pose(), box, pose(3.0, 0.0, 0.0)).distance)

Objects are released by `with`, by close(), or when they are collected. Failures of the library raise Error, which
carries the status and the message. Poses, points and rays are structs, sequences of numbers or NumPy arrays; answers of
many are Records, whose fields are columns. NumPy is needed for arrays only. docs/python.md tells more.
"""

import ctypes
from typing import Callable

from . import c as c
from . import given
from .bodies import *
from .c import *
from .c import library
from .contact_problem import *
from .deforming import *
from .elements import *
from .gradient import *
from .impact import *
from .lending import *
from .pairs import *
from .picker import *
from .records import *
from .shapes import *
from .universe import *
from .values import *

__version__ = "0.2.0"


def version() -> str:
    """Version of the library that was loaded."""
    return library.abut_version_string().decode()


def memory_in_use() -> "tuple[int, int]":
    """How much memory the library has: bytes, and in how many blocks. NumPy and Python have theirs beside it."""
    size, blocks = ctypes.c_uint64(), ctypes.c_uint64()
    library.abut_memory_in_use(ctypes.byref(size), ctypes.byref(blocks))
    return size.value, blocks.value


_logs: list = []  # another thread may still be in one that was replaced


def set_log(log: "Callable[[int, str], object] | None", most: int = LOG_WARNING) -> None:
    """log(level, message) is called for each failure in this process, on the thread of the call; None for no log."""
    def tell(_, level, message):
        log(level, message.decode("utf-8", "replace"))

    _logs.append(c.Log(tell if log else 0))
    library.abut_set_log(_logs[-1], None, most)


def has_feature(name: str) -> bool:
    """Whether the library contains a feature, such as "threads" or "hull"."""
    return library.abut_has_feature(given.text("name", name)) == 1
