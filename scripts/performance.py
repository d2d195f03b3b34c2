#!/usr/bin/env python3
"""Writes docs/maintainers/performance.md and docs/maintainers/performance.png from the measurements in a folder.

    /usr/bin/python3 scripts/performance.py [FOLDER [DOCS]]      default: build/release/bench, docs/maintainers

Needs rows.csv (lr_bench --csv); scenes.csv (bench_scene --csv), heaps.csv (bench_heap --csv), ports.csv, mix.csv (scripts/port_bound.py) and instructions.csv
(scripts/count_instructions.sh) are optional. Computes all verdicts.
SPDX-License-Identifier: MIT"""
import csv
import os
import subprocess
import sys

COUNTS = (1, 1000, 10000, 100000, 1000000)
MODELS = {"none": "none", "langevin-speed": "LANGEVIN, speed", "langevin-age": "LANGEVIN, age", "aerodynamic": "AERODYNAMIC"}


def read(folder, name):
    path = os.path.join(folder, name)
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="ascii") as file:
        return list(csv.DictReader(file))


class Rows:
    def __init__(self, rows):
        self.all = rows
        self.ours = [row for row in rows if row["subject"] == "langevin_rigid"]
        self.targets = list(dict.fromkeys(row["target"] for row in self.ours))
        self.best = self.targets[0]

    def find(self, model="langevin-speed", path="diagonal", target=None, bodies=10000, substeps=4, workers=0,
             integrator="default", subject="langevin_rigid"):
        want = {"subject": subject, "model": model, "path": path, "target": target or self.best, "bodies": str(bodies),
                "substeps": str(substeps), "workers": str(workers), "integrator": integrator}
        return next((row for row in self.all if all(row[key] == value for key, value in want.items())), None)

    def sketch(self, target="native", **more):
        return self.find(subject="sketch", integrator="rk4", target=target, **more)


def cpu(row):
    return float(row["cpu_ns"])


def wall(row):
    return float(row["wall_ns"])


def number(value, digits=3):
    value = float(value)
    if value >= 10 ** digits:
        return f"{value:,.0f}"
    return f"{value:.{digits}g}" if value < 1 else f"{value:.{max(0, digits - len(str(int(value))))}f}"


def table(head, lines):
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] +
                     ["| " + " | ".join(str(cell) for cell in line) + " |" for line in lines]) + "\n"


