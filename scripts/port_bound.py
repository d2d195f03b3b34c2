#!/usr/bin/env python3
"""Lower bound of a substep's time from the processor's pipes.

    scripts/port_bound.py [BUILD [FOLDER]]      default: build/release, build/release/bench

lr_bench --trace records the instructions of one step; objdump names them; lr_bench --ports measures the cycles of each kind
without waiting. Writes FOLDER/ports.csv and FOLDER/mix.csv: for each row of VARIANTS, per vector of bodies and substep, the
instructions of each kind, the busiest pipes, and their cycles (the bound).
SPDX-License-Identifier: MIT"""
import collections
import csv
import os
import re
import subprocess
import sys
import tempfile

BODIES, SUBSTEPS = 64, 4
VARIANTS = [("langevin_rigid", model, "default", path, target, lanes) for target, lanes in (("avx2", 8), ("avx512", 16))
            for model in ("none", "langevin-speed", "aerodynamic") for path in ("diagonal", "full")]
VARIANTS += [("sketch", "langevin-speed", "rk4", "diagonal", "x86-64-v3", 8), ("sketch", "langevin-speed", "rk4", "diagonal", "native", 0)]

# Kind, start of the mnemonic, operation of ports.csv. The first match counts.
KINDS = [("fma", r"vfn?m(add|sub)", "fma"), ("multiply", r"vmul|vscalef", "mul"),
         ("divide", r"vdiv", "div"), ("root", r"vsqrt", "sqrt"),
         ("integer multiply", r"vpmul(u?dq|hu?w|l[wdq])", "vpmuludq"),
         ("convert, round", r"vcvt|vround|vrndscale|vgetexp|vgetmant|vreduce", "convert"),
         ("add, compare", r"vadd|vsub|vmin|vmax|vcmp|vh?addsub|vfpclass|vrange", "add"),
         ("shuffle, blend", r"vps[lr]ldq|vshuf|vperm|vpshuf|vp?unpck|vp?blend|vinsert|vextract|vpalign|valign|vp?broadcast|vmovs[lh]dup|"
                            r"vmovddup|vpinsr|vpextr|vpcompress|vpexpand", "shuffle"),
         ("shift", r"vp(sll|srl|sra|rol|ror)", "shift"),
         ("logic, integer", r"vp(and|or|xor|tern|add|sub|cmp|min|max|abs|sign|test|movm|movzx|movsx)|v(and|or|xor)n?p|vtest|"
                            r"vp?mov[dbwq]2m|vpmovm2", "logic")]
KINDS = [(kind, re.compile(begin), operation) for kind, begin, operation in KINDS]
MOVE = re.compile(r"v?p?mov(a|u|nt|dq|d$|q$|s[sd]$|hl|lh|dqa|dqu|[hl]p)")


def instructions(library):
    """address -> (mnemonic, operands)"""
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", library], check=True, capture_output=True, text=True).stdout
    out = {}
    for line in text.splitlines():
        found = re.match(r"\s+([0-9a-f]+):\t(?:\{\w+\} |bnd |notrack |rep[nz]* |lock )*(\S+)\s*([^#<]*)", line)
        if found:
            out[int(found[1], 16)] = (found[2], found[3].strip())
    return out


def classify(mnemonic, operands):
    """kind, operation (or None), bits, whether it loads, whether it stores"""
    bits = 512 if "%zmm" in operands else 256 if re.search("%[xy]mm", operands) else 0
    stores = operands.endswith(")") or re.search(r"\)\{%k\d\}$", operands) is not None
    memory = "(" in operands
    if not bits:
        return ("mask" if "%k" in operands else "scalar"), None, 0, memory and not stores, memory and stores
    for kind, begin, operation in KINDS:
        if begin.match(mnemonic):
            if memory and "broadcast" in mnemonic:
                return "load", None, bits, True, False
            return kind, operation, bits, memory and not stores, memory and stores
    if MOVE.match(mnemonic):
        if not memory:
            return "register move", None, bits, False, False
        return ("store" if stores else "load"), None, bits, not stores, stores
    return "other vector", "logic", bits, memory and not stores, memory and stores


def mix(trace, code, cost, vectors):
    kinds, pipes = collections.Counter(), collections.Counter()
    for address, count in trace.items():
        mnemonic, operands = code.get(address, ("?", ""))
        kind, operation, bits, loads, stores = classify(mnemonic, operands)
        count /= vectors
        kinds[kind] += count
        width = str(max(bits, 256))
        if operation:
            pipe = {"fma": "multiply", "mul": "multiply", "vpmuludq": "multiply", "div": "divide and root",
                    "sqrt": "divide and root", "add": "add", "convert": "add"}.get(operation, operation)
            pipes[pipe] += count * cost[width, operation]
            pipes["all vector pipes"] += count * cost[width, "mul+add"]
        if loads:
            pipes["loads"] += count * cost[width, "load"]
        if stores:
            pipes["stores"] += count * cost[width, "store"]
    return kinds, pipes


def main(build="build/release", folder="build/release/bench"):
    bench = os.path.join(build, "tests/bench/lr_bench/lr_bench")
    library = os.path.join(build, "src/liblangevin_rigid.so")
    os.makedirs(folder, exist_ok=True)
    ports = os.path.join(folder, "ports.csv")
    if subprocess.run([bench, "--ports", ports], check=False).returncode != 0:
        sys.exit("port_bound: this processor's pipes cannot be measured here (x86-64 with AVX2 only)")
    with open(ports, newline="", encoding="ascii") as file:
        cost = {(row["width"], row["operation"]): float(row["cycles"]) for row in csv.DictReader(file)}
    code = {"langevin_rigid": instructions(library), "sketch": instructions(bench)}
    rows = []
    with tempfile.TemporaryDirectory() as work:
        for subject, model, integrator, path, target, lanes in VARIANTS:
            name = f"{subject}/{model}/{integrator}/{path}/{target}/0/{BODIES}/{SUBSTEPS}"
            out = os.path.join(work, "trace.csv")
            if subprocess.run([bench, "--trace", name, "--out", out], check=False).returncode != 0:
                print(f"port_bound: not available: {name}", file=sys.stderr)
                continue
            with open(out, newline="", encoding="ascii") as file:
                trace = {int(row["address"], 16): int(row["count"]) for row in csv.DictReader(file)}
            if not lanes:
                wide = sum(n for address, n in trace.items() if "%zmm" in code[subject].get(address, ("", ""))[1])
                lanes = 16 if 2 * wide > sum(trace.values()) else 8
            kinds, pipes = mix(trace, code[subject], cost, BODIES // lanes * SUBSTEPS)
            bound = max(pipes, key=pipes.get)
            print(f"{name}: {sum(kinds.values()):.0f} instructions, at least {pipes[bound]:.0f} cycles a vector ({bound})")
            rows.append({"subject": subject, "model": model, "integrator": integrator, "path": path, "target": target, "lanes": lanes,
                         "instructions": f"{sum(kinds.values()):.1f}", "bound_cycles": f"{pipes[bound]:.1f}", "bound_by": bound,
                         **{f"n {kind}": f"{n:.1f}" for kind, n in kinds.items()},
                         **{f"t {pipe}": f"{t:.1f}" for pipe, t in pipes.items()}})
    columns = list(dict.fromkeys(key for row in rows for key in row))
    with open(os.path.join(folder, "mix.csv"), "w", newline="", encoding="ascii") as file:
        writer = csv.DictWriter(file, columns, restval="0.0")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main(*sys.argv[1:])
