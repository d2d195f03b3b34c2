# SPDX-License-Identifier: MIT
"""The generated layer against C: layouts by the compiler, functions by the library's symbols, values by the header."""
import ctypes
import os
import re
import shutil
import subprocess
import unittest

from support import PREFIX, ROOT, WORK, lr

from langevin_rigid import _native as native
from langevin_rigid import enums
from langevin_rigid._library import library, library_path

HEADER = "".join((PREFIX / "include" / name).read_text(encoding="utf-8") for name in ("langevin_rigid.h", "langevin_rigid_research.h"))


def structs():
    return {name: kind for name, kind in vars(native).items()
            if isinstance(kind, type) and issubclass(kind, ctypes.Structure) and kind is not ctypes.Structure}


class Layout(unittest.TestCase):
    @unittest.skipIf(shutil.which("cc") is None, "no C compiler")
    def test_every_struct_and_field_lies_where_the_compiler_has_it(self):
        whole = {name: kind for name, kind in structs().items() if name in native.FIELD_DOCS}
        handles = {"lr_batch", "lr_body", "lr_collider", "lr_wind_source"}  # numbers here
        self.assertEqual(set(re.findall(r"^\} (lr_\w+);", HEADER, re.M)) - handles, set(whole))
        lines = ["#include <langevin_rigid_research.h>", "#include <stddef.h>", "#include <stdio.h>", "int main(void) {"]
        expected = []
        for name, kind in whole.items():
            lines.append(f'    printf("{name} %zu\\n", sizeof({name}));')
            expected.append(f"{name} {ctypes.sizeof(kind)}")
            for field, _ in kind._fields_:
                lines.append(f'    printf("{name}.{field} %zu %zu\\n", offsetof({name}, {field}), sizeof((({name}*)0)->{field}));')
                at = getattr(kind, field)
                expected.append(f"{name}.{field} {at.offset} {at.size}")
        lines.append("    return 0;\n}\n")
        source, program = WORK / "layout.c", WORK / "layout"
        source.write_text("\n".join(lines))
        subprocess.run(["cc", "-std=c99", "-Werror", f"-I{PREFIX / 'include'}", str(source), "-o", str(program)], check=True)
        said = subprocess.run([str(program)], check=True, capture_output=True, text=True).stdout.split("\n")[:-1]
        self.assertGreater(len(said), 300)
        self.assertEqual(said, expected)

    @unittest.skipIf(shutil.which("nm") is None, "no nm")
    def test_every_exported_function_is_bound_and_used(self):
        symbols = subprocess.run(["nm", "-D", "--defined-only", os.path.realpath(PREFIX / "lib" / "liblangevin_rigid.so")],
                                 check=True, capture_output=True, text=True).stdout
        exported = set(re.findall(r" T (lr_\w+)", symbols))
        self.assertGreater(len(exported), 80)
        self.assertEqual(exported, set(native.PROTOTYPES))
        for name, (result, parameters, names, text) in native.PROTOTYPES.items():
            function = getattr(library(), name)
            self.assertEqual(function.argtypes, parameters, name)
            self.assertEqual(len(parameters), len(names), name)
            self.assertIn(f" {name}(", text.replace("*", "* "), name)
        package = ROOT / "bindings" / "python" / "langevin_rigid"
        words = " ".join(path.read_text() for path in package.rglob("*.py") if path.name != "_native.py")
        # Wind sources: functions are named by their kind.
        words += " ".join(f" lr_world_{verb}_{kind}" for verb in ("add", "update", "get") for kind in re.findall(r'_add_source\("(\w+)"', words))
        # What Python does by itself: references are counted by objects, and structs are filled by INITS.
        by_itself = {"lr_asset_retain"} | set(native.INITS.values())
        self.assertEqual({name for name in exported - by_itself if not re.search(rf"\b{name}\b", words)}, set())

    def test_parameters_are_those_of_the_header(self):
        plain = re.sub(r"/\*.*?\*/", "", HEADER, flags=re.S)
        declared = dict(re.findall(r"LR_API\s+[\w\s*]+?\b(lr_\w+)\(([^)]*)\)", plain))
        self.assertEqual(set(declared), set(native.PROTOTYPES))
        for name, parameters in declared.items():
            wanted = [] if parameters.strip() == "void" else [re.findall(r"\w+", p)[-1] for p in parameters.split(",")]
            self.assertEqual(wanted, list(native.PROTOTYPES[name][2]), name)

    def test_constants_are_those_of_the_header(self):
        found = dict(re.findall(r"^(?:#define|   ) (LR_[A-Z0-9_]+)(?: =)? (-?[0-9.]+)", HEADER, re.M))
        self.assertGreater(len(found), 120)
        for name, value in found.items():
            if not name.startswith("LR_VERSION_"):
                self.assertEqual(float(value), getattr(native, name), name)
        members = sum(len(kind.__members__) for kind in vars(enums).values()
                      if isinstance(kind, type) and issubclass(kind, int) and kind.__module__ == "langevin_rigid.enums")
        limits = [name for name in found if name.startswith("LR_MAX_")]
        self.assertEqual(members + len(limits), len([n for n in found if not n.startswith("LR_VERSION_")]))
        self.assertEqual(lr.Status.STALE_BODY, native.LR_ERROR_STALE_BODY)
        self.assertEqual(lr.TransformFormat.MATRIX_4X4_COLUMN_MAJOR, native.LR_TRANSFORM_4X4_COLUMN_MAJOR)

    def test_texts_name_members_that_are_there(self):
        texts = " ".join(text for docs in native.FIELD_DOCS.values() for text in docs.values())
        named = re.findall(r"`([A-Z]\w+)\.(\w+)`", texts)
        self.assertGreater(len(named), 20)
        for enum, member in named:
            self.assertIn(member, getattr(enums, enum).__members__)
        for enum in re.findall(r"`([A-Z][a-z]\w+)`", texts):
            self.assertTrue(hasattr(enums, enum), enum)
        self.assertNotIn("LR_", texts)

    def test_every_init_function_fills_its_struct(self):
        for name, init in native.INITS.items():
            kind = getattr(native, name)
            value = kind()
            self.assertEqual(getattr(library(), init)(ctypes.byref(value), ctypes.sizeof(kind)), 0, name)
            self.assertEqual(value.struct_size, ctypes.sizeof(kind), name)

    def test_every_function_is_called_by_the_package(self):
        package = ROOT / "bindings" / "python" / "langevin_rigid"
        text = "".join(path.read_text(encoding="utf-8") for path in package.glob("*.py") if path.name != "_native.py")
        # Wind sources: the name of a call is put together from what is done and the kind.
        stems = re.findall(r'f"(lr_world_\w+_)\{(?:self\.)?kind\}"', text)
        text += " ".join(stem + kind for stem in stems for kind in re.findall(r'_add_source\("(\w+)"', text))
        without = {"lr_asset_retain"}  # Python counts references itself
        self.assertEqual([name for name in native.PROTOTYPES if name not in text and not name.endswith("_init") and name not in without], [])


