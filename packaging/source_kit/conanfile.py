# SPDX-License-Identifier: MIT
# Conan 2: conan create .
import re
from pathlib import Path

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, rmdir


class LangevinRigidConan(ConanFile):
    name = "langevin_rigid"
    description = "@DESCRIPTION@"
    license = "MIT"
    topics = ("physics", "simulation", "leaves", "simd", "games")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "no_os": [True, False]}
    default_options = {"shared": False, "fPIC": True, "no_os": False}
    implements = ["auto_shared_fpic"]
    exports_sources = "CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*", "third_party/*"

    def set_version(self):
        text = (Path(self.recipe_folder) / "CMakeLists.txt").read_text(encoding="utf-8")
        self.version = re.search(r"project\(langevin_rigid VERSION ([0-9.]+)", text).group(1)

    def validate(self):
        if self.settings.compiler.get_safe("cppstd"):
            check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["LR_NO_OS"] = bool(self.options.no_os)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, str(Path(self.package_folder) / "licenses"))
        copy(self, "*.txt", str(Path(self.source_folder) / "third_party" / "licences"), str(Path(self.package_folder) / "licenses"))
        for folder in ("share", "lib/pkgconfig", "lib/cmake"):
            rmdir(self, str(Path(self.package_folder) / folder))

    def package_info(self):
        shared = bool(self.options.shared)
        self.cpp_info.set_property("cmake_file_name", "langevin_rigid")
        self.cpp_info.set_property("cmake_target_name", "langevin_rigid::" + ("langevin_rigid" if shared else "static"))
        self.cpp_info.libs = ["langevin_rigid" if shared else "langevin_rigid_static"]
        if not shared:
            self.cpp_info.defines = ["LR_STATIC"]
            if self.settings.os in ("Linux", "FreeBSD"):
                self.cpp_info.system_libs = ["m", "pthread"]
