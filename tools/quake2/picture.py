# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of RGBA texels: made, filled, written on, and saved as PNG."""
import struct
import zlib
from pathlib import Path

from font import dot

Color = tuple[int, int, int, int]
CLEAR: Color = (0, 0, 0, 0)


class Picture:
    def __init__(self, width: int, height: int, color: Color = CLEAR):
        self.width, self.height = width, height
        self.texels = [color] * (width * height)

    def set(self, x: int, y: int, color: Color) -> None:
        if 0 <= x < self.width and 0 <= y < self.height:
            self.texels[y * self.width + x] = color

    def fill(self, x: int, y: int, width: int, height: int, color: Color) -> None:
        for row in range(y, y + height):
            for column in range(x, x + width):
                self.set(column, row, color)

    def letter(self, letter: str, x: int, y: int, scale: int, top: Color, bottom: Color | None = None) -> None:
        """Its colour runs from `top` to `bottom`, and a dark edge is below and on the right of it."""
        bottom = bottom or top
        for shadow in (True, False):
            for row in range(7 * scale):
                color = tuple(round(a + (b - a) * row / (7 * scale)) for a, b in zip(top, bottom))
                for column in range(5 * scale):
                    if dot(letter, column // scale, row // scale):
                        if shadow:
                            self.set(x + column + 1, y + row + 1, (0, 0, 0, 200))
                        else:
                            self.set(x + column, y + row, color)

    def save(self, path: Path) -> None:
        rows = bytearray()
        for y in range(self.height):
            rows.append(0)
            for texel in self.texels[y * self.width:(y + 1) * self.width]:
                rows.extend(texel)

        def chunk(kind: bytes, content: bytes) -> bytes:
            return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

        header = struct.pack(">IIBBBBB", self.width, self.height, 8, 6, 0, 0, 0)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes(rows)))
                         + chunk(b"IEND", b""))


def text(words: str, scale: int, top: Color, bottom: Color | None = None) -> Picture:
    """A line of text by itself."""
    picture = Picture(6 * scale * len(words) + 1, 8 * scale + 1)
    for i, letter in enumerate(words):
        picture.letter(letter, 6 * scale * i, 0, scale, top, bottom)
    return picture
