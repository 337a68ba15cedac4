# SPDX-License-Identifier: GPL-2.0-or-later
"""Renders levels with Vigil and with Mitsuba 3 and says whether they agree: one row per level, exit status 1 if one does
not, 3 if nothing could be compared. Started by crosscheck.py inside Mitsuba's environment."""

import argparse
import json
import os
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

SOURCE = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / "tools"))

import agreement
import gltf_scene
import vigil_pictures
from python_environment import UNAVAILABLE
from verdict import status_of

SHARED = Path(os.environ.get("VIGIL_SHARED") or SOURCE.parent / "shared") / "levels"
# Tried in this order; the vectorised one needs LLVM's shared library (libllvm15 or newer in Debian).
VARIANTS = ("llvm_ad_rgb", "scalar_rgb")


@dataclass
class Level:
    name: str
    basedir: Path
    view: tuple = ()  # x y z pitch yaw roll; none: where the player starts
    variables: tuple = ()  # pairs
    map: str = ""  # none: the name


LEVELS = {level.name: level for level in [
    *(Level(name, SOURCE / "tests" / "data") for name in ("lamp", "rooms", "opensky")),
    # Where all walls shine, points on them are no way to sample light: the variance near corners is infinite.
    Level("furnace", SOURCE / "tests" / "data", variables=(("pt_nee", "brute"),)),
    *(Level(name, SOURCE) for name in ("warehouse", "mine", "gallery", "yard", "room")),
    # Under the hole in the roof, where the sun shines in; with its disc, and as a point.
    Level("mine_sun", SOURCE, view=(700, 466, 62, 0, 36, 0), map="mine"),
    Level("mine_point", SOURCE, view=(700, 466, 62, 0, 36, 0), variables=(("pt_sun_size", 0),), map="mine"),
    Level("e3m6", SHARED), Level("e1m1", SHARED)]}


def arguments():
    parser = argparse.ArgumentParser(description="Compares Vigil's pictures with Mitsuba's, of scenes that Vigil exported.")
    parser.add_argument("vigil", type=Path, help="the program, build/vigil")
    parser.add_argument("out", type=Path, help="folder for exports, pictures and scores")
    parser.add_argument("levels", nargs="*", default=list(LEVELS), help="of " + " ".join(LEVELS))
    parser.add_argument("--size", type=int, nargs=2, default=(160, 96), metavar=("WIDTH", "HEIGHT"))
    parser.add_argument("--batches", type=int, default=8, help="independent ones, on either side")
    parser.add_argument("--spp", type=int, default=32, help="paths per pixel of a batch (a multiple of 8)")
    parser.add_argument("--seed", type=int, default=0, help="another number: other random numbers on both sides")
    parser.add_argument("--region", type=int, default=8, help="side of the compared squares in pixels")
    parser.add_argument("--rounding", type=float, default=5e-4,
                        help="relative standard error allowed for numbers rounded on the way")
    parser.add_argument("--integrator", choices=("auto", "path", "short"), default="auto",
                        help="path: Mitsuba's own; short: short_paths.py; auto: path where it can say the scene")
    parser.add_argument("--variant", choices=VARIANTS, help="of Mitsuba; default: the first that works here")
    parser.add_argument("--exact-texels", action="store_true",
                        help="the exported 8-bit colours unrounded: shows what Vigil's texture format costs")
    parser.add_argument("--spoil", type=float, default=1.0, metavar="FACTOR",
                        help="on the radiance of Mitsuba's lamps: shows that the comparison can fail")
    parser.add_argument("--json", type=Path, metavar="FILE", help="write the rows there, too")
    parser.add_argument("--set", nargs=2, action="append", default=[], metavar=("VARIABLE", "VALUE"),
                        help="one more variable for Vigil")
    options = parser.parse_args()
    unknown = [name for name in options.levels if name not in LEVELS]
    if unknown:
        parser.error(f"{unknown[0]}: not one of {' '.join(LEVELS)}")
    if options.json:
        options.json.parent.mkdir(parents=True, exist_ok=True)
    if options.spp % 8 or options.batches < 2:
        parser.error("--spp must be a multiple of 8, --batches at least 2")
    return options


def works(variant):
    """Compiling a kernel with an LLVM that is too old ends the whole program, so another one tries it."""
    trial = ("import mitsuba as mi; mi.set_variant(%r); mi.render(mi.load_dict(mi.cornell_box()), spp=1).numpy()"
             % variant)
    return subprocess.run([sys.executable, "-c", trial], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                          check=False).returncode == 0


def needs_short_paths(scene):
    return len(scene.sky_faces) > 0 or scene.sun_irradiance is not None or any(s.material.f0 > 0 or s.material.coverage < 1 for s in scene.surfaces)


