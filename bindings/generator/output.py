# SPDX-License-Identifier: MIT
"""Shared by generators: paths, and --check, which writes nothing and fails if a file is out of date."""
import argparse
import difflib
import pathlib
import sys

import api_model

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(doc, files, target="x86_64-unknown-linux-gnu", owned=None):
    """files(model): {path in the tree: text}. owned: a pattern of paths; a matching file that is not in files is an error. Returns success."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing, and fail if a file differs")
    parser.add_argument("--header", type=pathlib.Path, default=api_model.HEADER)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="root of the tree to write")
    options = parser.parse_args()
    texts = files(api_model.read(options.header, target))
    present = {str(path.relative_to(options.root)) for path in options.root.glob(owned)} if owned else set()
    texts.update({name: None for name in present - texts.keys()})
    stale = 0
    for name, text in texts.items():
        path = options.root / name
        old = path.read_text(encoding="utf-8") if path.exists() else None
        if old == text:
            continue
        stale += 1
        if options.check:
            lines = difflib.unified_diff((old or "").splitlines(True), (text or "").splitlines(True), name, "generated")
            sys.stderr.writelines(list(lines)[:40])
            print(f"{name}: out of date: run bindings/generator/all.py", file=sys.stderr)
        elif text is None:
            path.unlink()
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
    return not (options.check and stale)
