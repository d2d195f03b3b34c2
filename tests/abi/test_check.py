#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Tests that the ABI gate permits growth only: libraries of edited headers against the frozen present header."""
import pathlib
import re
import subprocess
import tempfile
import unittest

import check
import debug_stub
import surface
from surface import api_model

HERE = pathlib.Path(__file__).resolve().parent
VERSION = "0.0"
# Without comments, which may change.
HEADER, RESEARCH = (re.sub(r" */\*.*?\*/", "", file.read_text(), flags=re.S) for file in api_model.files_of(check.HEADER))
SEAM = "/* research */"
END = "#ifdef __cplusplus\n}\n#endif\n\n#endif"


def edited(*changes, text=HEADER):
    """A header with texts replaced, each of which is there."""
    for old, new in changes:
        assert text.count(old) == 1, (text.count(old), old)
        text = text.replace(old, new)
    return text


def written(folder, text, research=RESEARCH):
    """Both headers in a new folder."""
    folder.mkdir(exist_ok=True)
    (folder / "langevin_rigid_research.h").write_text(research)
    (folder / "langevin_rigid.h").write_text(text)
    return folder / "langevin_rigid.h"


def without(function):
    return re.sub(rf"^LR_API [^;]*?\b{function}\([^;]*;\n", "", HEADER, count=1, flags=re.S | re.M)


GROWN = edited(
    ("    float turbulence;\n} lr_load_gains;",
     "    float turbulence;\n    float more;\n    float reserved_1;\n} lr_load_gains;"),
    ("    uint32_t reserved;\n} lr_overlap_desc;", "    uint32_t layers;\n} lr_overlap_desc;"),
    ("LR_EVENTS_ALL = 255", "LR_EVENTS_NEW = 256,\n    LR_EVENTS_ALL = 511"),
    ("#define LR_MAX_WIND_SOURCES 64u", "#define LR_MAX_WIND_SOURCES 128u"),
    (END, "LR_API lr_status lr_world_new(lr_world* world, const lr_load_gains* gains);\n" + END))
REORDERED = edited(("    uint64_t seed;\n    float gravity[3];\n",
                    "    float gravity[3];\n    float gap;\n    uint64_t seed;\n"))


def grown_headers():
    """The texts of the headers in which every struct that may grow has, and the names of those."""
    structs = {name: struct for name, struct in surface.Surface(check.HEADER).structs.items() if struct["grows"]}
    text = HEADER + SEAM + RESEARCH
    for name, struct in structs.items():
        # With the struct's own alignment: a smaller field behind a pointer would lie in padding on 32 bits.
        field = "uint64_t grown" if min(struct["alignments"]) == 8 else "float grown[2]"
        text, count = re.subn(rf"^\}} {name};$", f"    {field};\n}} {name};", text, flags=re.M)
        assert count == 1, name
    return text.split(SEAM), list(structs)


class Libraries(unittest.TestCase):
    """The whole gate, with a library built from the header."""

    @classmethod
    def setUpClass(cls):
        cls.frozen = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.frozen.cleanup)
        check.renew(VERSION, check.HEADER, cls.frozen.name)

    def gate(self, text, built=None, exports=None, **how):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            header = written(folder / "header", text)
            source = written(folder / "built", built) if built else header
            library = debug_stub.build(source, folder / "library", **how)
            (folder / "exports.txt").write_text("\n".join(exports or re.findall(r"^LR_API [^(]*?(lr_\w+)\(", text + RESEARCH, re.M)))
            return check.check(library, header, folder / "exports.txt", self.frozen.name)

    def refused(self, what, text, **how):
        faults, _ = self.gate(text, **how)
        self.assertTrue(any(re.search(what, fault, re.S) for fault in faults), faults)
        return faults

    def test_the_same_again(self):
        self.assertEqual(self.gate(HEADER)[0], [])

    def test_growth_passes_and_is_told(self):
        faults, notes = self.gate(GROWN)
        self.assertEqual(faults, [])
        for what in ("function lr_world_new is new", "lr_load_gains: field more is new", "reserved .* has become layers",
                     "LR_EVENTS_NEW is new", "LR_EVENTS_ALL was 255 .* is 511", "LR_MAX_WIND_SOURCES was 64 .* is 128"):
            self.assertTrue(any(re.search(what, note) for note in notes), (what, notes))

    def test_a_function_that_goes(self):
        self.refused("function lr_world_wake_box is gone", without("lr_world_wake_box"))
        self.refused("lr_world_wake_box is no longer exported", HEADER, built=without("lr_world_wake_box"))

    def test_a_reordered_struct_is_seen_twice(self):
        self.refused("at the place of seed .* is gravity", REORDERED)
        self.refused("libabigail says:.*lr_world_desc", REORDERED)

    def test_a_changed_parameter_is_seen_twice(self):
        text = edited(("lr_world_step(lr_world* world, float dt, uint32_t substeps)", "lr_world_step(lr_world* world, double dt, uint32_t substeps)"))
        faults = self.refused("function lr_world_step was lr_status .*f32, u32.* and is .*f64", text)
        self.assertTrue(any("libabigail says" in fault for fault in faults))

    def test_a_struct_without_a_size_may_not_grow(self):
        text = edited(("    float size[3];\n} lr_kill_volume;",
                       "    float size[3];\n    float more;\n} lr_kill_volume;"))
        faults = self.refused("struct lr_kill_volume (had|must not)", text)
        self.assertTrue(any("libabigail says" in fault for fault in faults))

    def test_symbols_that_are_not_of_the_list(self):
        self.refused("lr_counter is exported but is no function", HEADER, extra="LR_API int lr_counter = 1;")
        self.refused("lr_secret is exported but not in the list", HEADER, extra="LR_API void lr_secret(void); void lr_secret(void) { }")
        with tempfile.TemporaryDirectory() as name:
            script = pathlib.Path(name) / "two.map"
            script.write_text("OLDER { global: lr_older; };\n" + (surface.ROOT / "src/api/exports.map").read_text())
            self.refused("second one beside it|several versions", HEADER, version_script=script,
                         extra='LR_API void lr_older(void); void lr_older(void) { }')

    def test_a_break_under_another_soname_is_told_and_passes(self):
        faults, notes = self.gate(REORDERED, soname="liblangevin_rigid.so.1")
        self.assertEqual(faults, [])
        self.assertTrue(any("breaks" in note and "may" in note for note in notes), notes)


