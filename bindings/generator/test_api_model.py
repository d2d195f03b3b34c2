#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Tests that the model holds every export of the library, with its comment."""
import pathlib
import tempfile
import unittest

import api_model

ROOT = pathlib.Path(__file__).resolve().parents[2]


class ApiModel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = api_model.read()
        cls.functions = {f["name"]: f for f in cls.model["functions"]}
        cls.structs = {s["name"]: s for s in cls.model["structs"]}

    def test_functions_are_what_the_library_exports(self):
        exported = (ROOT / "tests" / "api" / "exports.txt").read_text().split()
        self.assertEqual(sorted(self.functions), sorted(exported))

    def test_constants_are_all_numeric_macros_of_the_header(self):
        names = {line.split()[1].split("(")[0] for line in api_model.HEADER.read_text().split("\n")
                 if line.lstrip().startswith("#define LR_") and len(line.split()) > 2 and "__" not in line}
        found = {c["name"] for c in self.model["constants"] if "enum" not in c} | {f"LR_VERSION_{p.upper()}" for p in self.model["version"]}
        inits = {f"{s['name'].upper()}_INIT" for s in self.model["structs"] if s["init"]}
        self.assertEqual(names - {"LR_API"} - inits, found)
        values = {c["name"]: c["value"] for c in self.model["constants"]}
        self.assertEqual(values["LR_ERROR_STALE_COLLIDER"], -27)
        self.assertEqual(values["LR_MAX_SUBSTEP"], 1.0)

    def test_layouts_follow_the_target(self):
        narrow = {s["name"]: s for s in api_model.read(target="wasm32-unknown-unknown")["structs"]}
        for name, struct in self.structs.items():
            end = 0
            for field in struct["fields"]:
                self.assertGreaterEqual(field["offset"], end, f"{name}.{field['name']}")
                end = field["offset"] + field["size"]
            self.assertLessEqual(end, struct["size"])
        self.assertEqual((self.structs["lr_allocator"]["size"], narrow["lr_allocator"]["size"]), (24, 12))
        self.assertEqual(self.structs["lr_event"]["size"], 64)
        self.assertEqual(narrow["lr_event"]["size"], 64)

    def test_each_struct_that_a_caller_sizes_has_a_function_that_fills_it(self):
        asked = {"lr_wind_query", "lr_water_query"}  # the library's own structs, passed to callbacks
        for struct in self.structs.values():
            sized = struct["fields"][0]["name"] == "struct_size" and struct["name"] not in asked
            self.assertEqual(struct["init"], f"{struct['name']}_init" if sized else None)

    def test_functions_say_what_they_do_and_name_their_statuses(self):
        known = {c["name"] for c in self.model["constants"]}
        for function in self.functions.values():
            if function["name"].endswith("_init"):
                continue
            self.assertTrue(function["doc"] or function["returns"], function["name"])
            self.assertEqual([s for s in function["statuses"] if s not in known and s + "_NULL" not in known
                              and not any(k.startswith(s + "_") for k in known)], [], function["name"])
            if function["result"].get("name") == "lr_status":
                self.assertTrue(function["returns"] or "Returns what" in function["doc"], function["name"])

    def test_what_is_said_of_parameters_is_found(self):
        words = {p["name"]: p["doc"] for p in self.functions["lr_batch_write_transforms"]["parameters"]}
        self.assertTrue(words["stride"].startswith("0 for elements without gaps"))
        self.assertTrue(all(words[name] for name in words), words)


# Both forms of constants and handles.
FORMS = """
#include <stdint.h>

/* ------ */
/* Shapes */

/* How it goes wrong. */
typedef int32_t lr_status;
enum {
    LR_OK = 0,
    LR_ERROR_NULL_ARGUMENT = -1, /* a pointer is null */
};

/* How loads are computed. */
typedef int32_t lr_load_model;
enum {
    LR_LOADS_DEFAULT = 0,
    LR_LOADS_NONE = 1, /* vacuum */
};
typedef uint32_t lr_ray_flags;
enum { LR_RAY_BODIES = 1 };

#define LR_END_DESTROY 0 /* the body is destroyed */
#define LR_MAX_PARTS 8u

typedef struct lr_world lr_world;
typedef uint32_t lr_batch;
typedef struct lr_body { uint64_t id; } lr_body; /* of a batch */

typedef struct lr_thing {
    uint32_t struct_size;
    lr_load_model load_model; /* the first by default */
    lr_body body;
    int32_t action; /* LR_END_* */
} lr_thing;

/* Sets it; null removes it.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world). */
lr_status lr_body_set_thing(lr_world* world, lr_body body, const lr_thing* thing);

/* Reads it. thing: receives it. model: receives the model; may be null.
 * LR_OK, LR_ERROR_NULL_ARGUMENT. */
lr_status lr_batch_get_thing(const lr_world* world, lr_batch batch, lr_thing* thing, lr_load_model* model);
"""


