# SPDX-License-Identifier: MIT
"""What generators share: where they read, and that with --check they write nothing, and fail where a file is not what they would write."""
import argparse
import difflib
import pathlib
import sys

import api_model

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(doc, files, target="x86_64-unknown-linux-gnu", owned=None):
    """files(model): {path in the tree: text}. owned: a pattern of paths, of which there are no others. Returns whether all is as it should be."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing, and fail where a file differs")
    parser.add_argument("--header", type=pathlib.Path, default=api_model.HEADER)
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="of the tree that is written to")
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
            print(f"{name}: not what the header says: run bindings/generator/all.py", file=sys.stderr)
        elif text is None:
            path.unlink()
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
    return not (options.check and stale)
