# SPDX-License-Identifier: MIT
"""Shared by tests."""
import os
import pathlib
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
PREFIX = pathlib.Path(os.environ.get("LR_TEST_PREFIX", "/usr/local"))
WORK = pathlib.Path(os.environ.get("LR_TEST_WORK") or tempfile.mkdtemp(prefix="langevin_rigid_test_"))
WORK.mkdir(parents=True, exist_ok=True)
if "LR_TEST_INSTALLED" not in os.environ:
    sys.path.insert(0, str(HERE.parent))

import langevin_rigid as lr  # noqa: E402


def thin_leaf():
    """The ellipsoid of samples/hello.c."""
    return lr.Asset.ellipsoid(semi_axes=(0.04, 0.01, 0.00005), density=800.0)


class WorldCase(unittest.TestCase):
    """A world with one batch of leaves."""

    capacity = 64

    def setUp(self):
        self.world = lr.World(seed=3)
        self.batch = self.world.create_batch(thin_leaf(), self.capacity)

    def tearDown(self):
        self.world.close()

    def fall(self, steps=1):
        for _ in range(steps):
            self.world.step(1 / 60, 2)
