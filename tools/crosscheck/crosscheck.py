#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A second opinion on Vigil's pictures: renders exported levels with Mitsuba 3 and compares (docs/research/crosscheck.md). This
file needs nothing but Python: it makes Mitsuba's virtual environment and hands over to compare.py inside it."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from python_environment import run_with

if __name__ == "__main__":
    sys.exit(run_with(HERE / "requirements.txt", "crosscheck", "Mitsuba 3", HERE / "compare.py", sys.argv[1:]))
