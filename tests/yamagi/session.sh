#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# A session of Yamagi Quake II with the module, by script, under Vulkan's validation.
#   session.sh [BUILD]   menu, console, new game, walking, shooting, saving, death, loading, the other hand; then 20 changes of level
# Pictures of each step go to pictures/ in ENGINE_FOLDER. It fails for a black picture, one like the picture before it, a
# message of validation or of a sanitizer, a leak of the module, and for memory that grows from round to round of levels. A module that was
# built with sanitizers (build-asan) is run with them. See engine.sh for more.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=${1:-build}
# shellcheck source=/dev/null
source tests/yamagi/engine.sh

sanitized=''
if grep -q __asan_init "$build/ref_vigil.so"; then
  sanitized=1
  compiler=$(sed -n 's/^CMAKE_CXX_COMPILER:[^=]*=//p' "$build/CMakeCache.txt")
  library=libasan.so
  case $compiler in *clang*) library=libclang_rt.asan-$(uname -m).so ;; esac
  # A library that is closed has no names in reports of leaks.
  echo 'int dlclose(void *library) { return library == 0; }' | "$compiler" -x c -shared -fPIC - -o "$scratch/keep.so"
  # The engine loads libcurl, which waits for ever unless it was there from the start.
  engine_environment=(LD_PRELOAD="$("$compiler" -print-file-name=$library):$scratch/keep.so:libcurl.so.4"
    ASAN_OPTIONS=detect_leaks=1 LSAN_OPTIONS=exitcode=0)
fi

# judge_log LOG: fails for what a good session does not say.
judge_log() {
  if grep -aiE 'validation (error|warning)|VUID|ERROR: AddressSanitizer|runtime error|vigil: error|not finite' "$1"; then
    die "the session said that: $1"
  fi
  # The engine and the libraries leak, too: a leak is the module's if its code allocated it.
  if awk -v RS='' '/leak of/ && /\n *#[12] [^\n]*ref_vigil/ { print; found = 1 } END { exit !found }' "$1"; then
    die "the module leaks: $1"
  fi
}

# play LOG: the commands of standard input; then the log is judged. Twice a second a line of `memory` gets what the engine has
# (KiB), and how many levels it has left.
play() {
  local log=$1 size
  : >"$scratch/memory"
  (
    while sleep 0.5; do
      size=$(sed -n 's/^VmRSS:[^0-9]*\([0-9]*\).*/\1/p' "/proc/$(pgrep -n quake2)/status" 2>/dev/null) || continue
      if [ -z "$size" ]; then continue; fi # it has just ended
      echo "$size $(grep -ac 'Server restarted' "$log")" >>"$scratch/memory"
    done
  ) &
  local watcher=$!
  run_engine 320 240 "$log" +set vk_validation 2
  kill "$watcher"
  wait "$watcher" 2>/dev/null || true
  judge_log "$log"
}

# shot NAME: a picture of this step; `names` has them in order.
shot() {
  printf '%s\n' wait 'screenshot bmp' wait
}

step "Menu, game, death, load"
names=(menu console start walked shooting dead loaded left_handed)
{
  printf '%s\n' "set fixedtime 50000" "set cheats 1" menu_main
  waits 8
  shot menu
  echo newgame
  waits 12
  # The menu stays, and the game stands still, until the console has been there.
  echo toggleconsole
  waits 8
  shot console
  echo toggleconsole
  waits 30
  shot start
  echo +forward
  waits 24
  echo -forward
  shot walked
  echo +attack
  waits 6
  shot shooting
  echo -attack
  waits 10
  echo "save session"
  waits 100 # the game lets nobody end it in the first five seconds
  echo kill
  waits 30
  shot dead
  echo "load session"
  waits 24
  shot loaded
  echo "hand 1"
  waits 12
  shot left_handed
  echo quit
} | play "$scratch/session.log"

step "20 changes of level"
levels=(warehouse gallery mine yard room) # four rounds
{
  printf '%s\n' "set fixedtime 50000"
  for i in $(seq 0 19); do
    echo "map ${levels[i % 5]}"
    waits 12
  done
  echo quit
} | play "$scratch/levels.log"

step "Judging"
python3 tests/yamagi/judge_session.py "$scratch" "$home/.yq2/baseq2/scrnshot" "${sanitized:-0}" "${names[@]}"
