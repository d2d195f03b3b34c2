#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The model holds all that the library exports, and what the header says of it."""
import pathlib
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
        found = {c["name"] for c in self.model["constants"]} | {f"LR_VERSION_{p.upper()}" for p in self.model["version"]}
        self.assertEqual(names - {"LR_API"}, found)
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
        self.assertEqual(self.structs["lr_contact_event"]["size"], 64)
        self.assertEqual(narrow["lr_contact_event"]["size"], 64)

    def test_each_struct_that_a_caller_sizes_has_a_function_that_fills_it(self):
        asked = {"lr_wind_query", "lr_surface_query"}  # the library's own, given to callbacks
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


if __name__ == "__main__":
    unittest.main()
