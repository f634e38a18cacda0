# SPDX-License-Identifier: Apache-2.0
"""A shared library exports what its header declares and its committed list names, nothing else, and
needs no library that it must do without. It asks for memory through the functions of memory.cpp alone.

usage: check.py nm readelf library header symbols forbidden
`forbidden` is a pattern for names of needed libraries; empty for none.
"""

import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools/lint"))

from source import Source  # noqa: E402
from tree_rules import prototypes  # noqa: E402


def exported(nm, library):
    """Defined dynamic symbols, without versions and without the nodes of the version script."""
    lines = subprocess.run([nm, "-D", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    return {line.split()[-1].split("@")[0] for line in lines.splitlines() if line.split()[-2] != "A"}


# Whoever hands memory to another library, or takes it from there, is not among what ours import.
MEMORY = re.compile(r"_Zn[wa]|_Zd[la]Pv|(malloc|calloc|realloc|free|aligned_alloc|memalign|posix_memalign|strdup)$")
# What memory.cpp itself calls where the host has set nothing.
OF_THE_PROCESS = {"_Znwm", "_ZnwmSt11align_val_t", "_ZdlPvm", "_ZdlPvmSt11align_val_t"}


def asked_for_memory(nm, library):
    lines = subprocess.run([nm, "-D", "--undefined-only", library], check=True, capture_output=True, text=True).stdout
    names = {line.split()[-1].split("@")[0] for line in lines.splitlines()}
    return {name for name in names if MEMORY.match(name)}


def needed(readelf, library):
    lines = subprocess.run([readelf, "-d", library], check=True, capture_output=True, text=True).stdout
    return re.findall(r"NEEDED.*\[(.*)\]", lines)


def main(nm, readelf, library, header, symbols, forbidden):
    declared = set(prototypes(Source(header, Path(header).read_text(encoding="utf-8"))))
    listed = Path(symbols).read_text(encoding="utf-8").split()
    has = exported(nm, library)
    failures = []
    if not declared:
        failures.append(f"{header} declares no function")
    for name in sorted(declared - has):
        failures.append(f"{name} is declared but not exported")
    for name in sorted(has - declared):
        failures.append(f"{name} is exported but not declared")
    if listed != sorted(declared):
        failures.append(f"{symbols} differs from the header in {sorted(declared ^ set(listed)) or 'order'}")
    for name in needed(readelf, library):
        if forbidden and re.search(forbidden, name):
            failures.append(f"the library needs {name}")
    allowed = OF_THE_PROCESS if "abut_memory_allocate" in declared else set()
    for name in sorted(asked_for_memory(nm, library) - allowed):
        failures.append(f"{name} asks for memory, or gives it back, past the allocator of the host")
    print(f"{Path(library).name}: {len(has)} symbols, needs {', '.join(needed(readelf, library))}")
    print("\n".join(failures))
    return 1 if failures else 0


sys.exit(main(*sys.argv[1:]))
