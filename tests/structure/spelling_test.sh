#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# spelling_test.sh FOLDER: codespell finds no misspelt word in pages, sources, messages and scripts, but for tools/content, whose levels are full of names. Words of ours that it takes for
# mistakes are in tests/structure/our_words, one a line, in small letters. Without codespell the test is skipped (77).
set -eu
cd "$1"
command -v codespell >/dev/null || { echo "codespell is not here"; exit 77; }
exec codespell --ignore-words=tests/structure/our_words --skip='*.json,*.bin,*.bsp,*.map,*.png,*.exr,*.dm2,*.glb,*.md2,*.pak,*.pkz,*.wal,*.tga,*.jpg,./tests/fuzz/regressions,./tests/data,tests/data,tests/fuzz/regressions,tools/content' \
  README.md docs run .ci cmake src shaders tests tools
