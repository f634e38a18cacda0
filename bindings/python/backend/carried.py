# SPDX-License-Identifier: Apache-2.0
"""Copies of the libraries that the library of abut loads, for a wheel that needs nothing of the system but libc and libstdc++.

Each copy has a name of its own, by a digest of its bytes, so that a process may load another version of it as well.
"""

import hashlib
import os
import pathlib
import platform
import re
import shutil
import subprocess

# Every Python of the tag of the wheel has these: they are its C and C++ libraries.
OF_EVERY_SYSTEM = re.compile(r"(ld-linux.*|lib(c|m|dl|pthread|rt|gcc_s|stdc\+\+))\.so\.\d+")


def carry(libraries, folder):
    """Copies `libraries`, and all that they load, into `folder`. Returns {name: path of the copy} and {name: licence}."""
    for tool, package in (("patchelf", "patchelf"), ("ldd", "libc-bin")):
        if shutil.which(tool) is None:
            raise FileNotFoundError(f"{tool} is missing; Debian has it in the package {package}")
    own = {library.name for library in libraries}
    foreign = {}
    for library in libraries:
        foreign.update({name: path for name, path in _loaded_by(library).items()
                        if name not in own and not OF_EVERY_SYSTEM.fullmatch(name)})
    names = {name: _own_name(name, path) for name, path in foreign.items()}
    copies = {}
    for library in [*libraries, *foreign.values()]:
        old = library.name if library.name in own else next(name for name, path in foreign.items() if path == library)
        copy = pathlib.Path(shutil.copyfile(library, folder / names.get(old, old)))
        changes = [("--replace-needed", needed, names[needed])
                   for needed in _output("patchelf", "--print-needed", copy).split() if needed in names]
        if old in names:
            changes.append(("--set-soname", names[old]))
        # Some versions of patchelf mix up the values of several changes.
        for change in [*changes, ("--set-rpath", "$ORIGIN")]:
            subprocess.run(["patchelf", *change, copy], check=True)
        copies[copy.name] = copy
    return copies, {names[name]: _licence(path) for name, path in foreign.items()}


def tag():
    """That of the wheel: it asks for a C library as new as that of this machine, which is newer than any function in it."""
    major, minor = platform.libc_ver()[1].split(".")[:2]
    return f"py3-none-manylinux_{major}_{minor}_{platform.machine()}"


def _output(*command, **environment):
    return subprocess.run([*map(str, command)], check=True, capture_output=True, text=True,
                          env={**os.environ, **environment}).stdout


def _loaded_by(library):
    """{name: path} of what the loader of this system finds for a library, and for what that needs in turn."""
    lines = _output("ldd", library, LD_LIBRARY_PATH=str(library.parent))
    missing = re.findall(r"(\S+) => not found", lines)
    if missing:
        raise FileNotFoundError(f"{library} needs {', '.join(missing)}, which this system has not")
    return {name: pathlib.Path(path).resolve() for name, path in re.findall(r"(\S+) => (\S+)", lines)}


def _own_name(name, path):
    stem, _, version = name.partition(".so")
    return f"{stem}-{hashlib.sha256(path.read_bytes()).hexdigest()[:8]}.so{version}"


def _licence(path):
    """The text that the package of a library comes with. The path may lie below /usr or not: Debian has merged the two."""
    for spelling in (path, pathlib.Path("/", path.relative_to("/usr")) if path.is_relative_to("/usr") else path):
        found = subprocess.run(["dpkg", "-S", spelling], capture_output=True, text=True)
        if found.returncode == 0:
            package = found.stdout.partition(":")[0]
            return pathlib.Path("/usr/share/doc", package, "copyright").read_bytes()
    raise FileNotFoundError(f"no package has {path}, so its licence is not known, and a wheel with it may not be given away")
