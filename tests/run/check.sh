# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# What the tests of `./run` share: its parts, a folder that goes away, and checks. A failed check ends the test.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

step() { printf '== %s\n' "$*"; }
note() { printf '   %s\n' "$*"; }
die() {
  printf 'run: %s\n' "$*" >&2
  exit 1
}
for part in cache packages sources driver build tests skips fuzz quake2; do
  # shellcheck source=/dev/null
  source "tools/run/$part.sh"
done

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export HOME=$scratch/home
unset XDG_CACHE_HOME CI VK_DRIVER_FILES VK_ICD_FILENAMES VIGIL_MESA
mkdir -m 755 "$HOME"

failed() {
  printf 'FAILED, line %s: %s\n' "${BASH_LINENO[-2]}" "$*" >&2
  exit 1
}

# expect WANTED COMMAND ...: what the command prints, and that it succeeds.
expect() {
  local wanted=$1 got
  shift
  got=$("$@" 2>&1) || failed "$*: failed: $got"
  [ "$got" = "$wanted" ] || failed "$*: '$got', not '$wanted'"
}

# refuses WORDS COMMAND ...: that the command fails and says WORDS.
refuses() {
  local words=$1 got
  shift
  if got=$("$@" 2>&1); then failed "$*: succeeded: $got"; fi
  [[ "$got" == *"$words"* ]] || failed "$*: '$got' says nothing of '$words'"
}

# A command of the system for the rest of the test: play NAME <<'BODY'.
play() {
  mkdir -p "$scratch/bin"
  {
    echo '#!/bin/bash'
    cat
  } >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
  PATH=$scratch/bin:${PATH#"$scratch/bin:"}
}
