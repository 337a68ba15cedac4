# SPDX-License-Identifier: GPL-2.0-or-later
"""A Quake II .map: entities with keys and brushes, written as text.

Coordinates are Quake units, z up. It writes only; nothing here reads a .map back.
"""

import numpy as np


class Entity:
    """An entity: keys, and brushes when it is the world or a brush model."""

    def __init__(self, classname, brushes=(), **keys):
        self.keys = {"classname": classname}
        self.keys.update({k: text_of(v) for k, v in keys.items()})
        self.brushes = list(brushes)

    def text(self):
        lines = ['"%s" "%s"' % item for item in self.keys.items()]
        return "{\n" + "\n".join(lines) + "\n" + "".join(b.text() for b in self.brushes) + "}\n"


def text_of(value):
    """Vectors become 'x y z'; everything else its text."""
    if isinstance(value, (tuple, list, np.ndarray)):
        return " ".join("%g" % c for c in value)
    return str(value)


class Level:
    """A level being built: world brushes, and point and brush entities."""

    def __init__(self, name, message, **world_keys):
        self.name = name
        self.world = Entity("worldspawn", message=message, mapversion=220, **world_keys)
        self.entities = []

    def add(self, *brushes):
        """Structural brushes of the world: they hold the level and split visibility."""
        self.world.brushes += brushes

    def add_detail(self, *brushes):
        """World brushes that do not take part in visibility."""
        self.world.brushes += [b.detail() for b in brushes]

    def entity(self, classname, brushes=(), **keys):
        self.entities.append(Entity(classname, brushes, **keys))

    def start(self, eye, yaw):
        """The player start for an eye position: the eye is 22 above a player's origin."""
        self.entity("info_player_start", origin=(eye[0], eye[1], eye[2] - 22), angle=round(yaw))

    def write(self, path):
        with open(path, "w", encoding="ascii") as file:
            file.write("// Game: Quake 2\n// Format: Quake2 (Valve)\n")
            for entity in [self.world, *self.entities]:
                file.write(entity.text())
