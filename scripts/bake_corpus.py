#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Bakes models that Debian packages, and counts how many bake: docs/maintainers/testing.md has the table.

    scripts/bake_corpus.py [--lr-bake PATH] [--most N] [--jobs N] [--only CORPUS] [--match TEXT] [PACKAGE...]

Fetches the packages into build/corpus with apt-get download; nothing is installed. Each bake has 60 s of processor time and 3 GB. A
model that is refused is baked again with the first option that the message names. --most N takes about N models of each
collection, evenly spread. Writes build/corpus/results.json and prints the table.
"""
import argparse
import collections
import concurrent.futures
import gzip
import hashlib
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import tarfile
import tempfile
import zipfile

LIMIT = argparse.Namespace(seconds=60)
ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = ROOT / "build/corpus"
MEMORY = 3 << 30
ENDINGS = {".obj", ".ply", ".stl", ".off", ".gltf", ".glb", ".fbx", ".dae", ".3ds", ".ac", ".x", ".3mf", ".lwo"}
PACKAGES = {  # collection: package
    "assimp test models": "assimp-testmodels",
    "CGAL data": "libcgal-demo",
    "Trigger Rally": "trigger-rally-data",
    "SweetHome3D furniture": "sweethome3d-furniture",
    "FlightGear models": "flightgear-data-models",
    "Cura printers": "cura",
    "Prusa printers": "prusa-slicer",
}
# The option that a message names, with a value where it needs one.
VALUES = {"--sheet": [], "--size": ["10cm"], "--unit": ["mm"], "--thickness": ["0.001"]}


def unpack(package):
    """The package's files, with archives inside it unpacked beside them."""
    folder = FOLDER / package
    if (folder / "done").exists():
        return folder
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["apt-get", "download", "-qq", package], cwd=folder, check=True)
    for archive in folder.glob("*.deb"):
        subprocess.run(["dpkg", "-x", archive, folder], check=True)
        archive.unlink()
    for path in sorted(folder.rglob("*")):
        if path.name.endswith(".tar.gz"):
            with tarfile.open(path) as archive:
                safe = {"filter": "data"} if hasattr(tarfile, "data_filter") else {}  # Python before 3.11.4 has none
                archive.extractall(path.parent / (path.name + ".d"), **safe)
        elif path.suffix == ".gz" and pathlib.Path(path.stem).suffix.lower() in ENDINGS:
            path.with_suffix("").write_bytes(gzip.decompress(path.read_bytes()))
        elif path.suffix in {".zip", ".sh3f"}:
            with zipfile.ZipFile(path) as archive:
                archive.extractall(path.parent / (path.name + ".d"))
    for path in sorted(folder.rglob("*.sh3f.d/*.sh3f")):  # a library of furniture inside one
        with zipfile.ZipFile(path) as archive:
            archive.extractall(path.parent)
    (folder / "done").touch()
    return folder


def models(folder, most):
    """One of each content, in an order that does not depend on names, so that every n-th is a fair choice."""
    found = {}
    for path in sorted(folder.rglob("*")):
        if path.suffix.lower() in ENDINGS and path.is_file():
            found.setdefault(hashlib.sha256(path.read_bytes()).hexdigest(), path)
    chosen = sorted(found)[:most] if most else sorted(found)
    return [found[key] for key in chosen]


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (LIMIT.seconds, LIMIT.seconds + 1))


def bake(command):
    """Exit code, messages, seconds of processor time, which other work on the machine does not change, and megabytes."""
    with tempfile.TemporaryFile() as errors:
        run = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=errors, preexec_fn=limit)
        _, status, usage = os.wait4(run.pid, 0)
        run.returncode = code = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        text = errors.read().decode(errors="replace")
    return "time" if code in {-signal.SIGXCPU, -signal.SIGKILL} else code, text, usage.ru_utime + usage.ru_stime, usage.ru_maxrss // 1024


def outcome(code, text):
    if code == 0:
        return "baked"
    if code == "time":
        return "too slow"
    if code != 1:
        return f"ended with {code}"
    found = re.search(r"error (\d+)", text)
    return f"error {found[1]}" if found else "error without a number"


