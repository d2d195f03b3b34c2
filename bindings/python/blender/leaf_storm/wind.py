# SPDX-License-Identifier: MIT
"""The scene's force fields as wind. A field's strength counts as a speed in m/s, whatever the scene's unit is.

WIND        uniform, along the field's z axis; with a maximum distance or a falloff a jet from a nozzle of the field's size
VORTEX      about the field's z axis; the strength is the highest speed, at the field's size (its minimum distance, if used)
TURBULENCE  everywhere; the strength is the root mean square of each component, the field's Size the size of the eddies
"""
import math

import numpy as np

KINDS = ("WIND", "VORTEX", "TURBULENCE")
PEAK = 0.638  # a Lamb-Oseen vortex's highest speed, over circulation / (2 pi core radius); it lies at 1.12 core radii


def fields_of(scene):
    """Objects with force fields, as (those that become wind, the others)."""
    fields = [thing for thing in scene.objects if thing.field is not None and thing.field.type != "NONE" and not thing.hide_render]
    return [f for f in fields if f.field.type in KINDS], [f for f in fields if f.field.type not in KINDS]


def is_uniform(field):
    return field.type == "WIND" and not field.use_max_distance and field.falloff_power == 0


def radius_of(thing, metres):
    """The drawn size of an empty, or half the largest extent of another object; m."""
    scale = max(abs(s) for s in thing.matrix_world.to_scale())
    own = thing.empty_display_size if thing.type == "EMPTY" else max(thing.dimensions) / 2 / max(scale, 1e-9)
    return max(own * scale * metres, 1e-3)


def source_of(thing, metres):
    """The library's kind of wind source for a field, and its fields."""
    field = thing.field
    position, axis = np.array(thing.matrix_world.translation) * metres, np.array(thing.matrix_world)[:3, 2]
    limit = field.distance_max * metres if field.use_max_distance else 0.0
    if field.type == "TURBULENCE":
        return "turbulence", {"rms": abs(field.strength), "integral_length": field.size * metres if field.size > 0 else 1.0,
                              "seed": field.seed}
    if field.type == "VORTEX":
        reach = field.distance_min * metres if field.use_min_distance and field.distance_min > 0 else radius_of(thing, metres)
        core = reach / 1.12
        return "vortex", {"position": position, "axis": axis, "core_radius": core, "outer_radius": limit,
                          "circulation": field.strength * 2 * math.pi * core / PEAK}
    nozzle = radius_of(thing, metres)
    return "blower", {"position": position, "direction": axis if field.strength >= 0 else -axis, "speed": abs(field.strength),
                      "nozzle_radius": nozzle, "range": max(limit or 10.0, nozzle)}


class Wind:
    """The wind of a world: the panel's, and the scene's fields, which may move and change."""

    def __init__(self, world, scene, settings, metres):
        self.world, self.metres, self.base = world, metres, np.array(settings.wind, float)
        fields, _ = fields_of(scene)
        self.uniform = [thing for thing in fields if is_uniform(thing.field)]
        self.sources = []
        blowing = self.blow()
        if settings.gusts > 0:
            along = blowing if blowing.any() else (1, 0, 0)
            world.add_gusts(direction=along, rms=settings.gusts, integral_time=2, angle_rms=0.3)
        if settings.turbulence > 0:
            world.add_turbulence(rms=settings.turbulence, integral_length=1)
        for thing in fields:
            if thing not in self.uniform:
                kind, values = source_of(thing, metres)
                self.sources.append((thing, getattr(world, f"add_{kind}")(**values)))

    def blow(self):
        """Sets and returns the uniform wind, m/s."""
        total = self.base.copy()
        for thing in self.uniform:
            axis = np.array(thing.matrix_world)[:3, 2]
            total += axis / max(np.linalg.norm(axis), 1e-9) * thing.field.strength
        self.world.set_uniform_wind(total)
        return total

    def follow(self):
        if self.uniform:
            self.blow()
        for thing, source in self.sources:
            source.update(**source_of(thing, self.metres)[1])
