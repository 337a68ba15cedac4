# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs the program without a window: one export of a level's view, and batches of averaged radiance with a seed each."""

import subprocess

# What must be the same on both sides: uniform lamps, steady styles, rays spread over each pixel, textures without mip levels. The sun has the
# level's own size.
SETTINGS = {"vid_driver": "headless", "pt_emissive_texture": 0, "pt_light_styles": 0, "pt_jitter": 1,
            "pt_texture_filter": "full", "pt_bounces": 1}


class VigilFailed(Exception):
    pass


def run(vigil, level, folder, width, height, batches, seed, frames, spp, extra):
    """Writes LEVEL.gltf and LEVEL_1.exr ... into `folder`; returns what the program said. `level`: a crosscheck Level.
    `extra`: more variables, as pairs."""
    command = [str(vigil), "+set", "basedir", str(level.basedir), "+set", "outdir", str(folder),
               "+set", "vid_width", str(width), "+set", "vid_height", str(height), "+set", "pt_spp", str(spp)]
    for name, value in [*SETTINGS.items(), *extra]:
        command += ["+set", name, str(value)]
    command += ["+map", level.map or level.name]
    if level.view:
        command += ["+noclip", "+setviewpos", *map(str, level.view)]
    command += ["+wait", "1", "+exportscene", f"{level.name}.gltf", "+set", "pt_accumulate", "1"]
    for batch in range(1, batches + 1):
        command += ["+set", "pt_seed", str(1000 * seed + batch), "+wait", str(frames), "+screenshot_hdr", f"{level.name}_{batch}"]
    done = subprocess.run(command + ["+quit"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          stdin=subprocess.DEVNULL, check=False)
    # What must be there says whether it went well: at the console an error ends a command, not the program.
    missing = [p for p in [f"{level.name}.gltf", *(f"{level.name}_{b}.exr" for b in range(1, batches + 1))]
               if not (folder / p).is_file()]
    if done.returncode != 0 or missing:
        raise VigilFailed(f"{level.name}: vigil ended with {done.returncode}, without {missing[:1]}:\n{done.stdout}")
    return done.stdout
