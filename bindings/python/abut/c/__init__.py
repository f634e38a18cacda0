# SPDX-License-Identifier: Apache-2.0
"""The C interface of abut as it is, through ctypes: constants, structs, functions.

The names are those of abut.h and picking.h without their prefix for constants and structs. Functions are attributes of
`library` and of `picking`. The package abut wraps all this in objects.
"""

from .constants import *
from .functions import *
from .library import *
from .structs import *
