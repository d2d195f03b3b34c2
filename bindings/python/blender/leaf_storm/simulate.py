# SPDX-License-Identifier: MIT
"""Steps a world in the frames of a scene."""
import math
import os

import langevin_rigid as lr
import numpy as np

from .colliders import Colliders
from .units import Problem, metres_per_unit
from .wind import Wind


class Settings:
    """Settings of a storm: lengths in Blender's units, speeds in m/s. colliders: mesh objects."""

    def __init__(self, **values):
        self.count, self.rate, self.lifetime, self.variation, self.seed = 300, 0.0, 0.0, 0.2, 0
        self.center, self.size = (0.0, 0.0, 3.0), (4.0, 4.0, 1.0)
        self.wind, self.gusts, self.turbulence = (0.0, 0.0, 0.0), 0.0, 0.3
        self.ground, self.ground_height, self.heaps, self.colliders, self.friction = True, 0.0, False, [], 0.6
        self.__dict__.update(values)


def simulate(scene, asset, settings, progress=lambda part: None):
    """Simulates the frames of a scene and returns a recording in metres."""
    metres = metres_per_unit(scene)
    fps = scene.render.fps / scene.render.fps_base
    first, last = scene.frame_start, scene.frame_end
    if last <= first:
        raise Problem("the scene has no frames")
    recording = lr.Recording(fps=fps, first_frame=first)
    was_at = scene.frame_current
    gravity = np.array(scene.gravity) * metres if scene.use_gravity else np.zeros(3)
    center = np.array(settings.center) * metres
    try:
        with lr.World(seed=settings.seed, gravity=gravity, worker_count=min((os.cpu_count() or 1) - 1, 64)) as world:
            scene.frame_set(first)
            if settings.ground:
                world.add_plane((0, 0, settings.ground_height * metres), (0, 0, 1), friction=settings.friction)
            moving = [Colliders(world, settings.colliders, metres, gravity, center, settings.friction),
                      Wind(world, scene, settings, metres)]
            batch = world.create_batch(asset, capacity=settings.count)
            batch.set_emitter(shape=lr.EmitterShape.BOX, position=center, size=np.array(settings.size) * metres / 2,
                              rate=settings.rate, scale_min=1 - settings.variation, scale_max=1 + settings.variation)
            if settings.lifetime > 0:
                batch.set_rules(max_age=settings.lifetime)
            if settings.heaps:
                batch.set_body_contact(batch)
            if settings.rate == 0:
                batch.emit(settings.count)
            substeps = max(1, math.ceil(120 / fps))
            for frame in range(first, last + 1):
                recording.capture(batch)
                if frame < last:
                    scene.frame_set(frame + 1)
                    for part in moving:
                        part.follow()
                    world.step(1 / fps, substeps)
                progress((frame - first + 1) / (last - first + 1))
    finally:
        scene.frame_set(was_at)
    return recording
