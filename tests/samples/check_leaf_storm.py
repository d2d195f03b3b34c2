#!/usr/bin/env python3
"""Runs leaf_storm like a user: results, exit codes, files.    usage: check_leaf_storm.py LEAF_STORM ASSET.lrb [MESH.obj]
With a mesh it also draws (needs EGL).    SPDX-License-Identifier: MIT"""
import csv
import json
import os
import platform
import struct
import subprocess
import sys
import tempfile
import zlib

# An instruction set that is not the best of most machines.
SIMPLEST = "sse4" if platform.machine().lower() in ("x86_64", "amd64") else "neon"


def run(*arguments, code=0):
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    assert done.returncode == code, f"{arguments}: exit code {done.returncode}, not {code}\n{done.stdout}{done.stderr}"
    return done


def pixels(path):
    """Rows of an 8-bit RGB PNG, as bytes."""
    with open(path, "rb") as file:
        data = file.read()
    place, packed = 8, b""
    while place < len(data):
        size, kind = struct.unpack(">I4s", data[place:place + 8])
        body = data[place + 8:place + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
            assert (depth, colour) == (8, 2)
        elif kind == b"IDAT":
            packed += body
        place += 12 + size
    raw, rows, before = zlib.decompress(packed), [], bytearray(3 * width)
    for y in range(height):
        line = bytearray(raw[y * (3 * width + 1) + 1:(y + 1) * (3 * width + 1)])
        how = raw[y * (3 * width + 1)]
        for i in range(len(line) if how else 0):
            left, up, corner = line[i - 3] if i > 2 else 0, before[i], before[i - 3] if i > 2 else 0
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda c: abs(guess - c))
            line[i] = (line[i] + (0, left, up, (left + up) // 2, paeth)[how]) & 255
        rows.append(bytes(line))
        before = line
    return rows


def check_ground(asset, mesh, path):
    """Leaves land, sleep, are crossed by a walker, and blow away."""
    scene = ["--asset", asset, "--count", 400, "--seconds", 14, "--ground", "--fall", 2, "--walk", 9, "--gusts", 11,
             "--at", "1,8.5,11,14", "--check", "--quiet", "--width", 320, "--height", 180]

    def report(*more):
        run(*scene, "--json", path("g.json"), "--csv", path("g.csv"), *more)
        with open(path("g.json"), encoding="utf-8") as file:
            return json.load(file)

    done = report(*(["--png", path("g.png"), "--mesh", mesh] if mesh else []))
    ground, checks = done["ground"], done["ground"]["checks"]
    assert [round(at["time_s"], 3) for at in checks] == [1, 8.5, 11, 14]
    assert ground["fell_through"] == 0
    assert checks[0]["bodies"] < 210 and checks[0]["at_rest"] == 0
    assert checks[1]["bodies"] == 400 and checks[1]["at_rest"] >= 0.97 * 400, checks[1]
    for at in checks:
        # A leaf that swoops into the ground edge-on dips in for a frame.
        assert at["below_2_mm"] <= 0.01 * at["bodies"] and at["above_2_mm"] == 0 and at["deepest_m"] < 5e-3, at
        assert at["on_edge"] <= 0.02 * 400, at
    assert 0 < checks[1]["median_tilt_degrees"] < 20, checks[1]

    def awake():
        with open(path("g.csv"), newline="", encoding="ascii") as file:
            rows = {round(float(row["time_s"]), 1): row for row in csv.DictReader(file)}
        assert int(rows[8.5]["at_rest"]) == checks[1]["at_rest"]
        return {time: int(row["bodies"]) for time, row in rows.items()}

    # The walker's feet wake some from 9 s on: as many as without the walker, then more.
    walked = awake()
    walk = scene.index("--walk")
    del scene[walk:walk + 2]
    report()
    alone = awake()
    scene[walk:walk] = ["--walk", 9]
    assert all(walked[time] == alone[time] for time in alone if time < 9)
    woken = [walked[time] - alone[time] for time in alone if 9 < time < 11]  # every 0.1 s
    assert max(woken) >= 2 and sum(woken) >= 10, woken

    assert report("--threads", 3)["state_hash"] == done["state_hash"]
    assert report("--simd", SIMPLEST)["state_hash"] == done["state_hash"]
    for more in (["--seed", 2], ["--rate", 2], ["--gust-speed", 3]):
        assert report(*more)["state_hash"] != done["state_hash"], more
    if mesh:
        rows = pixels(path("g.png"))
        assert len(rows) == 2 * 180 + 12 and len(rows[0]) == 3 * (2 * 320 + 12)
        tiles = [(x, y) for y in (0, 192) for x in (0, 332)]
        content = [[row[3 * x:3 * (x + 320)] for row in rows[y:y + 150]] for x, y in tiles]
        for i in range(4):
            for k in range(i):
                same = sum(content[i][y][3 * x:3 * x + 3] == content[k][y][3 * x:3 * x + 3] for y in range(150) for x in range(320))
                assert same < 0.995 * 320 * 150, f"frames {k} and {i} are alike: {same} pixels"


def check_heap(asset, mesh, path):
    """Leaves with body contact lie on each other; without it, all lie on the ground."""
    scene = ["--asset", asset, "--count", 300, "--seconds", 4, "--ground", "--fall", 0.5, "--substeps", 2, "--at", "4", "--check",
             "--wind", "0,0,0", "--quiet", "--mesh", mesh]

    def report(*more):
        run(*scene, "--json", path("h.json"), *more)
        with open(path("h.json"), encoding="utf-8") as file:
            return json.load(file)

    heap = report("--heap")
    lies = heap["ground"]["checks"][0]
    assert heap["ground"]["fell_through"] == 0 and lies["bodies"] == 300, lies
    assert lies["at_rest"] > 200 and lies["below_2_mm"] == 0 and lies["deepest_m"] < 2e-3, lies
    assert lies["above_2_mm"] > 20 and lies["highest_m"] > 0.01, lies
    assert report("--heap", "--threads", 3)["state_hash"] == heap["state_hash"]
    assert report("--heap", "--simd", SIMPLEST)["state_hash"] == heap["state_hash"]
    alone = report()["ground"]["checks"][0]
    assert alone["above_2_mm"] == 0 and alone["highest_m"] < 1e-3, alone
    two = report("--heap", "--asset", asset)
    assert two["ground"]["fell_through"] == 0 and two["state_hash"] != heap["state_hash"]


def main(asset, mesh):
    storm = ["--asset", asset, "--count", 600, "--seconds", 1, "--quiet"]
    with tempfile.TemporaryDirectory() as folder:
        def path(name):
            return os.path.join(folder, name)

        def report(*more):
            run(*storm, "--json", path("r.json"), *more)
            with open(path("r.json"), encoding="utf-8") as file:
                return json.load(file)

        check_ground(asset, mesh, path)
        if mesh:
            check_heap(asset, mesh, path)
        first = report("--csv", path("r.csv"))
        assert first["bodies"] == 600 and first["steps"] == 60 and first["body_steps"] == 600 * 60 * 4
        assert 0.05 < first["descent_m_s"]["mean"] < 5.0, first["descent_m_s"]
        assert first["descent_m_s"]["p5"] <= first["descent_m_s"]["median"] <= first["descent_m_s"]["p95"]
        with open(path("r.csv"), newline="", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        assert len(rows) == 11 and all(int(row["bodies"]) == 600 for row in rows)
        assert abs(float(rows[-1]["time_s"]) - 1.0) < 1e-5

        # A storm has one hash, for any threads and instruction set; another seed or wind has another.
        for more in (["--threads", 3], ["--simd", SIMPLEST], ["--png", path("p.png"), "--mesh", mesh] if mesh else []):
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
                    [*storm, "--walk", 1], [*storm, "--heap"], [*storm, "--gusts", 1], [*storm, "--check"], [*storm, "--at", "0.5,0.2"],
                    [*storm, "--at", "0.5,2"], [*storm, "--rate", 0], [*storm, "--seed", "-1"], [*storm, "--ground", "--gust-speed", "nan"],
                    [*storm, "--csv", path("x"), "--json", path("x")], [*storm, "--csv", asset],
                    [*storm, "--png", path("x.jpg")], [*storm, "--tracks", path("x.jpg")]):
            assert run(*bad, code=1).stderr, bad
        with open(path("bad.lrb"), "wb") as file:
            file.write(b"no asset")
        for bad in (["--asset", path("bad.lrb"), "--quiet"], [*storm, "--csv", path("none/x.csv")],
                    [*storm, "--png", folder], [*storm, "--csv", "/dev/full"]):
            assert "what to do" in run(*bad, code=2).stderr, bad
        # A link is written through, never replaced; no half-written file stays.
        os.symlink(path("real.csv"), path("link.csv"))
        run(*storm, "--csv", path("link.csv"))
        assert os.path.islink(path("link.csv")) and os.path.getsize(path("real.csv")) > 0
        assert not [name for name in os.listdir(folder) if ".part-" in name]
    print("leaf_storm is right")


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    main(sys.argv[2], sys.argv[3] if len(sys.argv) > 3 else None)
