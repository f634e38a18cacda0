# SPDX-License-Identifier: Apache-2.0
"""The loaded libraries: `library`, and `picking` and `response`, which are None where that library is not there.

A function that answers a status other than ABUT_OK raises Error. Calls release the interpreter's lock while they run.

ABUT_LIBRARY, ABUT_PICKING_LIBRARY and ABUT_RESPONSE_LIBRARY may name their files. The other two are looked for beside
that of ABUT_LIBRARY as well. Else they are those that a wheel carries, in this package, and else those that the loader
finds.
"""

from __future__ import annotations

import ctypes
import operator
import os
import pathlib

from .constants import OK, VERSION_MAJOR, VERSION_MINOR
from .functions import FUNCTIONS, PICKING_FUNCTIONS, RESPONSE_FUNCTIONS, Status

__all__ = ["Error", "library", "picking", "picking_failure", "response", "response_failure"]

ABI = f"{VERSION_MAJOR}.{VERSION_MINOR}" if VERSION_MAJOR == 0 else f"{VERSION_MAJOR}"
CARRIED = pathlib.Path(__file__).parent.parent / "lib"


class Error(Exception):
    """A call that failed: `status` is its number, `name` the name of that, `message` says which argument and why."""

    def __init__(self, status: int, name: str, message: str) -> None:
        super().__init__(status, name, message)
        self.status = status
        self.name = name
        self.message = message

    def __str__(self) -> str:
        return f"{self.name}: {self.message}"


def _raise_failures(status, _function, _arguments):
    if status != OK:
        message = library.abut_last_error_message().decode("utf-8", "replace")
        raise Error(status, library.abut_status_name(status).decode(), message)


class _Real:
    """What functions take as a double: any real number, those of NumPy as well."""

    @staticmethod
    def from_param(value):
        return ctypes.c_double(float(value))


class _Whole:
    """What functions take as a uint32_t: any whole number that fits, where ctypes would cut what does not."""

    @staticmethod
    def from_param(value):
        number = operator.index(value)
        if not 0 <= number < 2**32:
            raise ValueError(f"{number} is not in [0, {2**32 - 1}]")
        return ctypes.c_uint32(number)


_TAKEN = {ctypes.c_double: _Real, ctypes.c_uint32: _Whole}


def _declare(loaded, functions):
    for name, (result, arguments) in functions.items():
        function = getattr(loaded, name, None)
        if function is None:
            raise ImportError(f"{loaded._name} has no function {name}: it is of another version than this package")
        function.restype = result
        function.argtypes = [_TAKEN.get(argument, argument) for argument in arguments]
        # abut_set_last_error answers the status that it was given.
        if result is Status and name != "abut_set_last_error":
            function.errcheck = _raise_failures
    return loaded


def _load(name, variable):
    file, named = f"{name}.so.{ABI}", os.environ.get("ABUT_LIBRARY", "")
    folders = [pathlib.Path(named).parent] * (os.sep in named) + [CARRIED]
    there = [str(folder / file) for folder in folders if (folder / file).exists()]
    return ctypes.CDLL(os.environ.get(variable) or [*there, file][0])


def _load_library():
    try:
        return _load("libabut", "ABUT_LIBRARY")
    except OSError as failure:
        raise ImportError(
            f"the library of abut cannot be loaded: {failure}. `pip install ./bindings/python` installs it with this "
            "package; ABUT_LIBRARY may name the file of another one") from failure


library = _declare(_load_library(), FUNCTIONS)
library.abut_check_version(VERSION_MAJOR, VERSION_MINOR)


def _load_extension(name, variable, functions):
    """The library, or None and why it is not there."""
    try:
        return _declare(_load(name, variable), functions), None
    except OSError as failure:
        return None, str(failure)


picking, picking_failure = _load_extension("libabut_picking", "ABUT_PICKING_LIBRARY", PICKING_FUNCTIONS)
response, response_failure = _load_extension("libabut_response", "ABUT_RESPONSE_LIBRARY", RESPONSE_FUNCTIONS)
