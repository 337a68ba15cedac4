# SPDX-License-Identifier: GPL-2.0-or-later
"""A material: what a .map face line says about one brush side (texture, contents, flags, value).

The numbers are Quake II's (contents and surface flags of IBSP 38). It holds no pixels: those are
painted in textures.py under the same names.
"""

from dataclasses import dataclass, replace

SOLID, WINDOW, LAVA, WATER = 0x1, 0x2, 0x8, 0x20
ORIGIN, DETAIL = 0x1000000, 0x8000000

LIGHT, SKY, WARP, TRANS33, TRANS66, NODRAW = 0x1, 0x4, 0x8, 0x10, 0x20, 0x80


@dataclass(frozen=True)
class Material:
    """One way to paint a brush side.

    scale is in map units per texel. fit stretches the texture once over the side instead of
    tiling it in world space. turn lays the texture's u axis along the vertical. cast projects
    the texture along the nearest world axis, so that it runs on over the facets of rock.
    """

    texture: str
    scale: float = 0.5
    contents: int = SOLID
    flags: int = 0
    value: int = 0
    fit: bool = False
    turn: bool = False
    cast: bool = False

    def detail(self):
        """The same material on a brush that does not take part in visibility."""
        return replace(self, contents=self.contents | DETAIL)

    def emissive(self, value):
        """The same material as a lamp; radiance is average linear colour * value * 0.1."""
        return replace(self, flags=self.flags | LIGHT, value=int(value))

    def fitted(self):
        return replace(self, fit=True)

    def turned(self):
        return replace(self, turn=True)

    def scaled(self, scale):
        return replace(self, scale=scale)


def vigil(name, **options):
    """A material of the project's own texture set, textures/vigil/NAME.png."""
    return Material("vigil/" + name, **options)


SKY_BOX = vigil("sky", flags=SKY)
CAULK = vigil("black", flags=NODRAW)
GLASS = vigil("glass", contents=WINDOW, flags=TRANS33)
WATER_SURFACE = vigil("water", contents=WATER, flags=WARP | TRANS66)
