#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The first falling bodies: the same program as samples/hello.c, with the same bits."""
import numpy as np

import langevin_rigid as lr

BODIES = 6

# The shape: a thin ellipsoid, 8 cm x 2 cm x 0.1 mm. Closed forms give its mass and added mass.
leaf = lr.Asset.ellipsoid(semi_axes=(0.04, 0.01, 0.00005), density=800.0)

# A world with still air, gravity along -y, and a batch: all bodies of one asset.
with lr.World(seed=1) as world:
    batch = world.create_batch(leaf, capacity=BODIES)

    # The thin axis (body z) points up, then tilts a little more from leaf to leaf.
    index = np.arange(BODIES, dtype=np.float32)
    zero, one = np.zeros_like(index), np.ones_like(index)
    start = np.stack([np.float32(0.5) * index, 10 * one, zero], axis=-1)
    ids = batch.create(position=start, orientation=np.stack([-one, np.float32(0.15) * index, zero, one], axis=-1))

    # Two seconds of frames. A renderer would copy the transforms into its instance buffer after each.
    transforms = np.empty((BODIES, 3, 4), np.float32)
    for _ in range(120):
        world.step(np.float32(1) / np.float32(60), substeps=4)
        batch.transforms(lr.TransformFormat.MATRIX_3X4_ROW_MAJOR, out=transforms)

    print("leaf  fallen m  aside m  speed down m/s  spin y rad/s")
    for i, body in enumerate(ids):
        state = world.state(body)
        moved = state.position - start[i]
        print(f"{i:4}  {-moved[1]:8.3f}  {moved[0]:7.3f}  {-state.linear_velocity[1]:14.3f}  {state.angular_velocity[1]:12.2f}")
    print(f"state {world.hash():016x} after 2 s")
