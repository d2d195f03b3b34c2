#!/usr/bin/env python3
"""Runs the programs of samples/small, checks that they print what nature would, and the programs of docs/guide/tutorial.md: the same, and one in C.
Compiles the fragments of C in the pages.
usage: check_small.py BUILD_DIR ROOT PREFIX        BUILD_DIR: of the samples; ROOT: of the project; PREFIX: the installed package
SPDX-License-Identifier: MIT"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile


def numbers(name, *arguments, **options):
    """The numbers of each line that the program prints."""
    done = subprocess.run([BUILD / name, *arguments], capture_output=True, text=True, timeout=120, **options)
    assert done.returncode == 0, f"{name}: exit code {done.returncode}\n{done.stdout}{done.stderr}"
    print(f"{name}:", *done.stdout.splitlines(), sep="\n    ")
    return [[float(n) for n in re.findall(r"-?\d+\.?\d*", line)] for line in done.stdout.splitlines()]


def leaves():
    rows = numbers("leaves")
    seconds, hits, landings = zip(*rows)
    assert seconds == (5, 10, 15, 20, 25, 30)
    assert hits[0] == 0 and hits[1] > 100, "leaves fall about 1 m/s, from 6 m and more"
    assert hits[-1] >= 1000 and 980 <= landings[-1] <= 1100, "all come down, and lie where the wind does not reach"
    assert landings[-1] == landings[-2], "at rest"


def dart():
    rows = numbers("dart", BUILD / "viewer_assets/paper_plane.lrb")
    seconds, far, high = zip(*rows)
    assert all(a < b for a, b in zip(far, far[1:])) and max(high) < 1.8, "it flies on, without a loop"
    assert 2.5 < far[-1] < 6, "metres, as a dart of 8 cm does"
    assert 0.8 < seconds[-1] < 2.5, "it glides: a stone falls 1.6 m in 0.57 s"


def confetti():
    rows = numbers("confetti")
    seconds, high, wide = zip(*rows)
    peak = high.index(max(high))
    assert 2 < high[peak] < 5 and seconds[peak] <= 1, "the air carries it up, and leaves it there"
    sinks = (high[-5] - high[-1]) / (seconds[-1] - seconds[-5])
    assert 0.3 < sinks < 1.2, f"paper of 80 g/m^2 turns on its way down, not at {sinks} m/s"
    # Each piece turns about its length and drifts at some 0.4 m/s to a side of its own. The blast throws single pieces a metre aside at once.
    assert wide[-1] - wide[0] > 1.0 and 2 < wide[-1] < 6, "it spreads while it turns"


def coin():
    *rows, (seconds, depth) = numbers("coin")
    assert rows[0] == [0, -0.3]
    sinks = (rows[-1][1] - rows[3][1]) / (rows[-1][0] - rows[3][0])
    assert 0.25 < sinks < 0.7, f"a coin flutters down, not at {sinks} m/s"  # on edge it would fall at about 1 m/s
    assert 1.99 < depth < 2 and 3 < seconds < 8, "it lies flat on the bottom"


def car():
    seconds, flying, high = zip(*numbers("car"))
    assert flying[3] == flying[4] == 0 and max(high[2:5]) < 0.1, "leaves lie on the road until it comes, 3 s after the start"
    passing = range(5, 8)
    assert max(flying[i] for i in passing) > 40 and 0.3 < max(high[i] for i in passing) < 3, "it tosses them up, not away"
    assert flying[-1] == 0 and high[-1] < 0.1, "they lie again"


def fountain():
    _, high, far = zip(*numbers("fountain"))
    assert all(1.5 < h < 4 for h in high), "the jet carries petals up"
    assert all(0.1 < b - a < 0.5 for a, b in zip(far, far[1:])), "the water carries them away, 0.25 m in 2.5 s"


def texts():
    sources = {path.name: path.read_text(encoding="utf-8") for path in (ROOT / "samples/small").glob("*.cpp")}
    assert sorted(sources) == ["car.cpp", "coin.cpp", "confetti.cpp", "dart.cpp", "fountain.cpp", "leaves.cpp"]
    for name, text in sources.items():
        lines = text.splitlines()
        assert len(lines) <= 20 and max(map(len, lines)) <= 120, f"{name} is too large"
    tutorial = (ROOT / "docs/guide/tutorial.md").read_text(encoding="utf-8")
    whole = re.findall(r"^```cpp\n(.*?)^```$", tutorial, re.M | re.S)
    assert whole == [sources[f"{name}.cpp"] for name in ("leaves", "dart", "confetti", "coin")], "the tutorial quotes other programs"
    for quote in re.findall(r"^```cpp\n(.*?)^```$", (ROOT / "docs/guide/recipes.md").read_text(encoding="utf-8"), re.M | re.S):
        assert any(quote in text for text in sources.values()), f"recipes.md quotes what is in no program:\n{quote}"
    return "".join(re.findall(r"^```c\n(.*?)^```$", tutorial, re.M | re.S))


def written(text):
    """The numbers that a program in C prints, compiled by the tutorial's line. It finds baked bodies where the pages have them."""
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        (work / "park.c").write_text(text, encoding="utf-8")
        for name in ("assets", "demo"):
            (work / name).symlink_to(BUILD.resolve() / "viewer_assets")
        (work / "leaf.lrb").symlink_to(BUILD.resolve() / "viewer_assets/leaf.lrb")
        subprocess.run(["cc", "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "park.c", f"-I{PREFIX}/include", f"-L{PREFIX}/lib",
                        "-llangevin_rigid", f"-Wl,-rpath,{PREFIX}/lib", "-o", "park"], cwd=work, check=True)
        return numbers(work / "park", cwd=work)


