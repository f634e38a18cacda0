# SPDX-License-Identifier: Apache-2.0
"""The raw layer: layouts of structs, constants, functions, the version.

With the folder of the C headers in ABUT_HEADERS it also checks that no function is missing.
"""

import ctypes
import os
import pathlib
import re
import subprocess
import sys
import unittest

import abut
from abut import c

HEADERS = pathlib.Path(os.environ["ABUT_HEADERS"]) if "ABUT_HEADERS" in os.environ else None


def is_served_by_another(name, called):
    """Whether a batch does what a function does for one, or Shape.of_kind what a shorthand does."""
    batch = re.sub(r"^abut_(part|geometry)_", lambda found: {"part": "abut_parts_", "geometry": "abut_geometries_"}[found[1]],
                   name)
    kind = re.fullmatch(r"abut_(\w+)_create", name)
    return not {batch, batch + "s", re.sub("y$", "ies", batch)}.isdisjoint(called - {name}) or (
        kind is not None and kind[1] in abut.shape_kinds())


class Layout(unittest.TestCase):
    def test_structs_are_those_of_the_library(self):
        structs = {"abut_" + re.sub(r"(?<!^)(?=[A-Z])", "_", name).lower(): value for name, value in vars(c).items()
                   if isinstance(value, type) and issubclass(value, ctypes.Structure) and name[0] != "_"}
        reported = {}
        for index in range(c.library.abut_layout_count()):
            entry = c.LayoutEntry()
            c.library.abut_layout_at(index, ctypes.byref(entry))
            reported.setdefault(entry.type.decode(), {})[entry.field.decode()] = (entry.offset, entry.size)
        self.assertGreater(len(reported), 20)
        for name, fields in reported.items():
            ours = {field: (getattr(structs[name], field).offset, getattr(structs[name], field).size)
                    for field, _ in structs[name]._fields_}
            ours[""] = (0, ctypes.sizeof(structs[name]))
            self.assertEqual(ours, fields, name)

    def test_no_function_is_missing(self):
        if HEADERS is None:
            self.skipTest("the folder of the headers was not given")
        for header, functions in (("abut.h", c.FUNCTIONS), ("picking.h", c.PICKING_FUNCTIONS),
                                  ("response.h", c.RESPONSE_FUNCTIONS)):
            text = (HEADERS / "abut" / header).read_text()
            declared = set(re.findall(r"^ABUT_API [^;(]*?(abut_\w+)\(", text, re.MULTILINE))
            self.assertGreater(len(declared), 8)
            self.assertEqual(declared, set(functions))

    def test_the_package_calls_all_but_what_c_programs_need_only(self):
        folder = pathlib.Path(abut.__file__).parent
        sources = "".join(path.read_text() for path in folder.rglob("*.py") if path.parent != folder / "c")
        called = set(re.findall(r"abut_\w+", sources))
        left_out = {name for functions in (c.FUNCTIONS, c.PICKING_FUNCTIONS, c.RESPONSE_FUNCTIONS) for name in functions
                    if name not in called and not is_served_by_another(name, called)}
        self.assertEqual(left_out, {
            # The package loads the library, and turns failures into exceptions.
            "abut_set_last_error", "abut_last_error_message", "abut_status_name", "abut_check_version",
            # Memory of the host, and what extension libraries and their tests need.
            "abut_set_allocator", "abut_memory_allocate", "abut_memory_release", "abut_universe_attach",
            "abut_universe_detach", "abut_universe_counters", "abut_universe_set_pointer_filter", "abut_layout_count",
            "abut_layout_at", "abut_particles_create_with_radii",
            # A detector in place of the narrow phase answers many pairs in each step: compiled code.
            "abut_backend_set", "abut_backend_answer"})

    def test_constants_are_those_of_the_header(self):
        if HEADERS is None:
            self.skipTest("the folder of the headers was not given")
        for header in ("abut.h", "picking.h", "response.h"):
            text = (HEADERS / "abut" / header).read_text()
            for name, value in re.findall(r"^  ABUT_(\w+) = (\d+)", text, re.MULTILINE):
                self.assertEqual(getattr(c, name), int(value), name)


@unittest.skipUnless(c.picking and c.response, "no libraries for picking and response")
class Libraries(unittest.TestCase):
    def test_the_others_are_found_beside_the_first(self):
        named = pathlib.Path(c.library._name)
        files = {pathlib.Path(each._name).parent for each in (c.picking, c.response)}
        if os.sep not in str(named) or files != {named.parent}:
            self.skipTest("they do not lie side by side")
        environment = {name: value for name, value in os.environ.items() if not name.startswith("ABUT_")}
        environment["ABUT_LIBRARY"] = str(named)
        check = "import abut; print(abut.c.picking._name, abut.c.response._name, abut.version())"
        done = subprocess.run([sys.executable, "-B", "-c", check], env=environment, capture_output=True, text=True)
        picking, response, _ = done.stdout.split()
        self.assertEqual({pathlib.Path(picking).parent, pathlib.Path(response).parent}, {named.parent}, done.stderr)


class Version(unittest.TestCase):
    def test_the_package_has_the_version_of_the_library(self):
        self.assertEqual(abut.__version__, abut.version())


if __name__ == "__main__":
    unittest.main()
