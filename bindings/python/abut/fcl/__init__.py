# SPDX-License-Identifier: Apache-2.0
"""The interface of python-fcl on top of abut, for programs that were written for it: `import abut.fcl as fcl`.

Sizes, frames, signs and the order of arguments are those of FCL. docs/fcl.md lists the differences. Needs NumPy.
"""

from .. import __version__ as __version__
from .data import *
from .manager import *
from .objects import *
from .queries import *
from .shapes import *
