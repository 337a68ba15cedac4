# SPDX-License-Identifier: GPL-2.0-or-later
"""The catalogue: every level, sky and model that the build makes, by name."""

from dataclasses import dataclass
from typing import Callable

import figure13
import gallery
import many
import mine
import quay
import ring
import room
import sky
import statue
import test_rooms
import warehouse
import yard


# Numbers of lamps of the committed halls; those beyond many.BRUSH_LIMIT need a mesh.
HALLS = [10, 100, 1000, 10000, 100000]


@dataclass
class Entry:
    """A level: game is 'game' or 'test', build returns (Level, Route or None), verify looks at the
    compiled Bsp and raises ValueError when something is amiss."""

    name: str
    game: str
    build: Callable
    verify: Callable = None


def levels(lights=None):
    """All levels; lights adds a hall with that many lamps."""
    out = [Entry(f.__name__, "test", lambda f=f: (f(), None)) for f in test_rooms.LEVELS]
    out.append(Entry("figure13", "test", lambda: (figure13.build(), None)))
    for module in (warehouse, mine, gallery, ring, yard, room, quay):
        out.append(Entry(module.__name__, "game", module.build,
                         getattr(module, "verify", None)))
    for count in [*HALLS, *([lights] if lights else [])]:
        out.append(Entry("many_%d" % count, "game", lambda n=count: many.build(n)))
    return out


def skies(games):
    """Sky boxes as {name: function that writes it}."""
    court = sky.day(sky.sun_direction(40, -55), (.16, .30, .62), (.50, .58, .66), (.2, .18, .15),
                    (.8, .8, .8), 3, -.4)
    dusk = sky.day(mine.toward_sun(), (.13, .26, .55), (.62, .52, .42), (.2, .16, .12),
                   (.85, .78, .70), 5, -.2)
    evening = sky.day(sky.sun_direction(*sky.EVENING_SUN), (.075, .17, .42), (.74, .44, .24),
                      (.15, .12, .09), (.80, .56, .42), 8, -.35)
    afterglow = sky.afterglow(sky.sun_direction(158, 0), (.016, .028, .075), (.06, .06, .10),
                              (.62, .22, .06), (.30, .13, .10), 12)
    return {"afterglow": lambda: sky.write_sky(games["game"] / "env", "afterglow", 256, afterglow),
            "evening": lambda: sky.write_sky(games["game"] / "env", "evening", 256, evening),
            "dusk": lambda: sky.write_sky(games["game"] / "env", "dusk", 256, dusk),
            "court": lambda: sky.write_sky(games["test"] / "env", "court", 64, court)}


def models(game, lights=None):
    """Meshes as {name: function that writes it}."""
    out = {"statue": lambda: statue.write(game / "models" / "statue.glb")}
    for count in [*HALLS, *([lights] if lights else [])]:
        if count > many.BRUSH_LIMIT:
            path = game / "models" / ("lamps_%d.glb" % count)
            out["lamps_%d" % count] = lambda p=path, n=count: many.write_lamps(p, n)
    return out
