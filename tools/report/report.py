#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs page.py in a virtual environment that has what it needs (requirements.txt)."""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

from python_environment import run_with

if __name__ == "__main__":
    sys.exit(run_with(HERE / "requirements.txt", "report", "what reports need", HERE / "page.py", sys.argv[1:]))