class Forms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.NamedTemporaryFile("w", suffix=".h") as file:
            file.write(FORMS)
            file.flush()
            cls.model = api_model.read(file.name)
        cls.functions = {f["name"]: f for f in cls.model["functions"]}

    def test_a_header_for_research_belongs_to_it(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "a.h").write_text(FORMS)
            (pathlib.Path(folder) / "a_research.h").write_text(
                '#include "a.h"\n/* More. Any thread. */\nlr_status lr_batch_set_more(lr_world* world, lr_batch batch, int32_t more);\n')
            model = api_model.read(pathlib.Path(folder) / "a.h")
        self.assertEqual([(f["name"], f["doc"]) for f in model["functions"]][-1], ("lr_batch_set_more", "More."))
        self.assertEqual(len(model["functions"]), len(self.functions) + 1)
        self.assertEqual(model["constants"], self.model["constants"])

    def test_an_enum_behind_a_typedef_names_its_values(self):
        enums = {e["name"]: e for e in self.model["enums"]}
        self.assertEqual({name: e["prefix"] for name, e in enums.items()},
                         {"lr_status": "LR_", "lr_load_model": "LR_LOADS_", "lr_ray_flags": "LR_RAY_"})
        none = enums["lr_load_model"]["members"][1]
        self.assertEqual((none["name"], none["value"], none["scalar"], none["doc"]), ("LR_LOADS_NONE", 1, "i32", "vacuum"))
        self.assertEqual(enums["lr_load_model"]["doc"], "How loads are computed.")
        self.assertEqual([(c["name"], c["value"], c.get("enum")) for c in self.model["constants"]], [
            ("LR_OK", 0, "lr_status"), ("LR_ERROR_NULL_ARGUMENT", -1, "lr_status"), ("LR_LOADS_DEFAULT", 0, "lr_load_model"),
            ("LR_LOADS_NONE", 1, "lr_load_model"), ("LR_RAY_BODIES", 1, "lr_ray_flags"), ("LR_END_DESTROY", 0, None), ("LR_MAX_PARTS", 8, None)])

    def test_types_say_their_enum(self):
        [thing] = self.model["structs"]
        self.assertEqual([f["type"] for f in thing["fields"][1:]], [
            {"kind": "scalar", "name": "i32", "enum": "lr_load_model"}, {"kind": "handle", "name": "lr_body", "of": "u64"},
            {"kind": "scalar", "name": "i32"}])
        model = self.functions["lr_batch_get_thing"]["parameters"][3]["type"]
        self.assertEqual((model["to"]["enum"], model["const"]), ("lr_load_model", False))

    def test_a_handle_is_a_number_or_a_struct_of_one(self):
        self.assertEqual([(h["name"], h["of"]) for h in self.model["handles"]], [("lr_status", "i32"), ("lr_batch", "u32"), ("lr_body", "u64")])
        body = self.functions["lr_body_set_thing"]["parameters"][1]["type"]
        self.assertEqual(body, {"kind": "handle", "name": "lr_body", "of": "u64"})
        self.assertEqual(self.functions["lr_body_set_thing"]["result"]["name"], "lr_status")

    def test_text_says_which_pointers_may_be_null(self):
        nullable = {f["name"]: [p["name"] for p in f["parameters"] if p["nullable"]] for f in self.model["functions"]}
        self.assertEqual(nullable, {"lr_body_set_thing": ["thing"], "lr_batch_get_thing": ["model"]})


if __name__ == "__main__":
    unittest.main()
