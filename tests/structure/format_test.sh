#!/bin/sh
# SPDX-License-Identifier: GPL-2.0-or-later
# format_test.sh FOLDER: C++ is as .clang-format says, GLSL and shared headers as shaders/.clang-format. Versions of clang-format
# differ in details, so one of them decides: without it the test is skipped (77). `clang-format-14 -i FILE` mends what it names,
# with `--style=file:shaders/.clang-format` a shader of a test.
set -eu
cd "$1"
for program in clang-format-14 clang-format; do
  if "$program" --version 2>/dev/null | grep -q 'version 14\.'; then
    find src shaders tests tools \( -name '*.h' -o -name '*.cpp' \) -exec "$program" --dry-run --Werror {} +
    find shaders tests \( -name '*.glsl' -o -name '*.comp' \) -exec \
      "$program" --style=file:shaders/.clang-format --dry-run --Werror {} +
    exit 0
  fi
done
echo "clang-format 14 is not here"
exit 77
