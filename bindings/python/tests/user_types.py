# SPDX-License-Identifier: MIT
"""A user's program, which test.sh checks by `mypy --strict` and pyright against the installed package. It is not run."""
from __future__ import annotations

import langevin_rigid as lr
import numpy as np
from langevin_rigid.export import read_pc2, write_carrier_pc2, write_usda
from langevin_rigid.mesh import Mesh


def swirl(query: lr.WindQuery) -> None:
    x, y, z = query.position
    query.velocity = (-z, 0 * y, x)


def main() -> int:
    report = lr.bake("leaf.obj", "leaf.lrb", density=350)
    print(report["mass"], lr.version(), lr.__version__, lr.library_path())
    try:
        leaf = lr.Asset.load("leaf.lrb")
    except lr.AssetFormatError as error:
        for fault in error.faults:
            print(fault.number, fault.what)
        return 1
    except lr.Error as error:
        print(error.status)
        return 1
    with lr.World(seed=1, gravity=(0, -9.81, 0), worker_count=3) as world:
        world.set_uniform_wind((3, 0, 0))
        gusts: lr.WindSource = world.add_gusts(rms=2, direction=(1, 0, 0))
        gusts.update(rms=3)
        world.add_vortex(position=(0, 0, 0), circulation=2.0, core=lr.VortexCore.RANKINE)
        world.add_wind_grid(samples=np.zeros((2, 2, 2, 3), np.float32))
        world.set_wind_callback(swirl)
        ground = world.add_plane(friction=0.7)
        ground.move_to((0, 1, 0))
        batch = world.create_batch(leaf, capacity=1000, load_model=lr.LoadModel.LANGEVIN)
        batch.set_emitter(shape=lr.EmitterShape.BOX, rate=3)
        batch.set_rules(max_age=3)
        ids = batch.create(position=np.random.default_rng(0).random((10, 3)) * 10)
        first = int(ids[0])
        state = world.state(first)
        print(state.position[0], state.scale)
        world.set_state(first, scale=2.0)
        world.set_water(position=(0, 1, 0))
        recording = lr.Recording(fps=60, first_frame=1)
        matrices = np.empty((1000, 4, 4), np.float32)
        for frame in range(10):
            world.step(1 / 60, substeps=2)
            batch.transforms(lr.TransformFormat.MATRIX_4X4_ROW_MAJOR, out=matrices)
            view = batch.view()
            print(frame, view.position.y.mean(), view.awake_count, view.ids[0])
            recording.capture(batch)
        linear, angular = batch.velocities()
        total: float = float(linear.sum() + angular.sum())
        world.keep_events()
        for event in world.events.events:
            print(event["kind"])
        hits = world.ray_cast((0, 1, 0), (0, -1, 0))
        print(hits["distance"], total, batch.counts.spawned, world.timings, batch.emitter)
        water = world.water
        if water is not None:
            print(water.position[1])
        data: bytes = world.save()
        world.restore(data)
        write_usda("a.usda", recording, Mesh.read_obj("leaf.obj").moved(-leaf.info.center_of_mass))
        cache = write_carrier_pc2("a.pc2", recording)
        start, rate, samples = read_pc2("a.pc2")
        print(cache.vertices, start, rate, samples.shape)
    return 0


main()
