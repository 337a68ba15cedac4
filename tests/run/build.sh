#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Which programs `./run test` builds, and when a build folder is made anew.
# shellcheck source-path=SCRIPTDIR source=check.sh
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# Programs are found before they are built: ctest then names no files.
play ctest <<'BODY'
echo 'Test project /x'
echo '  Test  #1: install_test'
echo '  Test #12: view_test'
echo '  Test #13: view_test_long'
echo '  Test #14: trace_test_128'
BODY
play ninja <<'BODY'
printf '%s: phony\n' all install trace_test view_test walk_test
BODY
expect $'trace_test\nview_test' test_targets build .

# A folder is made once, and anew for another compiler.
play cmake <<'BODY'
while [ "$1" != -B ]; do shift; done
echo "cmake ${*:3}"
mkdir -p "$2"
echo "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" >"$2/CMakeCache.txt"
touch "$2/build.ninja"
BODY
packages_are_new=''
made() { configure "$scratch/build" "$@" | sed -n 's/^cmake.* \(--fresh.*\)/\1/p'; }
expect "--fresh -DA=1" made -DA=1
expect "" made -DA=1
expect "--fresh -DA=1 -DB=2" made -DA=1 -DB=2
