# SPDX-License-Identifier: MIT
"""The part of Blender's mathutils that the add-on uses."""
import numpy as np


class Vector:
    def __init__(self, values):
        self.values = np.array(values, float)

    def __iter__(self):
        return iter(self.values.tolist())

    def __len__(self):
        return len(self.values)

    def __getitem__(self, at):
        return self.values[at]

    def __neg__(self):
        return Vector(-self.values)

    def __add__(self, other):
        return Vector(self.values + other.values)

    def __truediv__(self, number):
        return Vector(self.values / number)

    length = property(lambda self: float(np.linalg.norm(self.values)))


class Matrix:
    def __init__(self, values):
        self.values = np.array(values, float)

    @classmethod
    def Translation(cls, vector):  # noqa: N802, as Blender has it
        matrix = np.eye(4)
        matrix[:3, 3] = vector.values
        return cls(matrix)