def goals(rows, mix):
    """(goal, measured, verdict) for each goal whose rows exist."""
    out = []

    def add(goal, limit, value, text, at_least=False):
        holds = value >= limit if at_least else value <= limit
        out.append((goal, text, "reached" if holds else f"**missed**, {number(abs(value / limit - 1) * 100, 2)} % off"))

    def ratio(goal, limit, above, below, at_least=False, of=cpu):
        if above and below:
            value = of(above) / of(below)
            text = f"{value:.2f} ({number(of(above))} / {number(of(below))} ns)"
            if of is wall:
                text += f"; best rounds {float(above['wall_ns_least']) / float(below['wall_ns_least']):.2f}"
            add(goal, limit, value, text, at_least)

    middle = 10000 if rows.find(target="avx2", bodies=10000) or not rows.find(target="avx2", bodies=1000) else 1000
    main = rows.find()
    if main and main["speed_over_sketch"]:
        add(f"LANGEVIN at least 1.5 times as fast as the sketch ({rows.best}, 10k bodies, 4 substeps)", 1.5,
            float(main["speed_over_sketch"]), f"{float(main['speed_over_sketch']):.2f} "
            f"({number(cpu(rows.sketch()))} / {number(cpu(main))} ns)", True)
    ratio("AERODYNAMIC at most 1.6 times LANGEVIN", 1.6, rows.find("aerodynamic"), main)
    for model in ("langevin-speed", "aerodynamic"):
        ratio(f"Full 6x6 at most 1.5 times diagonal, {MODELS[model]}", 1.5, rows.find(model, "full"), rows.find(model))
    ratio("A sheet at most 1.05 times a diagonal body, AERODYNAMIC", 1.05, rows.find("aerodynamic", "sheet"), rows.find("aerodynamic"))
    for model in ("langevin-speed", "aerodynamic"):
        wide, narrow = rows.find(model, target="avx512", bodies=middle), rows.find(model, target="avx2", bodies=middle)
        ratio(f"AVX2 at least 60 % of the speed of AVX-512, {MODELS[model]}", 0.6, wide, narrow, True)
    ratio("One substep a step at most 1.2 times the cost of four, a body-step", 1.2, rows.find(substeps=1), main)
    flat = [row for row in (rows.find(bodies=n) for n in COUNTS[1:]) if row]
    if len(flat) > 1:
        ratio(f"Flat from {int(flat[0]['bodies']):,} to {int(flat[-1]['bodies']):,} bodies, costliest over cheapest", 1.25,
              max(flat, key=cpu), min(flat, key=cpu))
    one = rows.find(bodies=1, substeps=1, target="auto")
    if one:
        add("One body alone at most 150 ns a step", 150, cpu(one), f"{number(cpu(one))} ns")
    for n, limit in ((1000000, 1.9), (100000, 1.9), (1000, 0.95)):
        alone, two = rows.find(bodies=n), rows.find(bodies=n, workers=1)
        ratio(f"Two threads at least {limit} times as fast as one, {n:,} bodies", limit, alone, two, True, wall)
    two = rows.find(bodies=1000000, workers=1)
    if two:
        rate = 1000.0 / wall(two)
        add("1,000,000 bodies x 4 substeps x 60 Hz on two threads: 240 million body-steps/s", 240, rate,
            f"{rate:.0f} million/s, best round {1000.0 / float(two['wall_ns_least']):.0f}", True)
    for model, limit, handles in (("langevin-speed", 64, 20), ("aerodynamic", 128, 0)):
        few, many = rows.find(model, bodies=100000), rows.find(model, bodies=1000000)
        if few and many:
            bytes_ = (float(many["memory_bytes_per_body"]) * 1e6 - float(few["memory_bytes_per_body"]) * 1e5) / 9e5 - handles
            what = "of state a body, without the 20 of its handle" if handles else "a body in all"
            add(f"At most {limit} bytes {what}, {MODELS[model]}", limit, round(bytes_, 1), f"{bytes_:.0f}")
    for row in rows.all:
        if row["subject"] == "transforms":
            copy = next(r for r in rows.all if r["subject"] == "memcpy" and (r["path"], r["bodies"]) == (row["path"], row["bodies"]))
            size = 16 * int(row["path"][0])
            add(f"Transforms at 70 % of the speed of memcpy, {row['path']}, {int(row['bodies']):,} bodies", 0.7, cpu(copy) / cpu(row),
                f"{100 * cpu(copy) / cpu(row):.0f} % ({number(size / cpu(row))} / {number(size / cpu(copy))} GB/s)", True)
    for share, name in bounds(rows, mix):
        if name[:2] == (MODELS["langevin-speed"], "diagonal"):
            add(f"At least 60 % of the bound by the pipes, LANGEVIN, {name[2]}", 0.6, share, f"{100 * share:.0f} %", True)
    return out


# Rows of bench_scene: what is in them, and the goal in ns.
SCENES = {
    "still": ("bare flight", 32), "uniform": ("uniform wind", 32), "gusts": ("and gusts", 33),
    "turbulence": ("gusts and turbulence", 36), "octaves": ("gusts and turbulence of two octaves", None),
    "ground": ("gusts and a ground profile", None), "wind": ("gusts, turbulence of two octaves, ground profile, four vortices", 40),
    "grid": ("a velocity grid of two frames", 40), "far-sources": ("gusts and 60 vortices out of reach", None), "callback": ("a wind callback", None),
    "heightfield": ("a heightfield", 34), "solids": ("a heightfield and 98 colliders", 36), "rules": ("rules, one volume", None),
    "eight-volumes": ("rules, eight volumes", None), "batch-force": ("a force on the batch", None), "body-forces": ("a force on each body", None),
    "events": ("rules and events", None), "transforms": ("transforms written", None),
    "park": ("a park: uniform wind, gusts, turbulence of two octaves, ground profile, heightfield, 98 colliders, rules", 42),
    "park-seen": ("the park, events and transforms", 47)}


def scene_section(scenes):
    lines = []
    for row in scenes:
        if row["subject"] == "clock":
            continue
        ours = row["subject"] == "langevin_rigid"
        what, wanted = SCENES.get(row["path"] if ours else None, ("gravity and drag alone", None))
        two = row["workers"] != "0"
        time = wall(row) if two else cpu(row)
        name = row["path"] if ours else row["subject"]
        goal = 16.7 if two and row["bodies"] == "1000000" else wanted if not two and row["bodies"] == "100000" else None
        lines.append([name, what, f"{int(row['bodies']):,}", "2" if two else "1", number(time), goal or "",
                      "" if goal is None else "reached" if time <= goal else f"{time / goal:.2f} times", f"`{row['hash']}`" if row["hash"] else ""])
    return SCENE_TEXT + table(["row", "scene", "bodies", "threads", "ns", "goal", "", "hash"], lines)


