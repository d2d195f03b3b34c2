# SPDX-License-Identifier: MIT
"""Runs the command:  blender -b [scene.blend] -P leaf_storm/__main__.py -- OPTIONS  (see command.py)."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from leaf_storm import command  # noqa: E402

command.start(sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else ["--help"])
