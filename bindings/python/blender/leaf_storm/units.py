# SPDX-License-Identifier: MIT
"""Units: metres in the library, the scene's unit in Blender."""
import langevin_rigid as lr
import numpy as np


class Problem(Exception):
    """A mistake of the user, reported by operators and the command."""


def metres_per_unit(scene):
    settings = scene.unit_settings
    return settings.scale_length if settings.system != "NONE" else 1.0


def in_units(recording, metres):
    """A copy with lengths in Blender's units."""
    scaled = lr.Recording(recording.fps, recording.first_frame)
    scaled.frames = [frame._replace(position=frame.position / np.float32(metres), velocity=frame.velocity / np.float32(metres))
                     for frame in recording]
    return scaled