# Goals of bench_heap, us an awake body and substep of one thread.
HEAPS = {("heap", "landing"): 2.5, ("heap", "settling"): 3, ("heap", "gust"): 3, ("layers", "landing"): 3, ("layers", "settling"): 3, ("layers", "gust"): 3}


def heap_section(heaps):
    times, ends = [], []
    for row in heaps:
        place = [row["scene"], row["phase"], f"{int(row['bodies']):,}", row["threads"]]
        if float(row["us"] or 0) > 0 and row["phase"] != "lying":
            goal = HEAPS.get((row["scene"], row["phase"]), "") if row["threads"] == "1" else ""
            times.append([*place, f"{float(row['awake']):,.0f}", number(float(row["wall_ms"])), number(float(row["wall_ms_worst"])),
                          number(float(row["us"])), goal, row["over_flight"], "" if row["scene"] == "bullet" else f"`{row['hash']}`"])
        if row["overlaps"] and row["threads"] == "1":
            ends.append([row["scene"], row["phase"], row["overlaps"], row["depth_mm"], row["depth_99_mm"], f"{100 * float(row['share_deep']):.2f}", row["height_mm"],
                         row["height_95_mm"], row["awake_then"], row["tremor_mm"]])
    return HEAP_TEXT + table(["scene", "phase", "bodies", "threads", "awake", "ms a step", "worst", "us", "goal", "over flight", "hash"], times) + "\n" + \
        table(["scene", "after", "overlaps a body", "median, mm", "99 %, mm", "deep, %", "mean height, mm", "95 %, mm", "awake", "tremor, mm"], ends)


def bounds(rows, mix):
    for m in mix:
        for bodies in (10000, 1000):
            row = rows.find(m["model"], m["path"], m["target"], bodies, subject=m["subject"], integrator=m["integrator"])
            if row:
                yield float(m["bound_cycles"]) / (float(row["cycles"]) * int(m["lanes"])), variant(m)
                break


def variant(m):
    return (MODELS[m["model"]] if m["subject"] == "langevin_rigid" else m["subject"], m["path"], m["target"])


