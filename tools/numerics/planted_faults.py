#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Plants faults, one at a time, in a copy of the project, and demands that the tests named beside each fail.

usage: planted_faults.py [--list] [FOLDER [WORD]]

FOLDER (default build-faults) receives the copy and its build; only faults whose name holds WORD are planted. Run it in
the project's folder. The exit status is 1 if a fault went unnoticed or the tests failed without one. A fault is
one line of one file; when that line has changed, the fault is reported as out of date and must be written anew.
"""

import os
import shutil
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path


@dataclass
class Fault:
    name: str
    file: str
    before: str  # occurs once in the file
    after: str
    target: str  # the test's build target
    program: str  # below the build folder
    tests: str  # GoogleTest filter
    environment: dict[str, str] = field(default_factory=dict)  # of the tests, more than this program's own


CDQ = ("cdq_test", "tests/cdq/cdq_test")
SAMPLING = ("light_sampling_test", "tests/light/light_sampling_test")
IMPORTANCE = ("light_importance_test", "tests/light/light_importance_test")
NUMERICS = ("numerics_test", "tests/numerics/numerics_test")
OCTREE = ("guiding_octree_test", "tests/guiding/guiding_octree_test")
GUIDING = ("guiding_passes_test", "tests/guiding/guiding_passes_test")
FRAMES = ("vkpt_frames_test", "tests/vkpt/vkpt_frames_test")
GPU_ASSISTED = {"VIGIL_VALIDATION": "3", "GALLIVM_PERF": "nopt"}  # as in ./run test long

FAULTS = [
    Fault("pdf off by 1%: directions of quadtrees", "shaders/shared/cdq.h",
          "float(cdq_leaf_count(bits)) * octahedral_density(direction);",
          "float(cdq_leaf_count(bits)) * (1.01f * octahedral_density(direction));", *CDQ, "*Sampling*"),
    Fault("pdf off by 1%: points of near lights", "shaders/shared/triangle_light.h",
          "        seen.pdf = 1.0f / near.solid_angle;", "        seen.pdf = 1.01f / near.solid_angle;",
          *SAMPLING, "TriangleLight*:SphericalTriangle*"),
    Fault("pdf off by 1%: the cosine lobe", "shaders/shared/brdf.h",
          "    seen.pdf = nl * INVERSE_PI;", "    seen.pdf = 1.01f * nl * INVERSE_PI;", *IMPORTANCE, "Brdf*"),
    Fault("pdf off by 1%: the octahedral map", "shaders/shared/octahedral.h",
          "return 0.25f / (sum * sum * sum);", "return 0.2525f / (sum * sum * sum);", *NUMERICS, "Directions*"),
    Fault("a missing horizon clip", "shaders/shared/ltc.h",
          "bool clipped = min(height.x, min(height.y, height.z)) < 0.0f;", "bool clipped = false;",
          *IMPORTANCE, "FormFactor*"),
    Fault("off by one in a shift: migrating leaves", "shaders/shared/cdq.h",
          "(field.x >> 4u) | (field.y << 28u)", "(field.x >> 4u) | (field.y << 27u)", *CDQ, "*Migrations*"),
    Fault("off by one in a shift: octree paths", "shaders/shared/octree.h",
          "const uint shift = OCTREE_MAX_DEPTH - 1u - depth;", "const uint shift = OCTREE_MAX_DEPTH - depth;",
          *OCTREE, "Octree*"),
    Fault("a carry is lost in the alias table", "shaders/shared/alias_table.h",
          "slot.column = high_integer + carry;", "slot.column = high_integer;", *SAMPLING, "AliasTable*"),
    Fault("infinity passes the firewall", "shaders/shared/firewall.h",
          "bits <= 0x7f7fffffu", "bits <= 0x7f800000u", *NUMERICS, "Firewall*"),
    Fault("random streams repeat after 2^30 paths", "shaders/shared/random.h",
          "(path.y << 2u) | (path.x >> 30u);", "0u * path.y;", *NUMERICS, "LongRuns*"),
    Fault("the running mean forgets what it rounds away", "shaders/shared/running_mean.h",
          "    carry = rest;", "    carry = 0.0f * rest;", *NUMERICS, "LongRuns*"),
    Fault("a hash bucket overflows by one", "shaders/guiding/light_table.glsl",
          "const uint end = first + settings.bucket;", "const uint end = first + settings.bucket + 1u;",
          *GUIDING, "*FullTables*:*EveryBucketSize*"),
    Fault("a write past a buffer's end in the path tracer", "shaders/pathtrace/direct.comp",
          "primary_hits[index].flags |= flags;", "primary_hits[index + 5000000u].flags |= flags;",
          *FRAMES, "*/uniform", GPU_ASSISTED),
]


def run(command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


def copy_project(folder):
    """What git knows, as it is now; files that have not changed keep their time, so that a second run builds little."""
    for name in run(["git", "ls-files", "-z"], check=True).stdout.split("\0"):
        source, copy = Path(name), folder / "source" / name
        if not name or not source.is_file():
            continue
        if not copy.exists() or copy.read_bytes() != source.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, copy)


def build_and_test(folder, fault):
    """Whether the fault's tests pass; a build that fails is an error of the table, not a fault found."""
    built = run(["ninja", "-C", str(folder / "build"), fault.target])
    if built.returncode != 0:
        sys.exit(f"{fault.name}: it does not build\n{built.stdout[-3000:]}")
    program = str((folder / "build" / fault.program).resolve())
    try:
        return run([program, "--gtest_filter=" + fault.tests], cwd=folder / "build", timeout=600,
                   env={**os.environ, **fault.environment}).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def plant(folder, fault):
    """True if the tests noticed."""
    path = folder / "source" / fault.file
    text = path.read_text(encoding="utf-8")
    if text.count(fault.before) != 1:
        sys.exit(f"{fault.name}: out of date: its line is not, or not once, in {fault.file}")
    path.write_text(text.replace(fault.before, fault.after), encoding="utf-8")
    try:
        return not build_and_test(folder, fault)
    finally:
        path.write_text(text, encoding="utf-8")


def main(arguments):
    if "--list" in arguments:
        print("\n".join(fault.name for fault in FAULTS))
        return
    folder = Path(arguments[0] if arguments else "build-faults").resolve()
    word = arguments[1] if len(arguments) > 1 else ""
    faults = [fault for fault in FAULTS if word in fault.name]
    if not faults:
        sys.exit(f"no fault's name holds '{word}'; --list tells them")
    copy_project(folder)
    configured = run(["cmake", "-G", "Ninja", "-S", str(folder / "source"), "-B", str(folder / "build"),
                      "-DCMAKE_BUILD_TYPE=RelWithDebInfo"])
    if configured.returncode != 0:
        sys.exit(f"cmake failed\n{configured.stderr[-3000:]}")
    unnoticed = 0
    sound = set()  # tests that pass without a fault
    for fault in faults:
        key = (fault.target, fault.tests)
        if key not in sound and not build_and_test(folder, fault):
            sys.exit(f"{fault.target} {fault.tests} fails without a fault")
        sound.add(key)
        noticed = plant(folder, fault)
        unnoticed += not noticed
        print(f"{'noticed  ' if noticed else 'UNNOTICED'}  {fault.name}  ({fault.target} {fault.tests})", flush=True)
    sys.exit(1 if unnoticed else 0)


if __name__ == "__main__":
    main(sys.argv[1:])
