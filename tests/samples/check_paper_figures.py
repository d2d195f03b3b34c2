#!/usr/bin/env python3
"""Runs a small paper_figures like a user.    usage: check_paper_figures.py PAPER_FIGURES LR_BAKE ROOT WORK_DIR
SPDX-License-Identifier: MIT"""
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


def main(lr_bake, root, work):
    baked, meshes = os.path.join(work, "paper_baked"), os.path.join(root, "assets")
    subprocess.run([os.path.join(root, "samples", "paper", "bake.sh"), lr_bake, meshes, baked], check=True, timeout=600)
    base = ["--baked", baked, "--meshes", meshes]
    with tempfile.TemporaryDirectory() as folder:
        def numbers(*more):
            run(*base, "--falls", 40, "--cost-seconds", 0.01, "--output-dir", folder, *more)
            with open(os.path.join(folder, "numbers.json"), encoding="utf-8") as file:
                return json.load(file)["rows"]

        rows = numbers()

        def value(figure, of, begin):
            found = [r for r in rows if r["figure"] == figure and r["of"] == of and r["what"].startswith(begin)]
            assert len(found) == 1, (figure, of, begin, len(found))
            return found[0]["value"]

        # Fig. 2: the closed form of the decay, at the paper's Reynolds number; a body sustains the turbulence.
        assert abs(value("2", "table", "Reynolds") / 3.8e3 - 1.0) < 0.01
        assert value("2", "table", "largest error") < 1e-9
        assert value("2", "table with wake", "chi where") > 2.0 * value("2", "table", "chi at last") * value("2", "table", "chi at first")
        # Fig. 3: the leaf's behaviour for any coefficients: it turns about its long axis, tumbles, and comes down.
        for model in ("LANGEVIN", "AERODYNAMIC"):
            for figure in ("3a", "3b"):
                assert value(figure, model, "share that turns about the long axis") >= 0.5, (figure, model)
                assert 0.05 < value(figure, model, "descent") < 2.0, (figure, model)
            # Fig. 4: the plane turns front and sideways.
            for turn in ("front (nose 45 degrees up or down)", "sideways (heading by 45 degrees)"):
                least = 0.25 if model == "AERODYNAMIC" and turn.startswith("front") else 0.5
                assert value("4", model, f"share that turns {turn}, within 3 s") >= least, (model, turn)
            # Fig. 5b
            assert value("5b", model, "largest tilt") >= 1.2, model
        # A fold that is a degree off turns the plane sideways.
        turned = "share that turns sideways (heading by 45 degrees), within 3 s"
        assert value("4", "AERODYNAMIC, a fold 1 degree off", turned) >= 0.8
        # Paper falls at 0.7 to 0.8 m/s, and tumbles from side to side from 30 degrees.
        assert value("3b", "AERODYNAMIC", "share that tumbles") >= 0.8
        assert 0.6 < value("3b", "AERODYNAMIC", "descent") < 0.9
        # Statements of docs/maintainers/measurements.md on LANGEVIN alone.
        assert value("3b", "LANGEVIN", "share that tumbles") >= 0.5
        assert value("5b", "LANGEVIN", "share that swings in two directions") >= 0.5
        # Fig. 5a: without loads energy is conserved, so the swing stays within that of the release.
        assert 9.0 < value("5a", "no loads", "largest tilt") < 11.0
        assert value("5a", "no loads", "descent") > 0.5
        costs = [r["value"] for r in rows if r["figure"] == "table2" and r["unit"] == "ns"]
        assert len(costs) == 24 and all(cost > 0.0 for cost in costs)

        sizes = {"2": 1000, "3a": 1000, "3b": 1000, "4": 1000, "5": 1000}
        for figure, width in sizes.items():
            with open(os.path.join(folder, f"figure_{figure}.png"), "rb") as file:
                head = file.read(24)
            assert head[:8] == b"\x89PNG\r\n\x1a\n" and struct.unpack(">I", head[16:20])[0] == width, figure

        # The same seed gives the same numbers and picture, another seed gives others.
        def picture():
            with open(os.path.join(folder, "figure_3a.png"), "rb") as file:
                return file.read()
        first, before = numbers("--figure", "3a"), picture()
        assert first == [r for r in rows if r["figure"] == "3a"]
        assert numbers("--figure", "3a") == first and picture() == before
        assert numbers("--figure", "3a", "--seed", 2) != first and picture() != before

        assert "--figure" in run("--help").stdout
        for bad in ([], [*base, "--figure", "6"], [*base, "--falls", "0"], ["--baked", "none", "--meshes", meshes]):
            assert run(*bad, code=1).stderr, bad
        for bad in (["--baked", folder, "--meshes", meshes], [*base, "--figure", "2", "--output-dir", "/dev/null/x"]):
            assert "what to do" in run(*bad, code=2).stderr, bad
    print("paper_figures is right")


if __name__ == "__main__":
    PROGRAM = sys.argv[1]
    main(*sys.argv[2:5])
