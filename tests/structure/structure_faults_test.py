#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""floors_test.py and passes_test.py find what they are to find, in folders made for them."""
import tempfile
import unittest
from pathlib import Path
from typing import Callable

import floors_test
import passes_test


def found(faults: Callable[[Path], list[str]], files: dict[str, str]) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve()
        for name, text in files.items():
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text)
        return faults(root)


class Floors(unittest.TestCase):
    def found(self, files: dict[str, str]) -> list[str]:
        return found(floors_test.faults, files)

    def test_down_is_fine(self):
        self.assertEqual(self.found({"src/common/a.h": "", "src/level/level.h": '#include "common/a.h"\n',
                                     "src/refresh/vkpt/b.cpp": '#include "level/level.h"\n'}), [])

    def test_up(self):
        lines = self.found({"src/console/cvar.h": "", "src/refresh/vkpt/gpu/a.h": '#include "console/cvar.h"\n'})
        self.assertEqual(len(lines), 1)
        self.assertIn("not below", lines[0])

    def test_circle(self):
        lines = self.found({"shaders/light/a.glsl": '#include "b.glsl"\n', "shaders/light/b.glsl": '#include "light/a.glsl"\n'})
        self.assertEqual(len(lines), 1)
        self.assertIn("circle", lines[0])

    def test_game_in_the_renderer(self):
        lines = self.found({"src/game/game.h": "", "src/refresh/vkpt/a.cpp": '#include "game/game.h"\n'})
        self.assertIn("do not know each other", lines[0])

    def test_variables_in_the_renderer(self):
        lines = self.found({"src/console/cvar.h": "", "src/refresh/vkpt/scene/a.h": '#include "console/cvar.h"\n'})
        self.assertIn("do not know each other", lines[0])

    def test_no_file_and_no_floor(self):
        lines = self.found({"src/attic/a.h": "", "src/common/a.h": '#include "common/gone.h"\n'})
        self.assertEqual(len(lines), 2)


class Passes(unittest.TestCase):
    def found(self, passes: list[str], shaders: list[str]) -> list[str]:
        rows = "".join(f'    ROW({name.upper()}, "{name}", "") \\\n' for name in passes)
        return found(passes_test.faults, {"src/refresh/vkpt/gpu/passes.h": rows} | {f"shaders/{name}.comp": "" for name in shaders})

    def test_one_name_each(self):
        self.assertEqual(self.found(["upload", "primary", "vlc_merge"], ["trace/primary", "guiding/vlc_merge", "trace/trace_rays"]), [])

    def test_pass_without_shader(self):
        self.assertEqual(self.found(["primary", "direct"], ["primary"]), ["pass direct: no shader has this name"])

    def test_shader_without_pass(self):
        self.assertEqual(self.found(["primary"], ["primary", "guiding/cdq_merge"]), ["shader cdq_merge: no pass has this name"])

    def test_no_passes(self):
        self.assertEqual(len(self.found([], [])), 1)


if __name__ == "__main__":
    unittest.main()