def render(exported, folder, options):
    """(batches, height, width, 3) of Mitsuba, and which integrator it was."""
    import mitsuba as mi
    import mitsuba_scene
    width, height = options.size
    for surface in exported.surfaces:
        surface.material.radiance = options.spoil * surface.material.radiance
    short = options.integrator == "short" or (options.integrator == "auto" and needs_short_paths(exported))
    scene, materials = mitsuba_scene.build(exported, folder, width, height, options.exact_texels, sun=not short)
    pictures = []
    seeds = range(1000 * options.seed, 1000 * options.seed + options.batches)
    if short:
        import short_paths
        tracer = short_paths.Tracer(scene, exported, materials)
        tracer.learn_lamps(scene.sensors()[0], width, height, 8)
        for seed in seeds:
            pictures.append(tracer.picture(scene.sensors()[0], width, height, options.spp, seed))
    else:
        # Emission seen directly, light at the first hit, light at the second: three edges.
        integrator = mi.load_dict({"type": "path", "max_depth": 3, "rr_depth": 1000})
        for seed in seeds:
            pictures.append(np.array(mi.render(scene, integrator=integrator, spp=options.spp, seed=seed)))
    return np.stack(pictures).astype(np.float64), "short" if short else "path"


def vigil_batches(level, folder, options):
    import mitsuba as mi
    width, height = options.size
    said = vigil_pictures.run(options.vigil.resolve(), level, folder.resolve(), width, height, options.batches,
                              options.seed, options.spp // 8, 8, [*level.variables, *options.set])
    (folder / "vigil.log").write_text(said)
    pictures = [np.array(mi.Bitmap(str(folder / f"{level.name}_{batch}.exr")).convert(
        mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False)) for batch in range(1, options.batches + 1)]
    return np.stack(pictures).astype(np.float64)


def write_pictures(folder, vigil, mitsuba, scores):
    """vigil.exr, mitsuba.exr, and scores.exr: red where Vigil is brighter, blue where it is darker (in standard errors)."""
    import mitsuba as mi
    red_blue = np.stack([np.maximum(scores, 0), np.zeros_like(scores), np.maximum(-scores, 0)], -1)
    for name, picture in (("vigil", vigil.mean(0)), ("mitsuba", mitsuba.mean(0)), ("scores", red_blue)):
        mi.Bitmap(picture.astype(np.float32)).write(str(folder / f"{name}.exr"))


def row(name, result, paths, seconds):
    difference = " ".join("%+.3f+-%.3f%%" % (100 * d, 100 * e) for d, e in zip(result.difference, result.error))
    return "%-10s %7d %7.2f %6.2f (%.2f) %8.4f  %s  %-5s %4.0f s  %s" % (
        name, result.regions, result.mean_z, result.max_z, result.max_z_limit, result.chi2_p, difference, paths,
        seconds, "agrees" if result.agrees else "DISAGREES")


def json_row(name, result, paths):
    return {"label": name, "paths": paths, "agrees": bool(result.agrees), "regions": int(result.regions), "max_z": float(result.max_z),
            "max_z_limit": float(result.max_z_limit), "chi2_p": float(result.chi2_p),
            "difference": dict(zip(("red", "green", "blue"), map(float, result.difference))),
            "error": dict(zip(("red", "green", "blue"), map(float, result.error)))}


def check(name, options, rows):
    """True if the level agrees, False if not, None if it is not here. What was measured goes to `rows`."""
    level, folder, start = LEVELS[name], options.out / name, time.monotonic()
    bsp = Path("baseq2") / "maps" / f"{level.map or name}.bsp"
    if not (level.basedir / bsp).is_file():
        print("%-10s skipped: there is no %s/%s" % (name, level.basedir.name, bsp), flush=True)
        return None
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    vigil = vigil_batches(level, folder, options)
    exported = gltf_scene.read_gltf(folder / f"{name}.gltf")
    mitsuba, paths = render(exported, folder, options)
    result = agreement.compare(vigil, mitsuba, options.region, options.rounding)
    write_pictures(folder, vigil, mitsuba, result.scores)
    np.savez_compressed(folder / "batches.npz", vigil=vigil.astype(np.float32), mitsuba=mitsuba.astype(np.float32))
    print(row(name, result, paths, time.monotonic() - start), flush=True)
    rows.append(json_row(name, result, paths))
    return result.agrees


def main():
    options = arguments()
    variant = options.variant or next((v for v in VARIANTS if works(v)), None)
    if variant is None:
        print("crosscheck: compared nothing: Mitsuba 3 does not run here")
        return UNAVAILABLE
    import mitsuba as mi
    mi.set_variant(variant)
    mi.set_log_level(mi.LogLevel.Warn)
    print(f"Mitsuba {mi.__version__}, {variant}; {options.batches} batches of {options.spp} paths per pixel on either side")
    print("%-10s %7s %7s %13s %9s  %-47s %s" % ("level", "regions", "mean z", "max|z| (limit)", "chi2 p",
                                               "Vigil / Mitsuba - 1: red, green, blue", "paths"))
    rows = []
    status = status_of([check(name, options, rows) for name in options.levels])
    if options.json:
        options.json.write_text(json.dumps({"measured": "crosscheck", "mitsuba": mi.__version__, "batches": options.batches, "spp": options.spp,
                                            "parts": [{"part": "all", "rows": rows}]}, indent=1) + "\n")
    return status


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (vigil_pictures.VigilFailed, OSError) as error:
        print(f"crosscheck: {error}")
        sys.exit(2)