def machine():
    try:
        text = subprocess.run(["lscpu"], capture_output=True, text=True, env={**os.environ, "LC_ALL": "C"}, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return []
    wanted = ("Model name", "CPU family", "Model", "CPU(s)", "Thread(s) per core", "L1d cache", "L2 cache", "L3 cache", "Hypervisor vendor")
    facts = dict(line.split(":", 1) for line in text.splitlines() if ":" in line)
    return [(key, facts[key].strip()) for key in wanted if key in facts]


def plot(rows, path):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    best = {"avx512": "AVX-512", "avx2": "AVX2"}.get(rows.best, rows.best)
    lines = [(f"LANGEVIN, {best}, 2 threads (wall)", "#0b3c8c", "--", rows.ours, {"model": "langevin-speed", "workers": "1", "target": rows.best}),
             (f"LANGEVIN, {best}", "#0b3c8c", "-", rows.ours, {"model": "langevin-speed", "workers": "0", "target": rows.best}),
             ("LANGEVIN, AVX2", "#5a9bd4", "-", rows.ours, {"model": "langevin-speed", "workers": "0", "target": "avx2"}),
             (f"AERODYNAMIC, {best}", "#1b7f3b", "-", rows.ours, {"model": "aerodynamic", "workers": "0", "target": rows.best})]
    lines = [(*line[:4], {**line[4], "path": "diagonal", "integrator": "default", "substeps": "4"}) for line in lines]
    lines += [("sketch, native", "#444444", "-", rows.all, {"subject": "sketch", "target": "native", "substeps": "4"}),
              ("sketch, native without FMA", "#444444", ":", rows.all, {"subject": "sketch", "target": "native-no-fma", "substeps": "4"}),
              ("sketch, AVX2", "#999999", "-", rows.all, {"subject": "sketch", "target": "x86-64-v3", "substeps": "4"}),
              ("Bullet, drag only", "#b5651d", "-", rows.all, {"subject": "bullet"}), ("ODE, drag only", "#d4a017", "-", rows.all, {"subject": "ode"}),
              ("Eigen, Algorithm 2", "#8e44ad", "-", rows.all, {"subject": "eigen"}), ("scalar, Algorithm 2", "#c39bd3", "-", rows.all, {"subject": "scalar"}),
              ("MuJoCo, Euler", "#c0392b", "-", rows.all, {"subject": "mujoco", "integrator": "euler"}),
              ("MuJoCo, RK4", "#e57373", "-", rows.all, {"subject": "mujoco", "integrator": "rk4"})]
    figure, axes = pyplot.subplots(figsize=(11, 7), dpi=110)
    ends = []
    for label, color, style, source, want in lines:
        points = sorted((int(row["bodies"]), wall(row) if row["workers"] != "0" else cpu(row)) for row in source
                        if all(row[key] == value for key, value in want.items()))
        if points:
            axes.plot(*zip(*points), style, color=color, marker="o", markersize=4, linewidth=1.8)
            ends.append([points[-1][1], points[-1], label, color])
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(0.8, 200 * max(end[1][0] for end in ends))
    axes.set_xticks([10 ** k for k in range(7)], ["1", "10", "100", "1,000", "10,000", "100,000", "1,000,000"])
    # Labels at the lines' ends, moved apart if they would overlap in a column.
    low, high = axes.get_ylim()
    gap = (high / low) ** 0.034
    for column in {end[1][0] for end in ends}:
        here = sorted((end for end in ends if end[1][0] == column), key=lambda end: end[0])
        for before, after in zip(here, here[1:]):
            after[0] = max(after[0], before[0] * gap)
    for y, (x, exact), label, color in ends:
        axes.annotate(f"{label}: {number(exact)}", (x, exact), (x * 1.35, y), color=color, fontsize=9, va="center")
    axes.set_xlabel("bodies")
    axes.set_ylabel("ns a body and substep")
    axes.set_title("Cost of a body-step, processor time of one thread unless said otherwise", fontsize=11)
    axes.grid(True, which="major", alpha=0.35)
    axes.grid(True, which="minor", alpha=0.12)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    figure.tight_layout()
    figure.savefig(path)


def time_table(rows, wanted, head):
    """Table with all columns of the rows."""
    lines = []
    for row in wanted:
        ratio = row["speed_over_sketch"]
        bytes_ = number(row["memory_bytes_per_body"]) if row["memory_bytes_per_body"] and int(row["bodies"]) > 1 else ""
        lines.append([*(row[key] if key != "model" else MODELS.get(row[key], row[key]) for key in head),
                      number(wall(row)), number(row["wall_ns_least"]), number(cpu(row)), number(row["cpu_ns_least"]), number(row["cycles"]),
                      f"{float(ratio):.2f}" if ratio else "", bytes_, f"`{row['hash']}`" if row["hash"] else ""])
    return table([*head, "wall", "least", "CPU", "least", "cycles", "x sketch", "bytes", "hash"], lines)


def sections(rows, scenes, heaps, ports, mix, instructions):
    if scenes:
        yield "Scenes", scene_section(scenes)
    if heaps:
        yield "Heaps", heap_section(heaps)
    by_count = [row for n in COUNTS for row in rows.ours if row["bodies"] == str(n) and row["target"] == rows.best and
                row["integrator"] == "default" and row["model"] in ("langevin-speed", "aerodynamic") and
                (row["substeps"] == "4" and n != 1 or row["workers"] == "0")]
    by_count.sort(key=lambda row: [-len(row["model"]), row["path"]] + [int(row[key]) for key in ("bodies", "substeps", "workers")])
    yield "Number of bodies, substeps, threads", time_table(rows, by_count, ["model", "path", "bodies", "substeps", "workers"])
    middle = "10000" if any(row["bodies"] == "10000" and row["integrator"] == "rk4" for row in rows.ours) else "1000"
    rest = [row for row in rows.ours if row["bodies"] == middle and row["substeps"] == "4" and row["workers"] == "0"]
    yield "Other models and integrators", time_table(
        rows, [row for row in rest if row["target"] == rows.best and row not in by_count], ["model", "integrator", "path", "bodies"])
    narrow = [row for row in rest if row["target"] != rows.best and row["integrator"] == "default" and
              row["model"] in ("langevin-speed", "aerodynamic")]
    yield "Other instruction sets", time_table(rows, narrow, ["model", "path", "target", "bodies"])
    others = [row for row in rows.all if row["subject"] not in ("langevin_rigid", "clock", "transforms", "memcpy") and
              (row["bodies"] == middle or row["subject"] == "mujoco" or row["subject"] == "sketch" and row["target"] == "native" and row["substeps"] == "4")]
    yield "The sketch and peers", PEERS + time_table(rows, others, ["subject", "model", "integrator", "target", "bodies", "substeps"])
    if instructions:
        lines = []
        for row in instructions:
            words = row["row"].split("/")
            name = f"{words[0]}, {MODELS.get(words[1], words[1])}, {words[2]}, {words[3]}, {words[7]} substep{'s' * (words[7] != '1')}"
            if row["function"] == "all":
                lines.append([name, number(row["instructions"], 4)])
        yield "Instructions", INSTRUCTIONS + table(["row", "instructions a body-step"], lines)
    if ports and mix:
        yield "Bound by the pipes", bound_section(rows, ports, mix)


def bound_section(rows, ports, mix):
    widths = sorted({row["width"] for row in ports})
    operations = list(dict.fromkeys(row["operation"] for row in ports))
    cost = {(row["width"], row["operation"]): float(row["cycles"]) for row in ports}
    text = BOUND + table(["cycles an instruction", *operations],
                         [[f"{w} bits", *(f"{cost[w, o]:.2f}" for o in operations)] for w in widths])
    if "512" in widths:
        twice = cost["512", "mul+add"] / cost["256", "mul+add"]
        text += f"\nAn instruction of 512 bits takes {twice:.1f} times as long as one of 256 here" + \
                (": the pipes are 512 bits wide.\n" if twice < 1.5 else ": it is split in two.\n")
    kinds = [key for key in mix[0] if key.startswith("n ")]
    shares = {name: share for share, name in bounds(rows, mix)}
    head = ["model", "path", "target", "instructions", *(kind[2:] for kind in kinds)]
    text += "\nInstructions a vector and substep:\n\n" + table(head, [
        [*variant(m), number(m["instructions"], 4), *(f"{float(m[kind]):.0f}" for kind in kinds)] for m in mix])
    pipes = [key for key in mix[0] if key.startswith("t ")]
    lines = []
    for m in mix:
        share = shares.get(variant(m))
        bound = float(m["bound_cycles"])
        lines.append([*variant(m), *(f"{float(m[pipe]):.0f}" for pipe in pipes), f"{bound:.0f}",
                      f"{bound / share:.0f}" if share else "", f"{float(m['instructions']) * share / bound:.2f}" if share else "",
                      f"{100 * share:.0f} %" if share else ""])
    return text + "\nCycles a vector and substep that each kind of pipe needs, the largest of them (the bound), and what was measured:\n\n" + \
        table(["model", "path", "target", *(pipe[2:] for pipe in pipes), "bound", "measured", "instructions a cycle", "reached / bound"], lines)


HEAD = """# Performance

This page is for engineers who make the library faster, or compare it: the speed of the kernel beside its goals and beside other engines, and the
optimisations that were tried. `scripts/performance.py` writes everything before "Optimisations" from measurements:

    scripts/setup.sh bench                       # peers, valgrind, matplotlib; all of them optional
    cmake --preset release && cmake --build build/release --target lr_bench bench_scene bench_heap
    scripts/performance.sh                       # about 6 minutes; --quick: 1 minute

Times are ns per body and substep of 1/240 s, through the C API and the shared library as it ships. The body is the paper's leaf, an ellipsoid of 8 cm
x 2 cm x 0.1 mm in air. The weight of a *sheet* is off centre; on the full path its loads are too. All rows of a run exist at once and are timed in
turns, a burst of 2 ms or one step each, {rounds} rounds; the tables give the median and the least.

- *wall* is elapsed time, *CPU* the processor time of the process, which other processes do not lengthen. Ratios and verdicts are of CPU medians with
  one thread, of wall medians with two.
- *cycles*: CPU time over that of an addition that waits for the one before it, timed right after each burst.
- *x sketch*: speed relative to the first sketch (native) with as many bodies and substeps, median of the rounds' ratios.
- *workers*: threads besides the caller's. *bytes*: all memory of the world per body.
- *hash*: `lr_world_hash` after the first four steps; equal for equal scenes, whatever the instruction set and the workers.

All rows: `build/release/bench/rows.csv`.
"""
PEERS = """Each runs in the same process and the same turns, on one thread, with denormals flushed.

- **sketch**: `tests/bench/peers/sketch_step-inl.h`: RK4, LANGEVIN with the SPEED clock, six Gaussians by Philox and Box-Muller, diagonal, fused
  multiply-adds; compiled with `-O3 -march=native`, also without fused multiply-adds, and as x86-64-v3.
- **scalar**, **eigen**: Algorithm 2 of the paper with the equations of [physics.md](physics.md), 3 and 4: RK4, `std::normal_distribution`; plain C++
  and Eigen, single precision, compiled like the library. Both descend at 0.70 m/s and spin at 32 rad/s on average, the library at 0.69 to 0.71 and
  33.
- **bullet**: gravity, quadratic drag, and Bullet's own integration of rigid bodies; no broad phase, contacts, islands or fluid.
- **ode**: gravity, quadratic drag, `dWorldQuickStep` without geometry. No fluid.
- **mujoco**: free ellipsoids in its ellipsoid fluid model, without contacts, constraints and noise. This version computes fluid forces through a
  dense Jacobian, so the cost of a body grows with the bodies of a model, and the fair rows are those with few.

"""
SCENE_TEXT = """`bench_scene`: flat leaves of 7 x 4 cm, 0.2 mm, 0.1 g, their weight off centre, AERODYNAMIC loads, a step of 1/60 s with one substep, a body in 0.5
m^3. Medians of processor time with one thread, of wall time with two. Bullet and ODE: as many bodies under gravity and drag alone, without fluid,
wind and colliders.

"""
BY_HAND = "## Optimisations"
INSTRUCTIONS = """Counted by callgrind under AVX2 (8 bodies in a vector) with 1024 bodies: `scripts/count_instructions.sh`, which also counts single functions.

"""
BOUND = """`scripts/port_bound.py` follows one step (64 bodies, 4 substeps) instruction by instruction. It assigns each to the pipe that takes it, with the
cycles that it takes there without waiting, measured by `lr_bench --ports`. Multiplications and additions have two pipes each; divisions and roots
share a unit beside them; all together can start four instructions per cycle. The rest of the time is waiting: chains of instructions that need each
other's results.

"""


HEAP_TEXT = """`bench_heap`: plates of 70 x 40 x 0.4 mm, 0.18 g, friction 0.5, AERODYNAMIC loads, steps of 1/60 s with two substeps. Median and worst wall time of a
step; us of CPU time for each awake body and substep. Overlaps are found by separating axes. *overlaps*: pairs deeper than 0.1 mm; *median*, *99 %*:
depths of pairs deeper than 0.01 mm; *deep*: bodies more than their thickness within another; *tremor*: the largest displacement of any corner in the
second after. Scene `bullet`: the heap by Bullet, without air but a drag. Its plates have 4 mm, since thinner ones pass through each other; it does
not come to rest.

"""


def main(folder="build/release/bench", docs="docs/maintainers"):
    rows = Rows(read(folder, "rows.csv"))
    scenes, heaps, ports, mix, instructions = (read(folder, name + ".csv") for name in ("scenes", "heaps", "ports", "mix", "instructions"))
    text = HEAD.format(rounds=rows.all[0]["rounds"])
    clock = next(row for row in rows.all if row["subject"] == "clock")
    alone = sorted(wall(row) / cpu(row) for row in rows.all if row["workers"] == "0")
    busy = alone[len(alone) * 9 // 10]
    text += "\n## Machine\n\n" + table(["", ""], [
        *machine(), ("Clock, as measured", f"{1 / cpu(clock):.2f} GHz"),
        ("Wall over CPU time, one thread", f"{busy:.2f} in the ninth decile of the rows: " +
         ("nothing else ran" if busy < 1.05 else "**other processes ran**, which times of two threads suffer from"))])
    text += "\n## Goals\n\n" + table(["goal", "measured", "verdict"], goals(rows, mix))
    text += "\n![ns a body-step over the number of bodies](performance.png)\n"
    for title, body in sections(rows, scenes, heaps, ports, mix, instructions):
        text += f"\n## {title}\n\n{body}"
    plot(rows, os.path.join(docs, "performance.png"))
    page = os.path.join(docs, "performance.md")
    if os.path.exists(page):  # keeps the part written by hand
        with open(page, encoding="utf-8") as file:
            old = file.read()
        text += "\n" + old[old.index(BY_HAND):] if BY_HAND in old else ""
    with open(page, "w", encoding="utf-8") as file:
        file.write(text)
    for goal in goals(rows, mix):
        print(": ".join(goal).replace("**", ""))


if __name__ == "__main__":
    main(*sys.argv[1:])
