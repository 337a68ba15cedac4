#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Judges what session.sh left: FOLDER SHOTS SANITIZED NAME...

The pictures in SHOTS (BMP, one per NAME) become FOLDER/pictures/NAME.png. None may be black, or like the one before. The memory
in FOLDER/memory (lines with KiB and the number of levels left) may not grow from the third round of levels to the last, unless
SANITIZED is 1.
"""
import struct
import sys
import zlib
from pathlib import Path

BLACK = 4  # mean of a picture's values, of 255
ALIKE = 0.05  # part of the values that differ
GROWTH = 16  # MiB
LEVELS, ROUNDS = 5, 4


def read_bmp(path: Path) -> tuple[int, int, bytes]:
    """Width, height and RGB, rows from the top."""
    data = path.read_bytes()
    first, width, height = struct.unpack("<10xI4x2i", data[:26])
    assert data[:2] == b"BM" and data[28] == 24 and height > 0, f"{path}: not 24 bits a pixel, the lowest row first"
    stride = (3 * width + 3) // 4 * 4
    rgb = bytearray(b"".join(data[first + stride * y :][: 3 * width] for y in reversed(range(height))))
    rgb[0::3], rgb[2::3] = rgb[2::3], rgb[0::3]
    return width, height, bytes(rgb)


def write_png(path: Path, width: int, height: int, rgb: bytes) -> None:
    def chunk(tag: bytes, body: bytes) -> bytes:
        return struct.pack(">I", len(body)) + tag + body + struct.pack(">I", zlib.crc32(tag + body))

    rows = b"".join(b"\0" + rgb[3 * width * y : 3 * width * (y + 1)] for y in range(height))
    header = struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
    )


def main() -> int:
    folder, shots, sanitized, names = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3] == "1", sys.argv[4:]
    files = sorted(shots.glob("*.bmp"))
    bad = [] if len(files) == len(names) else [f"{len(files)} pictures, not {len(names)}"]
    before = b""
    for name, path in zip(names, files):
        width, height, rgb = read_bmp(path)
        write_png(folder / "pictures" / f"{name}.png", width, height, rgb)
        mean = sum(rgb) / len(rgb)
        change = sum(a != b for a, b in zip(rgb, before)) / len(rgb) if before else 1.0
        print(f"{name}: mean {mean:.1f} of 255, {100 * change:.0f}% of the values changed")
        if mean < BLACK or change < ALIKE:
            bad.append(f"{name} is black, or as the picture before it")
        before = rgb
    most = [0.0] * ROUNDS
    for line in (folder / "memory").read_text().splitlines():
        size, left = map(int, line.split())
        most[min(left // LEVELS, ROUNDS - 1)] = max(most[min(left // LEVELS, ROUNDS - 1)], size / 1024)
    print("memory at most in each round of levels, MiB: " + ", ".join(f"{size:.0f}" for size in most))
    if not sanitized and (most[-2] == 0 or most[-1] > most[-2] + GROWTH):
        bad.append("memory grows")
    for line in bad:
        print(line, file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
