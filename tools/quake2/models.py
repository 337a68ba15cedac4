# SPDX-License-Identifier: GPL-2.0-or-later
"""Models of boxes, in Quake II's format (IDP2, version 8), with the frames that the game asks for."""
import math
import random
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from picture import Color, Picture

Vec = tuple[float, float, float]
SKIN = 64  # texels of a side; 8 x 8 cells of one colour each
CELL = 8


@dataclass
class Box:
    low: Vec
    high: Vec
    color: int  # number of the cell
    part: str = ""  # what moves together


@dataclass
class Move:
    """A turn about the y axis through `pivot` (degrees, the upper end forwards) and a shift."""
    pitch: float = 0.0
    pivot: Vec = (0.0, 0.0, 0.0)
    shift: Vec = (0.0, 0.0, 0.0)
    scale: float = 1.0


def apply(move: Move, point: Vec) -> Vec:
    x, y, z = (move.scale * (p - q) for p, q in zip(point, move.pivot))
    c, s = math.cos(math.radians(move.pitch)), math.sin(math.radians(move.pitch))
    turned = (c * x + s * z, y, -s * x + c * z)
    return tuple(t + p + q for t, p, q in zip(turned, move.pivot, move.shift))  # type: ignore[return-value]


# Sides of a box by its corners (x + 2 y + 4 z), clockwise seen from outside.
SIDES = ((2, 6, 4, 0), (5, 7, 3, 1), (4, 5, 1, 0), (3, 7, 6, 2), (6, 7, 5, 4), (1, 3, 2, 0))


def corners(box: Box) -> list[Vec]:
    return [tuple((box.high if i >> axis & 1 else box.low)[axis] for axis in range(3)) for i in range(8)]  # type: ignore[misc]


def write_md2(path: Path, boxes: list[Box], frames: int, skins: list[str],
              pose: Callable[[int, Box], list[Move]]) -> None:
    """`pose` says how a box is moved in a frame: one move after the other."""
    places = [corners(box) for box in boxes]
    uvs, triangles = [], []
    for number, box in enumerate(boxes):
        u, v = box.color % 8 * CELL, box.color // 8 * CELL
        for dx, dy in ((1, 1), (6, 1), (6, 6), (1, 6)):
            uvs.append((u + dx, v + dy))
        for side in SIDES:
            a, b, c, d = (8 * number + corner for corner in side)
            s = 4 * number
            triangles += [(a, b, c, s, s + 1, s + 2), (a, c, d, s, s + 2, s + 3)]
    points = 8 * len(boxes)
    frame_size = 40 + 4 * points
    skins_at = 68
    uvs_at = skins_at + 64 * len(skins)
    triangles_at = uvs_at + 4 * len(uvs)
    frames_at = triangles_at + 12 * len(triangles)
    commands_at = frames_at + frame_size * frames
    out = bytearray(struct.pack("<4s16i", b"IDP2", 8, SKIN, SKIN, frame_size, len(skins), points, len(uvs), len(triangles), 1,
                                frames, skins_at, uvs_at, triangles_at, frames_at, commands_at, commands_at + 4))
    for skin in skins:
        out += struct.pack("64s", skin.encode())
    for u, v in uvs:
        out += struct.pack("<2h", u, v)
    for triangle in triangles:
        out += struct.pack("<6H", *triangle)
    for frame in range(frames):
        moved = []
        for box, place in zip(boxes, places):
            for point in place:
                for move in pose(frame, box):
                    point = apply(move, point)
                moved.append(point)
        low = [min(point[axis] for point in moved) for axis in range(3)]
        scale = [max((max(point[axis] for point in moved) - low[axis]) / 255, 1e-4) for axis in range(3)]
        out += struct.pack("<6f16s", *scale, *low, f"frame{frame:03}".encode())
        for point in moved:
            out += bytes(min(255, max(0, round((point[axis] - low[axis]) / scale[axis]))) for axis in range(3)) + b"\0"
    out += struct.pack("<i", 0)  # no commands for OpenGL
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(bytes(out))


