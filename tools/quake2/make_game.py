#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The little that Quake II's game needs beside levels, made by this project: letters, figures and menus, keys, and simple
models. Whoever has the game's own data needs none of it.

make_game.py LEVELS FOLDER: writes FOLDER/pics, FOLDER/models, FOLDER/players, FOLDER/maps/*.ent and the keys,
FOLDER/default.cfg and FOLDER/yq2.cfg.
LEVELS is the folder that holds maps/ and routes/.
"""
import random
import sys
from pathlib import Path

import models
from entities import write_entities
from font import dot
from picture import CLEAR, Color, Picture, text

WHITE: Color = (235, 235, 225, 255)
GREY: Color = (150, 150, 145, 255)
AMBER: Color = (255, 190, 80, 255)
RUST: Color = (190, 90, 30, 255)
RED: Color = (255, 90, 60, 255)
GREEN: Color = (130, 230, 130, 255)
STEEL: Color = (70, 76, 84, 255)
DARK: Color = (28, 31, 36, 255)


def characters() -> Picture:
    """conchars: 16 x 16 cells of 8 x 8 texels; the lower half is the upper one in another colour."""
    picture = Picture(128, 128)
    for half, (top, bottom) in enumerate(((WHITE, GREY), (AMBER, RUST))):
        for number in range(128):
            x, y = number % 16 * 8, number // 16 * 8 + 64 * half
            if 33 <= number < 127:
                picture.letter(chr(number), x + 1, y, 1, top, bottom)
        def at(number: int) -> tuple[int, int]:
            return number % 16 * 8, number // 16 * 8 + 64 * half
        for number in range(1, 10):  # the frame of a text box: three rows of three
            x, y = at(number)
            row, column = (number - 1) // 3, (number - 1) % 3
            left, right = (4 if column == 0 else 0), (4 if column == 2 else 8)
            above, below = (4 if row == 0 else 0), (4 if row == 2 else 8)
            picture.fill(x + left, y + above, right - left, below - above, (10, 12, 16, 220))
            if row == 0:
                picture.fill(x + left, y + 4, right - left, 1, top)
            if row == 2:
                picture.fill(x + left, y + 3, right - left, 1, top)
            if column == 0:
                picture.fill(x + 4, y + above, 1, below - above, top)
            if column == 2:
                picture.fill(x + 3, y + above, 1, below - above, top)
        x, y = at(11)  # where one types
        picture.fill(x, y, 7, 8, top)
        for number in (12, 13):  # the chosen line
            x, y = at(number)
            for row in range(7):
                picture.fill(x + 2, y + row, 4 - abs(3 - row), 1, top)
        for number, letter in ((16, "["), (17, "]")):
            picture.letter(letter, at(number)[0] + 1, at(number)[1], 1, AMBER, RUST)
        for number in (18, 19, 20, 24, 25, 26):  # around a line of input: above and below, left, middle and right
            x, y = at(number)
            side, above = (number - 18) % 3 - 1, number < 24
            left, right = (3 if side < 0 else 0), (5 if side > 0 else 8)
            picture.fill(x + left, y + (1 if above else 6), right - left, 1, GREY)
            if side != 0:
                picture.fill(x + (3 if side < 0 else 4), y + (1 if above else 0), 1, 7, GREY)
        for number in (29, 30, 31):  # a line: left end, middle, right end
            x, y = at(number)
            picture.fill(x + (2 if number == 29 else 0), y + 3, 8 - (2 if number != 30 else 0), 2, top)
    for number, (left, right) in {128: (4, 8), 129: (0, 8), 130: (0, 4)}.items():  # a slider
        x, y = number % 16 * 8, number // 16 * 8
        picture.fill(x, y, 8, 8, CLEAR)
        picture.fill(x + left, y + 3, right - left, 2, GREY)
    x, y = 131 % 16 * 8, 131 // 16 * 8
    picture.fill(x, y, 8, 8, CLEAR)
    picture.fill(x, y + 3, 8, 2, GREY)
    picture.fill(x + 2, y, 4, 8, AMBER)
    return picture


def figure(letter: str, top: Color, bottom: Color) -> Picture:
    """Of the display of health: 16 x 24."""
    picture = Picture(16, 24)
    for shadow in (1, 0):
        for row in range(21):
            for column in range(15):
                if dot(letter, column // 3, row // 3):
                    color = tuple(round(a + (b - a) * row / 21) for a, b in zip(top, bottom))
                    picture.set(column + shadow, row + 1 + shadow, (0, 0, 0, 220) if shadow else color)
    return picture


def icon(letter: str, color: Color, size: int = 24) -> Picture:
    picture = Picture(size, size, DARK)
    picture.fill(1, 1, size - 2, size - 2, STEEL)
    picture.fill(2, 2, size - 4, size - 4, DARK)
    scale = 2
    picture.letter(letter, (size - 5 * scale) // 2, (size - 7 * scale) // 2, scale, color)
    return picture


def cross(color: Color) -> Picture:
    picture = Picture(24, 24, DARK)
    picture.fill(1, 1, 22, 22, STEEL)
    picture.fill(9, 4, 6, 16, color)
    picture.fill(4, 9, 16, 6, color)
    return picture


def plate(width: int, height: int, seed: int) -> Picture:
    """Riveted steel."""
    chance = random.Random(seed)
    picture = Picture(width, height)
    for y in range(height):
        for x in range(width):
            shade = 34 + chance.randrange(8) + (10 if y % 32 == 0 or x % 32 == 0 else 0) - (6 if y % 32 == 31 else 0)
            if (x % 32, y % 32) in ((3, 3), (4, 3), (3, 4), (4, 4)):
                shade = 80
            picture.set(x, y, (shade, shade + 2, shade + 6, 255))
    return picture


def backdrop() -> Picture:
    """Behind the console and before the first level."""
    picture = plate(320, 240, 1)
    for i, letter in enumerate("VIGIL"):
        picture.letter(letter, 55 + 44 * i, 90, 7, AMBER, RUST)
    return picture


def pictures(folder: Path) -> None:
    def save(name: str, picture: Picture) -> None:
        picture.save(folder / "pics" / f"{name}.png")

    save("conchars", characters())
    save("conback", backdrop())
    save("backtile", plate(64, 64, 2))
    for prefix, top, bottom in (("num", GREEN, (60, 150, 60, 255)), ("anum", RED, (150, 30, 20, 255))):
        for digit in range(10):
            save(f"{prefix}_{digit}", figure(str(digit), top, bottom))
        save(f"{prefix}_minus", figure("-", top, bottom))
    save("field_3", Picture(52, 28, (10, 12, 16, 160)))
    save("i_health", cross((220, 50, 40, 255)))
    for name, letter, color in (("i_fixme", "?", WHITE), ("i_help", "?", AMBER), ("i_powershield", "S", GREEN),
                                ("i_powerscreen", "S", AMBER), ("i_jacketarmor", "A", GREEN), ("i_combatarmor", "A", AMBER),
                                ("i_bodyarmor", "A", RED), ("i_pack", "P", WHITE), ("a_shells", "s", AMBER),
                                ("a_bullets", "b", AMBER), ("a_cells", "c", GREEN), ("a_grenades", "g", GREEN),
                                ("a_rockets", "r", RED), ("a_slugs", "l", AMBER), ("w_blaster", "B", AMBER), ("w_rlauncher", "R", RED),
                                ("p_quad", "Q", AMBER), ("p_silencer", "s", GREY), ("p_rebreather", "O", GREEN),
                                ("p_envirosuit", "E", GREEN), ("p_invulnerability", "I", RED), ("p_adrenaline", "+", RED)):
        save(name, icon(letter, color))
    for name, words in (("game", "GAME"), ("multiplayer", "MULTIPLAYER"), ("options", "OPTIONS"), ("video", "VIDEO"),
                        ("quit", "QUIT")):
        save(f"m_main_{name}", text(words, 3, GREY, STEEL))
        save(f"m_main_{name}_sel", text(words, 3, AMBER, RUST))
    for name, words in (("game", "GAME"), ("load_game", "LOAD GAME"), ("save_game", "SAVE GAME"), ("options", "OPTIONS"),
                        ("video", "VIDEO"), ("multiplayer", "MULTIPLAYER"), ("join_server", "JOIN SERVER"),
                        ("addressbook", "ADDRESS BOOK"), ("customize", "CUSTOMISE"), ("start_server", "START SERVER"),
                        ("plauer_setup", "PLAYER"), ("player_setup", "PLAYER"), ("mods", "MODS")):
        save(f"m_banner_{name}", text(words, 3, WHITE, GREY))
    plaque = Picture(38, 166)
    for i, letter in enumerate("QUAKE II"):
        plaque.letter(letter, 12, 4 + 20 * i, 2, AMBER, RUST)
    save("m_main_plaque", plaque)
    save("m_main_logo", text("VIGIL", 2, AMBER, RUST))
    for frame in range(15):
        cursor = Picture(22, 29)
        half = 4 + abs(7 - frame) // 2
        for row in range(-half, half + 1):
            cursor.fill(4, 14 + row, 2 * (half - abs(row)) + 1, 1, AMBER)
        save(f"m_cursor{frame}", cursor)
    save("loading", text("LOADING", 3, AMBER, RUST))
    save("pause", text("PAUSED", 3, AMBER, RUST))
    quit_page = plate(320, 240, 3)
    for i, letter in enumerate("Quit? Y / N"):
        quit_page.letter(letter, 60 + 18 * i, 105, 3, AMBER, RUST)
    save("quit", quit_page)
    inventory = Picture(256, 192, (10, 12, 16, 200))
    save("inventory", inventory)
    save("help", inventory)
    for number in (1, 2, 3):
        sight = Picture(16, 16)
        for step in range(3, 7):
            for x, y in ((7 - step, 7), (7 + step, 7), (7, 7 - step), (7, 7 + step)):
                sight.set(x, y, (255, 255, 255, 220))
        sight.set(7, 7, (255, 255, 255, 220))
        save(f"ch{number}", sight)


KEYS = """// Keys of a game without data of its own.
unbindall
bind w +forward
bind s +back
bind a +moveleft
bind d +moveright
bind UPARROW +forward
bind DOWNARROW +back
bind LEFTARROW +left
bind RIGHTARROW +right
bind SPACE +moveup
bind CTRL +attack
bind c +movedown
bind SHIFT +speed
bind MOUSE1 +attack
bind MOUSE2 +moveup
bind 1 "use Blaster"
bind 7 "use Rocket Launcher"
bind TAB inven
bind ENTER invuse
bind ` toggleconsole
bind F1 "cmd help"
bind F2 "menu_savegame"
bind F3 "menu_loadgame"
bind F6 "save quick"
bind F9 "load quick"
bind F12 screenshot
bind PAUSE pause
set freelook 1
set crosshair 1
set sv_entfile 1
alias d1 "menu_main"
alias newgame "killserver ; maxclients 1 ; deathmatch 0 ; map warehouse"
"""


def main() -> None:
    levels, folder = Path(sys.argv[1]), Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    pictures(folder)
    models.write_all(folder)
    write_entities(levels / "maps", levels / "routes", folder / "maps")
    for name in ("default.cfg", "yq2.cfg"):  # the engine's package has keys of its own in the latter
        (folder / name).write_text(KEYS)


if __name__ == "__main__":
    main()