class Loading(unittest.TestCase):
    def run_python(self, code, **environment):
        path = str(ROOT / "bindings" / "python")
        env = {**os.environ, "PYTHONPATH": path, **environment}
        import sys
        return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, env=env, check=False)

    def fake_library(self, name, version):
        source, target = WORK / f"{name}.c", WORK / f"{name}.so"
        source.write_text(f"unsigned lr_version(void) {{ return {version}u; }}\n" if version is not None else "int other;\n")
        subprocess.run(["cc", "-shared", "-fPIC", str(source), "-o", str(target)], check=True)
        return str(target)

    def test_version_of_the_library_is_that_of_the_header(self):
        self.assertEqual(lr.version(), native.VERSION)
        self.assertEqual(lr.__version__, ".".join(map(str, native.VERSION)))
        self.assertTrue(os.path.samefile(library_path(), PREFIX / "lib" / "liblangevin_rigid.so"))

    def test_a_missing_library_is_said_with_what_to_do(self):
        done = self.run_python("import langevin_rigid as lr\ntry: lr.World()\nexcept ImportError as e: print(e)",
                               LANGEVIN_RIGID_LIBRARY="/nowhere/lib.so")
        self.assertIn("LANGEVIN_RIGID_LIBRARY", done.stdout)
        self.assertIn("/nowhere/lib.so: ", done.stdout)

    @unittest.skipIf(shutil.which("cc") is None, "no C compiler")
    def test_another_version_is_refused(self):
        for version, text in ((1 << 22, "1.0.0"), (99 << 12, "0.99.0"), (0, "0.0.0")):
            fake = self.fake_library(f"fake_{version}", version)
            done = self.run_python("import langevin_rigid as lr\ntry: lr.World()\nexcept lr.LibraryError as e: print(e)",
                                   LANGEVIN_RIGID_LIBRARY=fake)
            self.assertIn(f"is version {text}, but this Python package is for {lr.__version__}", done.stdout)

    @unittest.skipIf(shutil.which("cc") is None, "no C compiler")
    def test_another_library_is_refused(self):
        for name, version, words in (("other", None, "it has no lr_version"), ("bare", lr.library().lr_version(), "lacks a function")):
            fake = self.fake_library(name, version)
            done = self.run_python("import langevin_rigid as lr\ntry: lr.World()\nexcept lr.LibraryError as e: print(e)",
                                   LANGEVIN_RIGID_LIBRARY=fake)
            self.assertIn(words, done.stdout, done.stderr)

    def test_a_folder_will_do(self):
        done = self.run_python("import langevin_rigid as lr; print(lr.version())",
                               LANGEVIN_RIGID_LIBRARY=os.path.dirname(library_path()))
        self.assertEqual(done.stdout.strip(), str(native.VERSION), done.stderr)


if __name__ == "__main__":
    unittest.main()
