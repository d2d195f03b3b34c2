#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The gate of the ABI lets growth through and nothing else: libraries of edited headers, against the newest baseline."""
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

import check
import debug_stub
import grow
import surface

HERE = pathlib.Path(__file__).resolve().parent
NEWEST = max((p for p in HERE.glob("*/langevin_rigid.h")), key=lambda p: tuple(map(int, p.parent.name.split("."))))
HEADER = NEWEST.read_text()
END = "#ifdef __cplusplus\n}\n#endif\n\n#endif /* LANGEVIN_RIGID_H */"


def edited(*changes):
    """The header with texts replaced, each of which is there."""
    text = HEADER
    for old, new in changes:
        assert text.count(old) == 1, (text.count(old), old)
        text = text.replace(old, new)
    return text


def without(function):
    return re.sub(rf"^LR_API [^;]*?\b{function}\([^;]*;\n", "", HEADER, count=1, flags=re.S | re.M)


GROWN = edited(
    ("    float turbulence;  /* intensity of the body's own wake, 0 to 100; initially 1 */\n} lr_load_gains;",
     "    float turbulence;\n    float more;\n    float reserved_1;\n} lr_load_gains;"),
    ("    uint32_t reserved; /* 0 */\n} lr_wind_desc;", "    uint32_t gusts;\n} lr_wind_desc;"),
    ("#define LR_EVENTS_ALL 31u", "#define LR_EVENTS_NEW 32u\n#define LR_EVENTS_ALL 63u"),
    ("#define LR_MAX_WIND_SOURCES 64u", "#define LR_MAX_WIND_SOURCES 128u"),
    (END, "LR_API lr_status lr_world_new(lr_world* world, const lr_load_gains* gains);\n" + END))
REORDERED = edited(("    uint64_t seed;          /* of all noise; initially 0 */\n    float gravity[3];       /* m/s^2; initially 0, -9.81, 0 */\n",
                    "    float gravity[3];\n    float gap;\n    uint64_t seed;\n"))