def try_model(lr_bake, name, path):
    command = [lr_bake, "mesh", str(path), "-o", f"{FOLDER}/out/{hashlib.sha256(str(path).encode()).hexdigest()[:16]}.lrb"]
    code, text, seconds, megabytes = bake(command)
    lines = [re.sub(r"^.*?: (?=(error|warning) \d)", "", line) for line in text.splitlines() if re.search(r"(error|warning) \d", line)]
    result = {"collection": name, "path": str(path.relative_to(FOLDER)), "outcome": outcome(code, text), "seconds": round(seconds, 2), "megabytes": megabytes,
              "lines": lines}
    if code == 1:
        errors = " ".join(line for line in lines if line.startswith("error"))
        named = [option for option in re.findall(r"--[a-z]+(?:-[a-z]+)*", errors) if option in VALUES]
        if named:
            option = named[0]
            code, text, seconds, megabytes = bake(command + [option] + VALUES[option])
            if code == 2 and option == "--sheet":  # older releases need a thickness for a sheet
                code, text, seconds, megabytes = bake(command + [option, "--thickness", "0.001"])
            result |= {"option": option, "then": outcome(code, text), "seconds_then": round(seconds, 2),
                       "lines_then": [line for line in text.splitlines() if "error" in line]}
    return result


def table(results):
    rows = collections.defaultdict(list)
    for result in results:
        rows[result["collection"]].append(result)
        rows["all"].append(result)
    print("| collection | models | no surface | baked with no option | with the option named | slowest | most memory | refused |")
    print("|---|---|---|---|---|---|---|---|")
    order = [name for name in PACKAGES if name in rows] + ["all"]
    for name in order:
        row = rows[name]
        # A file without a face, or one that the reader of its format cannot read at all, tells nothing about meshes.
        usable = [r for r in row if r["outcome"] not in {"error 201", "error 202"}]
        first = [r for r in usable if r["outcome"] == "baked"]
        second = [r for r in usable if r["outcome"] == "baked" or r.get("then") == "baked"]
        reasons = collections.Counter(r["outcome"] for r in usable if r not in second)
        text = ", ".join(f"{count} {reason}" for reason, count in reasons.most_common())
        share = lambda part: f"{len(part)} ({100 * len(part) / max(1, len(usable)):.0f} %)"
        print(f"| {name} | {len(row)} | {len(row) - len(usable)} | {share(first)} | {share(second)} | "
              f"{max((r['seconds'] for r in row), default=0):.0f} s | {max((r['megabytes'] for r in row), default=0)} MB | {text} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packages", nargs="*", metavar="PACKAGE", help="other packages, instead of those of the table")
    parser.add_argument("--lr-bake", default=str(ROOT / "build/release/src/tools/lr_bake/lr_bake"))
    parser.add_argument("--most", type=int, default=0, help="models of each collection; 0: all")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", help="one collection")
    parser.add_argument("--match", default="", help="only paths with this text")
    parser.add_argument("--results", default=str(FOLDER / "results.json"))
    parser.add_argument("--again", help="takes from this file of results what it shows as baked, and bakes the rest")
    parser.add_argument("--seconds", type=int, default=60, help="of processor time for each bake")
    args = parser.parse_args()
    LIMIT.seconds = args.seconds
    (FOLDER / "out").mkdir(parents=True, exist_ok=True)
    work = []
    if args.packages:
        PACKAGES.clear()
        PACKAGES.update((package, package) for package in args.packages)
    for name, package in PACKAGES.items():
        if args.only in {None, name, package}:
            chosen = models(unpack(package), args.most)
            work += [(i, name, path) for i, path in enumerate(chosen) if args.match in str(path)]
    work = [(name, path) for _, name, path in sorted(work)]  # so that all collections have results early
    results = []
    if args.again:
        results = [r for r in json.loads(pathlib.Path(args.again).read_text()) if r["outcome"] == "baked"]
        done = {r["path"] for r in results}
        work = [(name, path) for name, path in work if str(path.relative_to(FOLDER)) not in done]
    total = len(results) + len(work)
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        for result in pool.map(lambda item: try_model(args.lr_bake, *item), work):
            results.append(result)
            pathlib.Path(args.results).write_text(json.dumps(results, indent=1))
            print(f"{len(results)}/{total} {result['outcome']}{' -> ' + result['then'] if 'then' in result else ''} "
                  f"{result['seconds']} s {result['path']}", file=sys.stderr, flush=True)
    table(results)


if __name__ == "__main__":
    main()
