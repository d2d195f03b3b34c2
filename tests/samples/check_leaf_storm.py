#!/usr/bin/env python3
"""Runs leaf_storm as users do: results, exit codes, files.    usage: check_leaf_storm.py LEAF_STORM ASSET.lrb [MESH.obj]
With a mesh it draws, too (needs EGL).    SPDX-License-Identifier: MIT"""
import csv
import json
import os
import struct
import subprocess
import sys
import tempfile


def run(*arguments, code=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    assert done.returncode == code, f"{arguments}: exit code {done.returncode}, not {code}\n{done.stdout}{done.stderr}"
    return done


def main(asset, mesh):
    storm = ["--asset", asset, "--count", 600, "--seconds", 1, "--quiet"]
    with tempfile.TemporaryDirectory() as folder:
        def path(name):
            return os.path.join(folder, name)

        def report(*more):
            run(*storm, "--json", path("r.json"), *more)
            with open(path("r.json"), encoding="utf-8") as file:
                return json.load(file)

        first = report("--csv", path("r.csv"))
        assert first["bodies"] == 600 and first["steps"] == 60 and first["body_steps"] == 600 * 60 * 4
        assert 0.05 < first["descent_m_s"]["mean"] < 5.0, first["descent_m_s"]
        assert first["descent_m_s"]["p5"] <= first["descent_m_s"]["median"] <= first["descent_m_s"]["p95"]
        with open(path("r.csv"), newline="", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        assert len(rows) == 11 and all(int(row["bodies"]) == 600 for row in rows)
        assert abs(float(rows[-1]["time_s"]) - 1.0) < 1e-5

        # One storm, one hash: whatever the threads and the instruction set; another seed or wind, another hash.
        for more in (["--threads", 3], ["--simd", "emulated"], ["--png", path("p.png"), "--mesh", mesh] if mesh else []):
            assert report(*more)["state_hash"] == first["state_hash"], more
        for more in (["--seed", 2], ["--wind", "-1,0,2"], ["--noise", 0], ["--substeps", 5]):
            assert report(*more)["state_hash"] != first["state_hash"], more

        run(*storm, "--tracks", path("t.png"), "--tracks-count", 7, "--tracks-seconds", 0.3)
        for name in ["t.png"] + (["p.png"] if mesh else []):
            with open(path(name), "rb") as file:
                head = file.read(24)
            assert head[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">I", head[16:20])[0] == 1920, name

        assert "--asset" in run("--help").stdout
        two = run("--asset", asset, asset, "--count", 7, "--seconds", 0.1, "--quiet").stdout
        assert ": 4 bodies" in two and ": 3 bodies" in two, two
        loud = run("--asset", asset, "--count", 600, "--seconds", 1)
        assert "100 %" in loud.stderr and not run(*storm).stderr

        for bad in ([], ["--asset", path("none.lrb")], [*storm, "--dt", "nan"], [*storm, "--dt", "0"], [*storm, "--substeps", "0"],
                    [*storm, "--wind", "1,2"], [*storm, "--wind", "1,inf,2"], [*storm, "--count", "0"],
                    [*storm, "--simd", "mmx"], [*storm, "--threads", "99"], [*storm, "--what"],
                    [*storm, "--csv", path("x"), "--json", path("x")], [*storm, "--csv", asset]):
            assert run(*bad, code=1).stderr, bad
        with open(path("bad.lrb"), "wb") as file:
            file.write(b"no asset")
        for bad in (["--asset", path("bad.lrb"), "--quiet"], [*storm, "--csv", path("none/x.csv")],
                    [*storm, "--png", folder], [*storm, "--csv", "/dev/full"]):
            assert "what to do" in run(*bad, code=2).stderr, bad
        # A link is written through, never replaced; and nothing half-written is left behind.
        os.symlink(path("real.csv"), path("link.csv"))
        run(*storm, "--csv", path("link.csv"))
        assert os.path.islink(path("link.csv")) and os.path.getsize(path("real.csv")) > 0
        assert not [name for name in os.listdir(folder) if ".part-" in name]
    print("leaf_storm is right")


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    main(sys.argv[2], sys.argv[3] if len(sys.argv) > 3 else None)