class Libraries(unittest.TestCase):
    """As a whole: a library is built with the header's functions."""

    def gate(self, text, built=None, exports=None, **how):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "header").mkdir()
            header = folder / "header" / "langevin_rigid.h"
            header.write_text(text)
            source = header
            if built:
                (folder / "built").mkdir()
                source = folder / "built" / "langevin_rigid.h"
                source.write_text(built)
            library = debug_stub.build(source, folder / "library", **how)
            (folder / "exports.txt").write_text("\n".join(exports or re.findall(r"^LR_API [^(]*?(lr_\w+)\(", text, re.M)))
            (folder / "baselines").mkdir()
            shutil.copytree(NEWEST.parent, folder / "baselines" / NEWEST.parent.name)
            return check.check(library, header, folder / "exports.txt", folder / "baselines")

    def refused(self, what, text, **how):
        faults, _ = self.gate(text, **how)
        self.assertTrue(any(re.search(what, fault, re.S) for fault in faults), faults)
        return faults

    def test_the_same_again(self):
        self.assertEqual(self.gate(HEADER)[0], [])

    def test_growth_passes_and_is_told(self):
        faults, notes = self.gate(GROWN)
        self.assertEqual(faults, [])
        for what in ("function lr_world_new is new", "lr_load_gains: field more is new", "reserved .* has become gusts",
                     "LR_EVENTS_NEW is new", "LR_EVENTS_ALL was 31 .* is 63", "LR_MAX_WIND_SOURCES was 64 .* is 128"):
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
        text = edited(("    float size[3];   /* m; of a plane its normal, of any length but 0 */\n} lr_kill_volume;",
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
    """By the header alone."""

    @classmethod
    def setUpClass(cls):
        cls.old = surface.Surface(NEWEST)

    def breaks(self, text):
        with tempfile.TemporaryDirectory() as folder:
            header = pathlib.Path(folder) / "langevin_rigid.h"
            header.write_text(text)
            return surface.compare(self.old, surface.Surface(header))[0]

    def test_constants(self):
        for old, new in (("#define LR_ERROR_CAPACITY (-8)", "#define LR_ERROR_CAPACITY (-28)"),
                         ("#define LR_FORCE_MODE_IMPULSE 2 ", "#define LR_FORCE_MODE_IMPULSE 4 "),
                         ("#define LR_EVENTS_ALL 31u", "#define LR_EVENTS_ALL 30u"), ("#define LR_OK 0", "#define LR_OK 0u"),
                         ("#define LR_MAX_SUBSTEP 1.0f", "#define LR_MAX_SUBSTEP 0.5f"), ("#define LR_SIMD_NEON 6\n", "")):
            self.assertEqual(len(self.breaks(edited((old, new)))), 1, new)

    def test_types(self):
        for old, new in (("typedef uint32_t lr_batch;", "typedef uint64_t lr_batch;"),
                         ("    float scale;               /* 0.001 to 1000 */", "    int32_t scale;"),
                         ("int32_t resting;           /* LR_REST_*; read only */", ""),
                         ("    float priority;         /* as set */", "    float weight;"),
                         ("typedef void (*lr_task_fn)(void* task, uint32_t begin, uint32_t end);",
                          "typedef void (*lr_task_fn)(void* task, uint64_t begin, uint64_t end);"),
                         ("const lr_aerodynamics* aerodynamics; /* copied;", "lr_aerodynamics* aerodynamics; /* copied;")):
            self.assertTrue(self.breaks(edited((old, new))), new)

    def test_what_differs_on_32_bits_alone(self):
        # The same 8 bytes on 64-bit targets.
        self.assertTrue(self.breaks(edited(("    const lr_body* born_ids;  /* `born` of them */", "    uint64_t born_ids;"))))

    def test_every_struct_may_grow(self):
        text, names = grow.grown_header(NEWEST)
        self.assertGreater(len(names), 30)
        self.assertEqual(self.breaks(text), [])
        # A field of 4 bytes behind a pointer, which wasm32 has in the padding of a struct that is aligned to 8.
        text = edited(("those of an ellipsoid with these extents */\n} lr_rigid_desc;", "*/\n    float more;\n    float reserved_1;\n} lr_rigid_desc;"))
        self.assertEqual(len([b for b in self.breaks(text) if "on wasm32 the new field more" in b]), 1)

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
    """That nothing of the API is left out of what is tested by hand."""

    @classmethod
    def setUpClass(cls):
        cls.present = surface.Surface(check.HEADER)
        cls.text = (surface.ROOT / "tests" / "api" / "test_structs.cpp").read_text()

    def test_every_struct_that_callers_size_is_initialised_by_a_test(self):
        for name, struct in self.present.structs.items():
            if struct["init"]:
                self.assertIn(f"check_init<{name}>({name}_init)", self.text)

    def test_every_function_that_takes_one_is_called_by_a_test_of_sizes(self):
        uses = [part.split(">", 1) for part in self.text.split("check_use<")[1:]]
        pairs = 0
        for function in self.present.model["functions"]:
            for parameter in function["parameters"]:
                struct = parameter["type"].get("to", {}).get("name")
                if struct not in self.present.structs or not self.present.structs[struct]["init"]:
                    continue
                if function["name"] != f"{struct}_init":
                    pairs += 1
                    self.assertTrue(any(name == struct and re.search(rf"\b{function['name']}\(", rest) for name, rest in uses),
                                    f"{function['name']} with {struct}")
        self.assertGreater(pairs, 35)

    def test_every_version_has_all_its_parts(self):
        for header in HERE.glob("*/langevin_rigid.h"):
            version, frozen = header.parent.name, surface.Surface(header)
            self.assertEqual(surface.layout_text(frozen), (header.parent / "layout.txt").read_text(), "see check.py --renew")
            self.assertIn(f'#include "abi/{version}/layout.txt"', self.text)
            program = (header.parent / "program.c").read_text().replace("##", "_")
            for function in frozen.functions:
                called = re.search(rf"\b{function}\(", program) or (
                    function.endswith("_init") and re.search(rf"INITIALISED\({function.removesuffix('_init')},", program))
                self.assertTrue(called, f"{version}/program.c: {function}")


class Grown(unittest.TestCase):
    """What grown_library.sh builds, as far as its structs."""

    def test_structs_that_have_grown_take_all_their_earlier_sizes(self):
        source = surface.ROOT / "src"
        arguments = (source / "api" / "arguments.h").read_text()
        held = dict(re.findall(r"earlier_sizes<(lr_\w+)>\{([^}]*)\}", arguments))
        self.assertIn("lr_world_desc", held)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            text, names = grow.grown_header(check.HEADER)
            (folder / "langevin_rigid.h").write_text(text)
            counts = [f"static_assert(lr::api::earlier_sizes<{n}>.size() == {held.get(n, '').count('offsetof') + 1});\n"
                      for n in names]
            program = folder / "sizes.cpp"
            program.write_text(grow.grown_arguments(arguments, names).replace("#pragma once", "") + "".join(counts))
            subprocess.run(["c++", "-std=c++20", "-fsyntax-only", "-I", folder, "-I", source, program], check=True)


if __name__ == "__main__":
    unittest.main()
