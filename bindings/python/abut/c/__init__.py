# SPDX-License-Identifier: Apache-2.0
"""The C interface of abut as it is, through ctypes: constants, structs, functions.

The names are those of the headers without their prefix for constants and structs. Functions are attributes of `library`,
`picking` and `response`. The package abut wraps most of this in objects.
"""

from .constants import *
from .functions import *
from .library import *
from .structs import *
