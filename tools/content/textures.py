# SPDX-License-Identifier: GPL-2.0-or-later
"""The table of textures: name, painter, gloss; and the tools to write the set.

Painters live in stone.py, masonry.py, metal.py, wood.py, growth.py, lamp_face.py and picture.py;
each returns a canvas of linear albedo. Only glossy materials are listed in materials.json.
"""

import json

import growth
import lamp_face
import masonry
import metal
import painter
import picture
import stone
import wood
from texture_size import register_size

# name: (painter function, keyword arguments, gloss or None); gloss is (roughness, specular).
TABLE = {
    "concrete": (stone.concrete, dict(colour=(.36, .35, .33), seed=1), None),
    "concrete_dark": (stone.concrete, dict(colour=(.19, .19, .19), seed=2), None),
    "concrete_panel": (stone.concrete_panel, dict(colour=(.42, .41, .38), seed=3), None),
    "floor_painted": (stone.floor_painted, dict(seed=4), (.22, .04)),
    "plaster": (stone.plaster, dict(colour=(.62, .60, .54), seed=5), None),
    "plaster_green": (stone.plaster, dict(colour=(.30, .42, .33), seed=6), None),
    "plaster_red": (stone.plaster, dict(colour=(.36, .075, .06), seed=7), None),
    "plaster_blue": (stone.plaster, dict(colour=(.16, .24, .36), seed=8), None),
    "ceiling_tile": (stone.ceiling_tile, dict(seed=9), None),
    "brick": (stone.brick, dict(colour=(.34, .13, .085), mortar=(.34, .31, .28), seed=10), None),
    "brick_pale": (stone.brick, dict(colour=(.50, .44, .34), mortar=(.40, .38, .34), seed=11),
                   None),
    "tile_white": (stone.tile, dict(colour=(.68, .69, .67), grout=(.30, .30, .29), cells=4,
                                    seed=12), (.15, .04)),
    "tile_floor": (stone.checker, dict(a=(.52, .49, .42), b=(.15, .17, .18), cells=2, seed=13),
                   (.25, .04)),
    "marble": (stone.marble, dict(base=(.66, .64, .60), vein=(.30, .29, .29), seed=14),
               (.12, .05)),
    "marble_dark": (stone.marble, dict(base=(.10, .12, .115), vein=(.42, .42, .38), seed=15),
                    (.12, .05)),
    "marble_floor": (stone.marble_floor, dict(seed=16), (.10, .05)),
    "rock": (stone.rock, dict(colour=(.44, .38, .30), seed=17), None),
    "rock_dark": (stone.rock, dict(colour=(.31, .275, .235), seed=18), None),
    "soil": (stone.gravel, dict(colour=(.24, .19, .135), seed=19), None),
    "metal_plate": (metal.plate, dict(colour=(.34, .35, .36), seed=20), (.40, .45)),
    "metal_wall": (metal.panel, dict(colour=(.30, .33, .34), seed=21), (.45, .35)),
    "metal_ribbed": (metal.corrugated, dict(colour=(.33, .36, .38), seed=22), (.45, .35)),
    "metal_blue": (metal.painted, dict(colour=(.06, .13, .27), seed=23), (.40, .05)),
    "metal_orange": (metal.painted, dict(colour=(.58, .17, .035), seed=24), (.40, .05)),
    "metal_green": (metal.painted, dict(colour=(.085, .20, .11), seed=25), (.40, .05)),
    "metal_red": (metal.painted, dict(colour=(.42, .05, .035), seed=26), (.40, .05)),
    "metal_dark": (metal.painted, dict(colour=(.10, .105, .11), seed=27), (.35, .30)),
    "tread": (metal.tread, dict(colour=(.27, .28, .29), seed=28), (.40, .45)),
    "grate": (metal.grate, dict(seed=29), None),
    "hazard": (metal.hazard, dict(seed=30), (.50, .04)),
    "paint_yellow": (metal.painted, dict(colour=(.58, .40, .03), seed=37), None),
    "shutter": (metal.shutter, dict(colour=(.40, .42, .42), seed=31), (.40, .30)),
    "brass": (metal.brushed, dict(colour=(.62, .44, .17), seed=32), (.25, .80)),
    "rust": (metal.rust, dict(seed=33), None),
    "console": (metal.console, dict(seed=34), (.35, .05)),
    "locker": (metal.locker, dict(seed=35), (.40, .05)),
    "door_metal": (metal.door, dict(colour=(.20, .27, .31), seed=36), (.40, .10)),
    "crate": (wood.crate, dict(colour=(.42, .27, .135), seed=40), None),
    "crate_dark": (wood.crate, dict(colour=(.25, .16, .09), seed=41), None),
    "carton": (wood.carton, dict(seed=42), None),
    "planks": (wood.planks, dict(colour=(.33, .20, .10), boards=4, seed=43), None),
    "planks_old": (wood.planks, dict(colour=(.25, .20, .15), boards=4, seed=44), None),
    "beam": (wood.beam, dict(colour=(.26, .165, .085), seed=45), None),
    "parquet": (wood.parquet, dict(colour=(.36, .20, .095), seed=46), (.20, .04)),
    "walnut": (wood.beam, dict(colour=(.135, .07, .035), seed=47), (.30, .04)),
    "stucco": (masonry.stucco, dict(colour=(.66, .50, .31), seed=70), None),
    "stucco_pale": (masonry.stucco, dict(colour=(.68, .62, .51), seed=71), None),
    "stucco_rose": (masonry.stucco, dict(colour=(.60, .35, .25), seed=72), None),
    "rubble": (masonry.stones, dict(rows=8, columns=6, jitter=.30, colour=(.40, .33, .25),
                                    joint=(.33, .28, .21), gap=2.2, seed=73), None),
    "cobbles": (masonry.stones, dict(rows=14, columns=12, jitter=.17, colour=(.31, .275, .235),
                                     joint=(.115, .095, .07), gap=1.6, seed=74, vary=.16), None),
    "flagstones": (masonry.flagstones, dict(seed=75), (.55, .04)),
    "roof_tiles": (masonry.roof_tiles, dict(seed=76), None),
    "grass": (growth.grass, dict(colour=(.115, .17, .045), dry=(.30, .25, .095), seed=77), None),
    "foliage": (growth.foliage, dict(colour=(.15, .20, .045), seed=78), None),
    "cypress": (growth.foliage, dict(colour=(.055, .095, .035), seed=79, count=620), None),
    "bark": (growth.bark, dict(colour=(.25, .19, .135), seed=80), None),
    "straw": (growth.straw, dict(seed=81), None),
    "linen": (growth.weave, dict(colour=(.70, .68, .63), seed=82), None),
    "louvre_green": (wood.louvre, dict(colour=(.07, .17, .115), seed=83), (.5, .04)),
    "window_wood": (wood.painted, dict(colour=(.56, .53, .46), seed=84), (.45, .04)),
    "books": (wood.books, dict(seed=85), None),
    "rug": (picture.rug, dict(seed=86), None),
    "water": (picture.water, dict(seed=50), None),
    "glass": (picture.glass, dict(), None),
    "painting_dunes": (picture.dunes, dict(seed=51), None),
    "painting_squares": (picture.squares, dict(seed=52), None),
    "painting_sea": (picture.sea, dict(seed=53), None),
    "painting_rings": (picture.rings, dict(seed=54), None),
    "painting_trees": (picture.trees, dict(seed=55), None),
    "painting_field": (picture.field, dict(seed=56), None),
    "sign_exit": (picture.sign, dict(glyph="arrow", colour=(.03, .36, .12)), None),
    "sign_a": (picture.sign, dict(glyph="A", colour=(.62, .40, .02)), None),
    "sign_b": (picture.sign, dict(glyph="B", colour=(.62, .40, .02)), None),
    "sign_c": (picture.sign, dict(glyph="C", colour=(.62, .40, .02)), None),
    "sign_d": (picture.sign, dict(glyph="D", colour=(.62, .40, .02)), None),
    "sign_e": (picture.sign, dict(glyph="E", colour=(.62, .40, .02)), None),
    "sign_f": (picture.sign, dict(glyph="F", colour=(.62, .40, .02)), None),
    "lamp_cool": (lamp_face.tube, dict(colour=(.80, .91, 1.0)), None),
    "lamp_warm": (lamp_face.tube, dict(colour=(1.0, .78, .50)), None),
    "lamp_panel": (lamp_face.panel, dict(colour=(1.0, .93, .82)), None),
    "lamp_sodium": (lamp_face.bulb, dict(colour=(1.0, .56, .18)), None),
    "lamp_red": (lamp_face.bulb, dict(colour=(1.0, .08, .04)), None),
    "lamp_green": (lamp_face.bulb, dict(colour=(.12, 1.0, .28)), None),
    "lamp_blue": (lamp_face.bulb, dict(colour=(.16, .36, 1.0)), None),
    "window_lit": (lamp_face.lit_window, dict(seed=88), None),
    "screen": (lamp_face.screen, dict(seed=60), None),
    "white": (stone.flat, dict(colour=(.75, .75, .75)), None),
    "grey": (stone.flat, dict(colour=(.30, .30, .30)), None),
    "black": (stone.flat, dict(colour=(.02, .02, .02)), None),
    "sky": (stone.flat, dict(colour=(.30, .45, .70)), None),
}

