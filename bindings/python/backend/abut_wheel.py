# SPDX-License-Identifier: Apache-2.0
"""Builds the wheel of abut, which carries the library: the hooks of PEP 517.

The library is the first of these that there is:
 - the file that the setting `library` of the front end names: pip install --config-settings library=FILE;
 - the file that the environment variable ABUT_LIBRARY names;
 - the one in build/release of this checkout;
 - the one that CMake builds in build/python, which takes minutes. CMAKE_ARGS adds arguments to its configuration.
The libraries for picking and response are carried, too, where they lie beside the other one.

With the setting `dependencies=carried` the wheel also carries the libraries that these load, as scripts/wheel does. Without it,
the system must have them.
"""

import base64
import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sysconfig
import tempfile
import zipfile

import carried

PACKAGE = pathlib.Path(__file__).resolve().parent.parent
ROOT = PACKAGE.parent.parent
TREE = ("-DABUT_TESTS=OFF", "-DABUT_BENCH=OFF", "-DABUT_TOOLS=OFF")
SUFFIXES = {".py", ".typed"}


def get_requires_for_build_wheel(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Writes what a front end reads before it builds, and answers the name of its folder."""
    version, tag = _version_and_tag(config_settings or {})
    folder = f"abut-{version}.dist-info"
    pathlib.Path(metadata_directory, folder).mkdir()
    for path, data in _metadata(folder, version, tag).items():
        pathlib.Path(metadata_directory, path).write_bytes(data)
    return folder


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Writes the wheel and answers its name."""
    settings = config_settings or {}
    version, tag = _version_and_tag(settings)
    name = f"abut-{version}-{tag}.whl"
    with tempfile.TemporaryDirectory() as folder, zipfile.ZipFile(
            pathlib.Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        files = {f"abut/{path.relative_to(PACKAGE / 'abut')}": path.read_bytes()
                 for path in sorted((PACKAGE / "abut").rglob("*")) if path.suffix in SUFFIXES}
        copies, licences = _copies(_libraries(settings), settings, pathlib.Path(folder))
        files.update({f"abut/lib/{name}": path.read_bytes() for name, path in copies.items()})
        files.update(_metadata(f"abut-{version}.dist-info", version, tag))
        files.update({f"abut-{version}.dist-info/licenses/{name}.txt": text for name, text in licences.items()})
        record = f"abut-{version}.dist-info/RECORD"
        files[record] = "".join([*(_line_of_record(path, data) for path, data in files.items()), f"{record},,\n"]).encode()
        for path, data in files.items():
            wheel.writestr(path, data)
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("abut has no source distribution: the sources of its library lie outside of this folder. "
                       "Build a wheel: pip wheel ./bindings/python")


def _carries(settings):
    """Whether the wheel has the libraries that the library loads."""
    choice = settings.get("dependencies", "of the system")
    if choice not in ("carried", "of the system"):
        raise ValueError(f"dependencies is {choice!r}; it is 'carried', or left out")
    return choice == "carried"


def _version_and_tag(settings):
    version = _number_in(PACKAGE / "abut" / "__init__.py", r'__version__ = "(.*)"')
    if _carries(settings):
        return version, carried.tag()
    return version, f"py3-none-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _number_in(path, pattern):
    return re.search(pattern, path.read_text(encoding="utf-8"))[1]


def _metadata(folder, version, tag):
    summary = "3D collision detection: distances, contacts, rays and universes of moving shapes"
    return {
        f"{folder}/METADATA": (f"Metadata-Version: 2.1\nName: abut\nVersion: {version}\nSummary: {summary}\n"
                               "License: Apache-2.0\nRequires-Python: >=3.9\nProvides-Extra: arrays\n"
                               "Requires-Dist: numpy; extra == 'arrays'\n").encode(),
        f"{folder}/WHEEL": f"Wheel-Version: 1.0\nGenerator: abut\nRoot-Is-Purelib: false\nTag: {tag}\n".encode(),
        f"{folder}/LICENSE": (ROOT / "LICENSE").read_bytes(),
    }


def _line_of_record(path, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{path},sha256={digest},{len(data)}\n"


def _libraries(settings):
    """The files to carry, under the names by which the package looks for them."""
    source = PACKAGE / "abut" / "c" / "constants.py"
    major, minor = (_number_in(source, rf"VERSION_{part} = (\d+)") for part in ("MAJOR", "MINOR"))
    abi = f"0.{minor}" if major == "0" else major
    named = settings.get("library") or os.environ.get("ABUT_LIBRARY")
    if named:
        if not os.path.isabs(named):
            raise ValueError(f"the library is named {named!r}; give its whole path, since pip builds in another folder")
        library = pathlib.Path(named).resolve().parent / f"libabut.so.{abi}"
        if not library.exists():
            raise FileNotFoundError(f"{library} is not there; this package needs version {abi} of the library")
    else:
        library = ROOT / "build" / "release" / "capi" / f"libabut.so.{abi}"
        if not library.exists():
            library = _built() / f"libabut.so.{abi}"
    print(f"abut: the wheel carries {library}")
    others = [library.with_name(f"libabut_{name}.so.{abi}") for name in ("picking", "response")]
    libraries = [library, *(other for other in others if other.exists())]
    _expect_functions(libraries)
    return libraries


def _expect_functions(libraries):
    """An older library would lack functions, which would show when the package is imported."""
    table = (PACKAGE / "abut" / "c" / "functions.py").read_text(encoding="utf-8")
    parts = dict(re.findall(r"^(\w*)FUNCTIONS = \{(.*?)^\}", table, re.MULTILINE | re.DOTALL))
    for library in libraries:
        data = library.read_bytes()
        extension = library.name.partition(".")[0].removeprefix("libabut").removeprefix("_")
        for name in re.findall(r'"(abut_\w+)": \(', parts[f"{extension.upper()}_" if extension else ""]):
            if name.encode() + b"\0" not in data:
                raise RuntimeError(f"{library} is older than this package, for it has no function {name}; build it again")


def _built():
    """The folder of a library that CMake has built from this checkout."""
    if not (ROOT / "CMakePresets.json").exists():
        raise FileNotFoundError("the sources of the library are not here; name its file: "
                                "pip install --config-settings library=FILE")
    if shutil.which("cmake") is None:
        raise FileNotFoundError(f"CMake is missing; {ROOT}/scripts/setup installs what a build needs")
    folder = ROOT / "build" / "python"
    more = shlex.split(os.environ.get("CMAKE_ARGS", ""))
    subprocess.run(["cmake", "--preset", "release", "-B", folder, *TREE, *more], cwd=ROOT, check=True)
    subprocess.run(["cmake", "--build", folder], cwd=ROOT, check=True)
    return folder / "capi"


def _copies(libraries, settings, folder):
    """{name: path of a copy} of all libraries of the wheel, and {name: licence} of those of others."""
    if _carries(settings):
        return carried.carry(libraries, folder)
    return {library.name: _without_runpath(library, folder) for library in libraries}, {}


def _without_runpath(library, folder):
    """A copy without the folder of the build in it; the package loads the libraries by their paths."""
    copy = pathlib.Path(shutil.copyfile(library, folder / library.name))
    if shutil.which("cmake"):
        script = folder / "strip.cmake"
        script.write_text(f'file(RPATH_REMOVE FILE "{copy}")\n', encoding="utf-8")
        subprocess.run(["cmake", "-P", script], check=True)
    return copy
