#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The engine that is installed is taken before one is fetched, and what is started holds engine, module and data.
# shellcheck source-path=SCRIPTDIR source=check.sh
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# An engine, and where one is looked for.
engine=$scratch/engine
mkdir -p "$engine/baseq2"
touch "$engine/baseq2/game.so" "$engine/ref_gl1.so"
printf '#!/bin/sh\necho engine "$@"\n' >"$engine/quake2"
VIGIL_YQ2=$engine
if installed_engine | grep -q "$engine"; then failed "a file that cannot be run was taken for the engine"; fi
chmod +x "$engine/quake2"
expect "$engine" installed_engine
expect "$engine" find_engine "$scratch/cache"
unset VIGIL_YQ2

# One is fetched once; where that fails, it is said what to do.
installed_engine() { return 1; }
fetch_engine() {
  echo fetched >>"$scratch/fetched"
  if [ -n "${fails:-}" ]; then return 1; fi
  mkdir -p "$1/files/usr/lib"
  cp -r "$engine" "$1/files/usr/lib/yamagi-quake2"
}
fails=yes
refuses "install the package yamagi-quake2" find_engine "$scratch/cache"
fails=''
find_engine "$scratch/cache" >"$scratch/found" 2>/dev/null
expect "$scratch/cache/engine/files/usr/lib/yamagi-quake2" cat "$scratch/found"
find_engine "$scratch/cache" >/dev/null
expect 2 grep -c fetched "$scratch/fetched"

# The game's own data.
if find_game_data >/dev/null; then
  : # it is installed here
else
  mkdir -p "$HOME/.yq2/baseq2"
  if find_game_data >/dev/null; then failed "a folder without an archive was taken for data"; fi
  touch "$HOME/.yq2/baseq2/PAK0.PAK"
  expect "$HOME/.yq2" find_game_data
fi
mkdir -p "$scratch/data/baseq2"
touch "$scratch/data/baseq2/pak0.pak"
VIGIL_QUAKE2=$scratch/data
expect "$scratch/data" find_game_data

# What is started: with data of the game, nothing of ours is in its way.
lay_out "$engine" "$scratch/with" "$scratch/data"
expect "engine +map x" "$scratch/with/quake2" +map x
for name in ref_vigil.so ref_gl1.so baseq2/game.so baseq2/maps/warehouse.bsp; do
  [ -L "$scratch/with/$name" ] || failed "no link $name"
done
[ ! -e "$scratch/with/baseq2/pics" ] || failed "pictures of ours hide those of the game"
if command -v python3 >/dev/null; then
  lay_out "$engine" "$scratch/own" ''
  for name in pics/conchars.png models/monsters/soldier/tris.md2 players/male/grunt.pcx maps/warehouse.ent yq2.cfg; do
    [ -s "$scratch/own/baseq2/$name" ] || failed "no $name"
  done
fi
