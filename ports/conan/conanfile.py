# SPDX-License-Identifier: Apache-2.0
"""Recipe of abut for Conan 2: the C library with its headers, and those for picking and response where options ask for them.

The C++20 modules are left out: each project compiles their interfaces by the compiler that built them.
"""

import os
from pathlib import Path

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, get, rmdir
from conan.tools.gnu import PkgConfigDeps

FEATURES = ("universe", "deforming", "motion", "libccd", "hull", "picking", "response", "threads")
EXTENSIONS = ("picking", "response")  # features that are libraries of their own


class Abut(ConanFile):
    name = "abut"
    version = "0.2.0"
    description = "3D collision detection: signed distances, contacts, rays and times of impact"
    license = "Apache-2.0"
    topics = ("collision-detection", "geometry", "physics", "robotics")
    package_type = "shared-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {**{feature: [True, False] for feature in FEATURES},
               "shapes": ["ANY"],
               "processor": ["", "x86-64", "x86-64-v2", "x86-64-v3", "x86-64-v4"]}
    default_options = {**{feature: True for feature in FEATURES}, "picking": False,
                       "shapes": "all",  # or names with commas between them
                       "processor": "x86-64-v3",
                       "libccd/*:enable_double_precision": True}

    def export_sources(self):
        # scripts/recipes writes conandata.yml, which names the archive of a release. Without it the tree around this file is built.
        if not self._archive():
            tree = Path(self.recipe_folder).parents[1]
            for pattern in ("CMakeLists.txt", "LICENSE", "NOTICE", "capi/*", "cmake/*", "include/*", "modules/*"):
                copy(self, pattern, tree, self.export_sources_folder)

    def source(self):
        if self._archive():
            get(self, **self._archive(), strip_root=True)

    def layout(self):
        cmake_layout(self, src_folder="." if not self._archive() else "src")

    def requirements(self):
        loaded = {"transitive_headers": False, "transitive_libs": False}  # by the shared libraries; programs do not name them
        self.requires("eigen/3.4.0", visible=False)
        if self.options.deforming:
            self.requires("boost/1.84.0", visible=False, libs=False)
        if self.options.libccd:
            self.requires("libccd/2.1", **loaded)
        if self.options.hull:
            self.requires("qhull/8.0.1", **loaded)
        if self.options.threads:
            self.requires("onetbb/2021.12.0", **loaded)
        if self.options.picking:
            self.requires("embree3/3.13.5", **loaded)

    def validate(self):
        if self.settings.os != "Linux":
            raise ConanInvalidConfiguration(f"os is {self.settings.os}; abut runs on Linux")

    def validate_build(self):
        compiler = self.settings.compiler
        if compiler != "clang" or int(str(compiler.version).partition(".")[0]) < 19:
            raise ConanInvalidConfiguration(f"abut is built by clang 19 or newer, this is {compiler} {compiler.version}; any "
                                            "compiler may use the package")

    def package_id(self):
        # The interface is C, so one package serves all compilers, and debug and release.
        del self.info.settings.compiler
        del self.info.settings.build_type

    def generate(self):
        toolchain = CMakeToolchain(self, generator="Ninja")
        toolchain.cache_variables.update({
            "ABUT_FEATURES": ";".join(feature for feature in FEATURES if self.options.get_safe(feature)),
            "ABUT_SHAPES": str(self.options.shapes).replace(",", ";"),
            "ABUT_ARCH": str(self.options.processor),
            "ABUT_WARNINGS": "OFF", "ABUT_TESTS": "OFF", "ABUT_TOOLS": "OFF"})
        toolchain.generate()
        CMakeDeps(self).generate()
        PkgConfigDeps(self).generate()  # libccd is found by pkg-config

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        for target in ("abut", *(f"abut_{extension}" for extension in self._extensions())):
            cmake.build(target=target)

    def package(self):
        cmake = CMake(self)
        for component in ("library", "dev", *self._extensions()):
            cmake.install(component=component)
        for name in ("LICENSE", "NOTICE"):
            copy(self, name, self.source_folder, os.path.join(self.package_folder, "licenses"))
        # Conan writes the files for CMake and pkg-config by what follows.
        for folder in ("cmake", "pkgconfig"):
            rmdir(self, os.path.join(self.package_folder, "lib", folder))

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "abut")
        loaded = {"abut": [(feature, package) for feature, package in
                           (("libccd", "libccd::libccd"), ("hull", "qhull::qhull"), ("threads", "onetbb::onetbb"))],
                  "picking": [("picking", "embree3::embree3")], "response": []}
        for name in ("abut", *self._extensions()):
            component = self.cpp_info.components[name]
            component.libs = ["abut" if name == "abut" else f"abut_{name}"]
            component.set_property("cmake_target_name", f"abut::{name}")
            component.set_property("pkg_config_name", component.libs[0])
            component.requires = [] if name == "abut" else ["abut"]
            component.requires += [package for feature, package in loaded[name]
                                   if self.options.get_safe(feature) and package.split("::")[0] in self.dependencies_by_name()]

    def dependencies_by_name(self):
        """Names of the packages that Conan brings. What a profile leaves to the system is not among them."""
        return {dependency.ref.name for dependency in self.dependencies.host.values()}

    def _archive(self):
        return (self.conan_data or {}).get("sources", {}).get(self.version)

    def _extensions(self):
        return [extension for extension in EXTENSIONS if self.options.get_safe(extension)]
