#!/usr/bin/env python3
"""The table of lr_bench --quick: every column in every row, and one hash for equal scenes, whatever the instruction set
and the workers. Does not check speed.    usage: check_csv.py LR_BENCH    SPDX-License-Identifier: MIT"""
import csv
import os
import subprocess
import sys
import tempfile

COLUMNS = ("subject model integrator path target workers bodies substeps wall_ns wall_ns_least cpu_ns cpu_ns_least cycles "
           "speed_over_sketch speed_over_sketch_avx2 memory_bytes_per_body snapshot_bytes_per_body hash lost rounds").split()
TIMES = "wall_ns wall_ns_least cpu_ns cpu_ns_least cycles".split()


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "rows.csv")
        subprocess.run([program, "--quick", "--seconds", "0.2", "--csv", path], check=True, timeout=120)
        with open(path, newline="", encoding="ascii") as file:
            reader = csv.DictReader(file)
            assert reader.fieldnames == COLUMNS, reader.fieldnames
            rows = list(reader)

    ours = [row for row in rows if row["subject"] == "langevin_rigid"]
    assert {row["subject"] for row in rows} >= {"langevin_rigid", "clock", "scalar"}
    assert {row["model"] for row in ours} == {"none", "langevin-speed", "langevin-age", "aerodynamic"}
    assert {row["path"] for row in ours} == {"diagonal", "sheet", "full", "alike", "user", "stations5", "stations8"} and {row["workers"] for row in ours} == {"0", "1"}
    for row in rows:
        assert None not in row and None not in row.values(), row
        assert all(float(row[name]) > 0 for name in TIMES) and int(row["rounds"]) > 0, row
        assert float(row["wall_ns_least"]) <= float(row["wall_ns"]) and float(row["cpu_ns_least"]) <= float(row["cpu_ns"])
    names = [tuple(row[name] for name in COLUMNS[:8]) for row in rows]
    assert len(set(names)) == len(names), "a row twice"

    scenes = {}
    for row in ours:
        assert row["lost"] == "0" and float(row["memory_bytes_per_body"]) > 52, row
        assert float(row["snapshot_bytes_per_body"]) > 52 and len(row["hash"]) == 16, row
        # User data does not change the motion.
        scene = tuple(row[name].replace("user", "diagonal") for name in ("model", "integrator", "path", "bodies", "substeps"))
        scenes.setdefault(scene, []).append(row)
    hashes = []
    for scene, same in scenes.items():
        found = {row["hash"] for row in same}
        assert len(found) == 1, (scene, [(row["target"], row["workers"], row["hash"]) for row in same])
        hashes += found
    # Different scenes have different hashes; none is that of an empty world.
    assert len(set(hashes)) == len(hashes)
    assert any(len({row["target"] for row in same}) > 1 for same in scenes.values()), "one instruction set only"
    assert any(len({row["workers"] for row in same}) > 1 for same in scenes.values()), "one count of workers only"
    print(f"{len(rows)} rows, {len(scenes)} scenes")


if __name__ == "__main__":
    main(sys.argv[1])