# Colours of cells.
STEEL, DARK, SKIN_TONE, CLOTH, STRAP, AMBER, RED, WHITE, GREEN, BOOT, BONE, GLASS = range(12)
TINTS: dict[int, Color] = {
    STEEL: (120, 126, 134, 255), DARK: (46, 48, 54, 255), SKIN_TONE: (190, 150, 120, 255), CLOTH: (96, 100, 70, 255),
    STRAP: (70, 50, 36, 255), AMBER: (255, 170, 40, 255), RED: (190, 36, 28, 255), WHITE: (228, 228, 220, 255),
    GREEN: (80, 170, 80, 255), BOOT: (40, 34, 30, 255), BONE: (214, 204, 178, 255), GLASS: (90, 200, 220, 255)}


def skin(tints: dict[int, Color], seed: int) -> Picture:
    """Cells of one colour each, somewhat worn."""
    chance = random.Random(seed)
    picture = Picture(SKIN, SKIN, (60, 60, 60, 255))
    for cell, (red, green, blue, _) in tints.items():
        for y in range(CELL):
            for x in range(CELL):
                shade = 1.0 + 0.16 * (chance.random() - 0.5)
                color = tuple(min(255, round(part * shade)) for part in (red, green, blue))
                picture.set(cell % 8 * CELL + x, cell // 8 * CELL + y, (*color, 255))
    return picture


def write_pcx(path: Path, picture: Picture) -> None:
    """The game looks for players' skins by this format: 8 bits, run lengths, a palette at the end."""
    colors = sorted(set(picture.texels))
    if len(colors) > 255:  # the last index is transparent
        colors = sorted({tuple(part // 24 * 24 for part in texel[:3]) + (255,) for texel in picture.texels})
        texels = [tuple(part // 24 * 24 for part in texel[:3]) + (255,) for texel in picture.texels]
    else:
        texels = picture.texels
    index = {color: i for i, color in enumerate(colors)}
    out = bytearray(struct.pack("<4B4H2H", 10, 5, 1, 8, 0, 0, picture.width - 1, picture.height - 1, 72, 72))
    out += bytes(48) + struct.pack("<2BHH", 0, 1, picture.width, 1) + bytes(58)
    for texel in texels:
        value = index[texel]
        out += bytes((0xc1, value))
    palette = bytearray(768)
    for color, i in index.items():
        palette[3 * i:3 * i + 3] = bytes(color[:3])
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(bytes(out) + b"\x0c" + bytes(palette))


def still(frame: int, box: Box) -> list[Move]:
    return []


# ---- people ----

def body(helmet: int, cloth: int) -> list[Box]:
    """24 units wide, from its feet at -24 to 30; it looks along +x."""
    return [
        Box((-4.5, 1.5, -24), (6, 8.5, -14), BOOT, "left leg"), Box((-4.5, -8.5, -24), (6, -1.5, -14), BOOT, "right leg"),
        Box((-4, 2, -14.5), (4, 8, -2), cloth, "left leg"), Box((-4, -8, -14.5), (4, -2, -2), cloth, "right leg"),
        Box((-6, -9, -3), (6, 9, 18), cloth, "trunk"), Box((-8, -7, 2), (-6, 7, 15), DARK, "trunk"),
        Box((5, -6, 4), (7, 6, 14), STEEL, "trunk"), Box((-6.5, -10, -4), (6.5, 10, -1), STRAP, "trunk"),
        Box((-4, -4, 19), (5, 4, 27), SKIN_TONE, "head"), Box((-5, -5, 25.5), (5.5, 5, 30), helmet, "head"),
        Box((4.5, -3, 22), (6, 3, 25), GLASS, "head"),
        Box((-3, 9, 3), (3, 14, 17), cloth, "left arm"), Box((0, 9, 3), (14, 13, 7), SKIN_TONE, "left arm"),
        Box((-3, -14, 3), (3, -9, 17), cloth, "right arm"), Box((0, -13, 3), (12, -9, 7), SKIN_TONE, "right arm")]


def gun() -> list[Box]:
    return [Box((6, -13, 4), (30, -9, 9), DARK, "gun"), Box((12, -12, 8), (20, -10, 11), STEEL, "gun"),
            Box((30, -12, 5), (34, -10, 8), AMBER, "gun")]


@dataclass
class Act:
    """What a body does in the frames from `first` on."""
    first: int
    kind: str
    frames: int


def acts_of(rows: list[tuple[str, int]]) -> list[Act]:
    acts, first = [], 0
    for kind, frames in rows:
        acts.append(Act(first, kind, frames))
        first += frames
    return acts


PLAYER = acts_of([("stand", 40), ("run", 6), ("attack", 8), ("pain", 12), ("jump", 6), ("jump", 12), ("stand", 11),
                  ("stand", 17), ("stand", 11), ("stand", 12), ("crouch", 19), ("crouch run", 6), ("crouch", 9),
                  ("crouch", 4), ("death", 5), ("death", 6), ("death", 6), ("death", 8)])
SOLDIER = acts_of([("attack", 12), ("attack", 18), ("attack", 9), ("attack", 6), ("crouch", 5), ("pain", 5), ("pain", 7),
                   ("pain", 18), ("pain", 17), ("run", 8), ("run", 4), ("run", 14), ("run", 24), ("stand", 30),
                   ("stand", 39), ("run", 57), ("death", 36), ("death", 35), ("death", 45), ("death", 53), ("death", 24),
                   ("death", 10)])


def pose_of(acts: list[Act]) -> Callable[[int, Box], list[Move]]:
    feet: Vec = (0.0, 0.0, -24.0)

    def pose(frame: int, box: Box) -> list[Move]:
        act = max((act for act in acts if act.first <= frame), key=lambda act: act.first)
        part = (frame - act.first) / act.frames
        wave = math.sin(2 * math.pi * part * max(1, round(act.frames / 12)))
        moves: list[Move] = []
        if "run" in act.kind:
            swing = 35.0 * wave
            if box.part == "left leg":
                moves.append(Move(pitch=swing, pivot=(0, 5, -3)))
            elif box.part == "right leg":
                moves.append(Move(pitch=-swing, pivot=(0, -5, -3)))
            elif box.part == "left arm":
                moves.append(Move(pitch=-0.4 * swing, pivot=(0, 11, 16)))
        if act.kind == "stand" and box.part not in ("left leg", "right leg"):
            moves.append(Move(shift=(0, 0, 0.5 * wave)))
        if act.kind == "attack" and box.part in ("gun", "right arm", "left arm"):
            kick = max(0.0, 1.0 - 4.0 * part) if part > 0 else 0.0
            moves.append(Move(shift=(-4.0 * kick, 0, 4.0)))
        if act.kind == "pain" and box.part not in ("left leg", "right leg"):
            moves.append(Move(pitch=-18.0 * math.sin(math.pi * part), pivot=(0, 0, -2)))
        if act.kind == "jump" and box.part in ("left leg", "right leg"):
            moves.append(Move(pitch=-25.0, pivot=(0, 0, -3)))
        if "crouch" in act.kind and box.part not in ("left leg", "right leg"):
            moves.append(Move(shift=(0, 0, -12.0)))
        if act.kind == "death":
            fallen = min(1.0, 1.6 * (frame - act.first + 1) / act.frames)
            moves.append(Move(pitch=-88.0 * fallen * fallen, pivot=feet, shift=(0, 0, 6.0 * fallen)))
        return moves

    return pose


def count(acts: list[Act]) -> int:
    return acts[-1].first + acts[-1].frames


# ---- things ----

def blaster_pose(frame: int, box: Box) -> list[Move]:
    """The weapon in the player's view: it comes (5 frames), fires (4), rests (44), and goes (3)."""
    if frame < 5:
        return [Move(shift=(0, 0, -3.0 * (4 - frame)))]
    if frame < 9:
        kick = (2.5, 1.6, 0.8, 0.0)[frame - 5]
        return [Move(pitch=-2.0 * kick, pivot=(8, 0, -8), shift=(-kick, 0, 0))]
    if frame < 53:
        return [Move(shift=(0, 0, 0.15 * math.sin(2 * math.pi * (frame - 9) / 44)))]
    return [Move(shift=(0, 0, -4.0 * (frame - 52)))]


def launcher_pose(frame: int, box: Box) -> list[Move]:
    """As the blaster: it comes (5 frames), fires (8), rests (38), and goes (4)."""
    if frame < 5:
        return [Move(shift=(0, 0, -3.0 * (4 - frame)))]
    if frame < 13:
        kick = 5.0 * (13 - frame) / 8
        return [Move(pitch=-1.5 * kick, pivot=(8, 0, -8), shift=(-kick, 0, 0))]
    if frame < 51:
        return [Move(shift=(0, 0, 0.15 * math.sin(2 * math.pi * (frame - 13) / 38)))]
    return [Move(shift=(0, 0, -4.0 * (frame - 50)))]


def burst(frames: int, low: float, high: float) -> Callable[[int, Box], list[Move]]:
    return lambda frame, box: [Move(scale=low + (high - low) * frame / max(frames - 1, 1))]


def ball(size: float, color: int) -> list[Box]:
    """Three boxes that are about a ball."""
    a, b = size, 0.6 * size
    return [Box((-a, -b, -b), (a, b, b), color), Box((-b, -a, -b), (b, a, b), color), Box((-b, -b, -a), (b, b, a), color)]


def medicine(size: float, color: int) -> list[Box]:
    w = size
    return [Box((-w, -w, -15), (w, w, -15 + 1.4 * w), WHITE),
            Box((-w - 0.3, -0.25 * w, -15 + 0.2 * w), (w + 0.3, 0.25 * w, -15 + 1.2 * w), color),
            Box((-w - 0.3, -0.7 * w, -15 + 0.5 * w), (w + 0.3, 0.7 * w, -15 + 0.9 * w), color),
            Box((-0.5 * w, -0.5 * w, -15 + 1.4 * w), (0.5 * w, 0.5 * w, -15 + 1.6 * w), STEEL)]


def write_all(folder: Path) -> None:
    shared = "models/boxes.png"
    skin(TINTS, 1).save(folder / shared)

    def thing(name: str, boxes: list[Box], frames: int = 1, pose: Callable[[int, Box], list[Move]] = still,
              skins: tuple[str, ...] = (shared,)) -> None:
        write_md2(folder / name / "tris.md2", boxes, frames, list(skins), pose)

    # A player, and what he holds.
    people = body(GREEN, CLOTH)
    write_md2(folder / "players/male/tris.md2", people, count(PLAYER), ["players/male/grunt.pcx"], pose_of(PLAYER))
    write_md2(folder / "players/male/weapon.md2", gun(), count(PLAYER), [shared], pose_of(PLAYER))
    write_md2(folder / "players/male/w_blaster.md2", gun(), count(PLAYER), [shared], pose_of(PLAYER))
    for name, cloth in (("grunt", (86, 104, 66, 255)), ("rust", (140, 74, 44, 255)), ("slate", (70, 86, 120, 255))):
        write_pcx(folder / f"players/male/{name}.pcx", skin(TINTS | {CLOTH: cloth}, 2))
        icon = Picture(32, 32, (28, 31, 36, 255))
        icon.fill(10, 6, 12, 6, (90, 170, 90, 255))
        icon.fill(11, 11, 10, 6, TINTS[SKIN_TONE])
        icon.fill(6, 17, 20, 15, cloth)
        write_pcx(folder / f"players/male/{name}_i.pcx", icon)

    # A guard; skins of the three kinds that the game has, each with one for when it is hurt.
    skins = []
    for kind, cloth in enumerate(((110, 84, 60, 255), (120, 44, 40, 255), (60, 70, 96, 255))):
        for hurt in (False, True):
            tints = TINTS | {CLOTH: cloth} | ({SKIN_TONE: (170, 60, 50, 255), STEEL: (110, 60, 56, 255)} if hurt else {})
            name = f"models/monsters/soldier/skin{2 * kind + hurt}.png"
            skin(tints, 3 + kind).save(folder / name)
            skins.append(name)
    thing("models/monsters/soldier", body(RED, CLOTH) + gun(), count(SOLDIER), pose_of(SOLDIER), tuple(skins))

    # The weapon in view: right of the middle, below the eye.
    view = [Box((8, -7, -11), (26, -3, -7), DARK), Box((10, -6.4, -7), (22, -3.6, -5.5), STEEL),
            Box((26, -6, -10), (30, -4, -8), STEEL), Box((6, -6.5, -15), (11, -3.5, -10), STRAP),
            Box((5, -8, -18), (10, -2, -12), SKIN_TONE), Box((12, -7.2, -9.6), (18, -2.8, -8.6), AMBER)]
    thing("models/weapons/v_blast", view, 56, blaster_pose)
    tube = [Box((4, -8, -12), (30, -2, -6), DARK), Box((30, -8.6, -12.6), (34, -1.4, -5.4), STEEL),
            Box((8, -6, -6), (16, -4, -4), RED), Box((6, -6.5, -17), (11, -3.5, -11), STRAP),
            Box((5, -8, -19), (10, -2, -13), SKIN_TONE), Box((16, -8.3, -10), (24, -1.7, -9), AMBER)]
    thing("models/weapons/v_rocket", tube, 55, launcher_pose)
    thing("models/objects/rocket", [Box((-10, -2, -2), (8, 2, 2), STEEL), Box((8, -1.2, -1.2), (12, 1.2, 1.2), RED),
                                    Box((-10, -4, -0.4), (-4, 4, 0.4), DARK), Box((-10, -0.4, -4), (-4, 0.4, 4), DARK)])
    thing("models/objects/laser", [Box((-8, -1, -1), (8, 1, 1), AMBER)], 1)
    thing("models/objects/flash", ball(5, AMBER), 2, burst(2, 1, 0.5))
    thing("models/objects/smoke", ball(4, STEEL), 4, burst(4, 1, 2))
    thing("models/objects/explode", ball(7, AMBER), 6, burst(6, 0.4, 1.6))
    thing("models/objects/r_explode", ball(24, AMBER), 30, burst(30, 0.3, 1.4))
    thing("models/objects/r_explode2", ball(30, AMBER), 30, burst(30, 0.3, 1.4))
    for number, size in ((1, 8.0), (2, 4.0), (3, 6.0)):
        thing(f"models/objects/debris{number}", ball(size, STEEL))
    for name, size, color in (("sm_meat", 3, RED), ("arm", 4, RED), ("bone", 3, BONE), ("bone2", 4, BONE), ("chest", 7, RED),
                              ("skull", 4, BONE), ("head2", 5, SKIN_TONE), ("head", 5, SKIN_TONE), ("leg", 5, RED),
                              ("gear", 3, STEEL), ("sm_metal", 3, STEEL)):
        thing(f"models/objects/gibs/{name}", ball(size, color))
    thing("models/objects/dmspot", [Box((-20, -20, -24), (20, 20, -22), STEEL)])
    thing("models/objects/barrels", [Box((-10, -10, 0), (10, 10, 32), RED), Box((-11, -7, 0), (11, 7, 32), RED),
                                     Box((-7, -11, 0), (7, 11, 32), RED), Box((-11, -11, 14), (11, 11, 17), DARK)])
    thing("models/items/healing/medium", medicine(8, RED))
    thing("models/items/healing/stimpack", medicine(5, GREEN))
    thing("models/items/healing/large", medicine(10, RED))
    thing("models/items/mega_h", medicine(11, AMBER))
    thing("models/items/armor/shard", [Box((-3, -5, -15), (3, 5, -6), GREEN)])