# Textures of the unit tests: linear albedo or lamp colour, one flat colour each.
TEST_TABLE = {
    "black": (0, 0, 0), "white": (1, 1, 1), "white50": (.5, .5, .5), "grey20": (.2, .2, .2),
    "red": (.6, .1, .08), "green": (.12, .5, .14), "blue": (.1, .16, .55), "sand": (.55, .45, .3),
    "lamp": (1, 1, 1), "lamp_warm": (1, .75, .45), "lamp_cool": (.7, .85, 1),
    "lamp_red": (1, .1, .05), "lamp_green": (.1, 1, .2), "glass": (.7, .85, .8),
    "sky": (.3, .45, .7), "polished": (.3, .3, .3),
}
TEST_GLOSS = {"polished": (.15, .3)}

PALETTE = 200


def paint_all():
    """All textures of the project as {name: canvas}; registers their sizes."""
    painted = {}
    for name, (paint, arguments, _) in TABLE.items():
        painted["vigil/" + name] = paint(**arguments)
    for name, colour in TEST_TABLE.items():
        painted["test/" + name] = painter.canvas((16, 16), colour)
    for name, image in painted.items():
        register_size(name, image.shape[1], image.shape[0])
    return painted


def write_all(painted, game, test_game):
    """Writes vigil/* below game and test/* below test_game (folders that hold textures/)."""
    for name, image in painted.items():
        folder = game if name.startswith("vigil/") else test_game
        path = folder / "textures" / (name + ".png")
        path.parent.mkdir(parents=True, exist_ok=True)
        flat = image.reshape(-1, 3).std(axis=0).max() == 0
        painter.save(image, path, 0 if flat else PALETTE)


def write_gloss(game, test_game):
    """Writes materials.json of both: roughness and specular reflectance of the glossy textures."""
    for folder, prefix, found in ((game, "vigil/", {name: row[2] for name, row in TABLE.items()}),
                                  (test_game, "test/", TEST_GLOSS)):
        rows = {prefix + name: {"roughness": gloss[0], "specular": gloss[1]}
                for name, gloss in found.items() if gloss}
        lines = ['  "%s": %s' % (name, json.dumps(row)) for name, row in sorted(rows.items())]
        (folder / "materials.json").write_text("{\n" + ",\n".join(lines) + "\n}\n")
