#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A judge of the filter: Open Image Denoise on the raw pictures of `./run bench picture --pictures FOLDER`, beside the filter's.
This file needs nothing but Python: it makes a virtual environment (judge_requirements.txt) and hands over to denoise.py in it."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from python_environment import run_with

if __name__ == "__main__":
    sys.exit(run_with(HERE / "judge_requirements.txt", "judge", "Open Image Denoise", HERE / "denoise.py", sys.argv[1:]))