def first_programs():
    """Those of README.md and of the API reference."""
    def program(page):
        return written(re.search(r"^```c\n(.*?)^```$", (ROOT / page).read_text(encoding="utf-8"), re.M | re.S)[1])

    assert -1.2 < program("README.md")[0][1] < -0.7
    program("scripts/api_reference/main.md")


def park(text):
    """The tutorial's program in C."""
    seconds, count, awake, landed = zip(*written(text))
    assert seconds == (5, 10, 15, 20, 25, 25.5, 30) and count[:3] == (500, 1000, 1500)
    assert awake[4] < 75 and landed[4] > 1400, "nearly all lie, asleep"
    assert awake[5] > 400, "the gale wakes them"


# Declarations that the pages' fragments of C expect. Each desc was set up by its macro.
GIVEN = """#include <langevin_rigid.h>
#include <stdio.h>
static lr_world* world;
static lr_batch batch, leaves;
static lr_body leaf;
static lr_collider broom_id;
static lr_wind_source jet_id;
static lr_world_desc desc;
static lr_batch_rules rules;
static lr_batch_view view;
static lr_blower_desc jet;
static lr_body_force blast;
static lr_collider_motion broom;
static struct { uint64_t revision; uint32_t awake; void* memory; } store, *buffer = &store;
static struct { void* memory; uint64_t size; } slot[8];
static float dt, distance, x;
static int frame, late, now, n = 8, engine;
static uint32_t engine_threads;
uint32_t max(uint32_t a, uint32_t b);
void save(int f);
void apply_inputs(int f);
void* enqueue(void* user, lr_task_fn run, void* task, uint32_t count);
void finish(void* user, void* token);
"""


def fragments():
    """The pages' fragments of C compile, each within a function; functions in them before it."""
    with tempfile.TemporaryDirectory() as folder:
        for page in ("guide/recipes", "guide/concepts", "reference/bodies", "reference/stepping", "reference/snapshots", "reference/wind_and_water"):
            text = (ROOT / f"docs/{page}.md").read_text(encoding="utf-8")
            for i, fragment in enumerate(re.findall(r"^```c\n(.*?)^```$", text, re.M | re.S)):
                functions = "".join(re.findall(r"^static .*?^}\n", fragment, re.M | re.S))
                source = pathlib.Path(folder) / f"{pathlib.Path(page).name}_{i}.c"
                source.write_text(f"{GIVEN}{functions}void use(void);\nvoid use(void) {{\n{fragment.replace(functions, '')}}}\n", encoding="utf-8")
                subprocess.run(["cc", "-std=c99", "-Wall", "-Wextra", "-Wno-unused", "-Werror", "-fsyntax-only", f"-I{PREFIX}/include", source], check=True)


def falls():
    """The speeds that docs/guide/recipes.md gives are those that lr_drop prints."""
    recipes = (ROOT / "docs/guide/recipes.md").read_text(encoding="utf-8")
    flat = " ".join(recipes.split())

    def dropped(asset, height):
        done = subprocess.run([PREFIX / "bin/lr_drop", asset, "--height", str(height), "--json", "/dev/stdout", "--quiet"],
                              capture_output=True, text=True, timeout=120, check=True)
        return json.loads(done.stdout)

    def stated(pattern, *values):
        found = re.search(pattern, flat)
        assert found, f"recipes.md no longer says {pattern}"
        for text, value in zip(found.groups(), values):
            step = 10.0 ** -len(text.partition(".")[2])
            assert abs(float(text) - value) < 0.6 * step, f"recipes.md says {found[0]}, lr_drop {values}"

    def mean(name):
        return dropped(BUILD / f"viewer_assets/{name}.lrb", 3)["terminal_speed"]["mean"]

    stated(r"descends at ([\d.]+) m/s, A7 paper at ([\d.]+), a petal of 1.2 cm at ([\d.]+), confetti at ([\d.]+\d)",
           mean("leaf"), mean("paper"), mean("petal"), mean("confetti"))
    across = dropped(BUILD / "viewer_assets/confetti.lrb", 5)["spin_across"]
    stated(r"turns over (\d+) times a second on average \(`lr_drop assets/confetti.lrb --height 5`\), one piece in twenty (\d+) times",
           across["mean"], across["p95"])
    seed = dropped(BUILD / "viewer_assets/samara.lrb", 10)["terminal_speed"]
    stated(r"([\d.]+) to ([\d.]+) m/s for this one \(`lr_drop samara.lrb --height 10`", seed["p5"], seed["p95"])
    with tempfile.TemporaryDirectory() as folder:
        for line in re.findall(r"^    lr_bake (ellipsoid .*)$", recipes, re.M):
            command, said = line.split("#")
            printed = subprocess.run([PREFIX / "bin/lr_bake", *command.split()], cwd=folder, check=True, capture_output=True, text=True).stdout
            assert said.strip() in printed, f"{line}: {printed}"


def names():
    """What the table of C# names is in its sources."""
    page = (ROOT / "docs/guide/languages.md").read_text(encoding="utf-8")
    table = re.search(r"^\| C \| C# \|\n(.*?)\n\n", page, re.M | re.S)[1]
    sources = set(re.findall(r"\w+", "".join(path.read_text(encoding="utf-8") for path in (ROOT / "bindings/csharp").rglob("*.cs"))))
    for row in table.splitlines():
        for word in re.findall(r"`([A-Z]\w{3,})[`(]", row.split("|")[2]):
            assert word in sources | {"ClearX", "ResetX"}, f"languages.md: C# has no {word}"


BUILD, ROOT, PREFIX = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
park(texts())
first_programs()
fragments()
names()
falls()
leaves()
dart()
confetti()
coin()
car()
fountain()
