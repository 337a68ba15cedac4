# SPDX-License-Identifier: GPL-2.0-or-later
"""The map compiler: runs qbsp and vis on a copy of a .map and brings back the .bsp alone.

The tool is ericw-tools 2 behind a command that takes the tool's name first (`ericw qbsp ...`).
Lighting is not compiled: Vigil traces it.
"""

import shutil
import subprocess
import tempfile
from pathlib import Path


def compile_map(ericw, source):
    """Compiles a .map to a .bsp beside it. A leak or an error raises RuntimeError."""
    with tempfile.TemporaryDirectory() as folder:
        maps = Path(folder) / "baseq2" / "maps"
        maps.mkdir(parents=True)
        copy = maps / source.name
        shutil.copy(source, copy)
        # No luxel subdivision: there are no light maps. One leak stops the build.
        run(ericw, "qbsp", "-q2bsp", "-subdivide", "0", "-leaktest", "-noextendedsurfflags",
            "-noextendedcontentflags", "-noallowupgrade", "-tjunc", "rotate", copy)
        run(ericw, "vis", copy.with_suffix(".bsp"))
        shutil.copy(copy.with_suffix(".bsp"), source.with_suffix(".bsp"))


def run(ericw, tool, *arguments):
    # One thread: the order in which several finish shows in the file.
    # One thread: with several, the order in which they finish could show in the file.
    done = subprocess.run([ericw, tool, "-nopercent", "-noprogress", "-nolog", "-threads", "1",
                           *map(str, arguments)],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          check=False)
    leaked = "LEAK" in done.stdout or "leak" in done.stdout.replace("leaktest", "")
    if done.returncode or leaked:
        raise RuntimeError("%s failed:\n%s" % (tool, done.stdout[-4000:]))
    for line in done.stdout.splitlines():
        if "WARNING" in line and "texture" not in line.lower():
            print("   ", line.strip())
