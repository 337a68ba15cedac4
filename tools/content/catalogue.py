# SPDX-License-Identifier: GPL-2.0-or-later
"""The catalogue: every level, sky and model that the build makes, by name."""

from dataclasses import dataclass
from typing import Callable

import sky
import test_rooms
import warehouse


@dataclass
class Entry:
    """A level: game is 'game' or 'test', build returns (Level, Route or None)."""

    name: str
    game: str
    build: Callable


def levels(lights=None):
    """All levels; lights adds a hall with that many lamps."""
    out = [Entry(f.__name__, "test", lambda f=f: (f(), None)) for f in test_rooms.LEVELS]
    out.append(Entry("warehouse", "game", warehouse.build))
    return out


def skies(games):
    """Sky boxes as {name: function that writes it}."""
    court = sky.day(sky.sun_direction(40, -55), (.16, .30, .62), (.50, .58, .66), (.2, .18, .15),
                    (.8, .8, .8), 3, -.4)
    return {"court": lambda: sky.write_sky(games["test"] / "env", "court", 64, court)}


def models(game):
    """Meshes as {name: function that writes it}."""
    return {}
