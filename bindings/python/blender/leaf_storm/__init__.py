# SPDX-License-Identifier: MIT
"""Falling leaves in Blender: an add-on (sidebar of the 3D view, "Leaves"), and a command, `command.py`.

A baked storm plays without Python: as one carrier mesh with a point cache (PC2), on which geometry nodes instance the leaves, or,
for a few leaves, as an object with keyframes for each. Blender's axes are the library's.
"""
from . import package

bl_info = {  # for Blender before 4.2; later ones read the manifest that extension.py writes
    "name": "Leaf Storm (Langevin Rigid)",
    "author": "Langevin Rigid",
    "version": (0, 0, 0),  # extension.py writes the package's
    "blender": (3, 4, 0),
    "location": "3D view > Sidebar > Leaves",
    "description": "Bakes falling leaves, paper and petals to instances",
    "category": "Physics",
}

package.find()


def register():
    from . import panel
    panel.register()


def unregister():
    from . import panel
    panel.unregister()