class Headers(unittest.TestCase):
    """The header's check alone."""

    @classmethod
    def setUpClass(cls):
        cls.old = surface.Surface(check.HEADER)

    def breaks(self, text=HEADER, research=RESEARCH):
        with tempfile.TemporaryDirectory() as folder:
            return surface.compare(self.old, surface.Surface(written(pathlib.Path(folder), text, research)))[0]

    def test_constants(self):
        for old, new in (("LR_ERROR_CAPACITY = -8", "LR_ERROR_CAPACITY = -28"), ("LR_FORCE_MODE_IMPULSE = 2", "LR_FORCE_MODE_IMPULSE = 4"),
                         ("LR_EVENTS_ALL = 255", "LR_EVENTS_ALL = 254"), ("#define LR_MAX_WAVES 8u", "#define LR_MAX_WAVES 8"),
                         ("#define LR_MAX_SUBSTEP 1.0f", "#define LR_MAX_SUBSTEP 0.5f"), ("    LR_SIMD_NEON = 4,\n", "")):
            self.assertEqual(len(self.breaks(edited((old, new)))), 1, new)

    def test_types(self):
        for old, new in (("lr_batch {\n    uint32_t id;", "lr_batch {\n    uint64_t id;"),
                         ("    float age;\n    lr_sleep_state sleep_state;", "    int32_t age;\n    lr_sleep_state sleep_state;"),
                         ("lr_sleep_state sleep_state;\n    uint64_t", "uint64_t"),
                         ("    uint32_t divisor;", "    uint32_t factor;"),
                         ("typedef void (*lr_task_fn)(void* task, uint32_t begin, uint32_t end);",
                          "typedef void (*lr_task_fn)(void* task, uint64_t begin, uint64_t end);")):
            self.assertTrue(self.breaks(edited((old, new))), new)
        self.assertTrue(self.breaks(research=edited(("    const lr_aerodynamics* aerodynamics;", "    lr_aerodynamics* aerodynamics;"), text=RESEARCH)))

    def test_what_differs_on_32_bits_alone(self):
        # The same 8 bytes on 64-bit targets.
        self.assertTrue(self.breaks(edited(("    const lr_body* ids;", "    uint64_t ids;"))))

    def test_every_struct_may_grow(self):
        texts, names = grown_headers()
        self.assertGreater(len(names), 30)
        self.assertEqual(self.breaks(*texts), [])
        # A field of 4 bytes behind a pointer, which wasm32 has in the padding of a struct that is aligned to 8.
        research = edited(("    const lr_aerodynamics* aerodynamics;\n} lr_rigid_desc;",
                           "    const lr_aerodynamics* aerodynamics;\n    float more;\n    float reserved_1;\n} lr_rigid_desc;"), text=RESEARCH)
        self.assertEqual(len([b for b in self.breaks(research=research) if "on wasm32 the new field more" in b]), 1)

    def test_a_field_in_padding(self):
        def tiny(more):
            return ("#include <stdint.h>\n" + "".join(f"#define LR_VERSION_{p} 0\n" for p in ("MAJOR", "MINOR", "PATCH")) +
                    f"typedef struct lr_t {{ uint32_t struct_size; double x; uint32_t y; {more} }} lr_t;\n")
        with tempfile.TemporaryDirectory() as folder:
            seen = []
            for index, more in enumerate(("", "uint32_t z;", "uint32_t reserved, z;", "double z;")):
                path = pathlib.Path(folder) / f"{index}.h"
                path.write_text(tiny(more))
                seen.append(surface.Surface(path))
            self.assertEqual([len(surface.compare(seen[0], s)[0]) for s in seen], [0, 1, 1, 0])

    def test_no_rule_is_idle(self):
        self.assertEqual(self.breaks(HEADER), [])
        self.assertGreater(len(self.old.functions), 100)
        self.assertGreater(len([s for s in self.old.structs.values() if s["grows"]]), 30)


class Tests(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.present = surface.Surface(check.HEADER)

    def test_frozen_layouts_are_those_of_the_frozen_headers(self):
        for header in HERE.glob("*/langevin_rigid.h"):
            layout = (header.parent / "layout.txt").read_text()
            self.assertEqual(surface.layout_text(surface.Surface(header)), layout, "see check.py --renew")

    def test_the_layout_is_that_of_the_compilers_of_all_platforms(self):
        compilers = [["cc"]] + [["clang-14", f"--target={target}", "-ffreestanding"] for target in (
            "x86_64-linux-gnu", "aarch64-linux-gnu", "x86_64-pc-windows-msvc", "arm64-apple-macos", "wasm32")]
        with tempfile.TemporaryDirectory() as name:
            table = pathlib.Path(name) / "layout.txt"
            table.write_text(surface.layout_text(self.present))
            for compiler in compilers:
                subprocess.run([*compiler, "-std=c99", "-pedantic-errors", "-Werror", "-fsyntax-only", "-I", check.HEADER.parent,
                                f'-DLR_LAYOUT="{table}"', HERE / "check_layout.c"], check=True)


if __name__ == "__main__":
    unittest.main()
