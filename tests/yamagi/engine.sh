# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Yamagi Quake II with the module of folder $build, on our levels, under a display of its own: for the scripts beside this one,
# which are in the project's folder. They end with status 77 where the engine is missing (VIGIL_YQ2 names its folder). As
# root they start the engine as nobody: it does not start for root. What they make stays where ENGINE_FOLDER names a folder.

step() { printf '== %s\n' "$*"; }
note() { :; }
die() { printf '%s\n' "$*" >&2; exit 1; }
skip() { printf 'skipped: %s\n' "$*"; exit 77; }
for part in cache packages sources driver build quake2; do
  # shellcheck source=/dev/null
  source "tools/run/$part.sh"
done

# ---- what there is ----

engine=$(installed_engine) || engine=$(cache_folder)/quake2/engine/files/usr/lib/yamagi-quake2
[ -x "$engine/quake2" ] || skip "Yamagi Quake II is not here; ./run quake2 fetches it, VIGIL_YQ2 names its folder"
for program in Xvfb python3 setpriv; do
  command -v "$program" >/dev/null || skip "$program is not installed"
done
[ -e "$build/ref_vigil.so" ] || die "$build has no ref_vigil.so: build it"

scratch=${ENGINE_FOLDER:-$(mktemp -d)}
mkdir -p "$scratch"
scratch=$(cd "$scratch" && pwd)
display_process=''
leave() {
  if [ -n "$display_process" ]; then kill "$display_process" 2>/dev/null || true; fi
  if [ -z "${ENGINE_FOLDER:-}" ]; then rm -rf "$scratch"; fi
}
trap leave EXIT

data=$scratch/run
lay_out "$engine" "$data" ''
# The player may not see the folders that these are in.
cp --remove-destination "$build/ref_vigil.so" "$data/"
cp --remove-destination "$engine/baseq2/game.so" "$data/baseq2/"
home=$scratch/home
mkdir -p "$home/.yq2/baseq2/demos" "$home/.local/share" "$scratch/out/demos" "$scratch/pictures"

as_player=()
if [ "$(id -u)" = 0 ]; then
  chown -R 65534 "$home"
  chmod a+rx "$scratch"
  chmod -R a+rX "$data"
  as_player=(setpriv --reuid=65534 --clear-groups)
fi
# The chosen driver may lie in a folder that the player cannot read.
driver=${VK_DRIVER_FILES:-${VK_ICD_FILENAMES:-}}
if [ -n "$driver" ] && [ "$(id -u)" = 0 ]; then
  cp -r "$(dirname "$driver")" "$scratch/driver"
  sed -i "s|$(dirname "$driver")|$scratch/driver|" "$scratch/driver/$(basename "$driver")"
  chmod -R a+rX "$scratch/driver"
  driver=$scratch/driver/$(basename "$driver")
fi

exec 3<>"$scratch/display"
Xvfb -displayfd 3 -screen 0 1280x720x24 >/dev/null 2>&1 &
display_process=$!
for _ in $(seq 50); do
  sleep 0.2
  if [ -s "$scratch/display" ]; then break; fi
done
exec 3>&-
[ -s "$scratch/display" ] || skip "Xvfb does not start"

# run_engine WIDTH HEIGHT LOG [ARGUMENTS]: with the commands of standard input, which it takes from a file: it has room for 50
# words. engine_environment has more variables of the environment.
engine_environment=()
run_engine() {
  local width=$1 height=$2 log=$3
  shift 3
  cat >"$home/.yq2/baseq2/commands.cfg"
  rm -f "$home/.yq2/baseq2/config.cfg"
  if ! (cd "$data" && exec timeout 1800 "${as_player[@]}" env -i PATH="$PATH" HOME="$home" LANG=C.UTF-8 \
    DISPLAY=":$(cat "$scratch/display")" ${driver:+VK_DRIVER_FILES="$driver" VK_ICD_FILENAMES="$driver"} \
    SDL_AUDIODRIVER=dummy "${engine_environment[@]}" ./quake2 -datadir "$data" +set vid_renderer vigil +set s_initsound 0 \
    +set allow_download 0 +set vid_fullscreen 0 +set r_mode -1 +set r_customwidth "$width" +set r_customheight "$height" \
    +set r_vsync 0 +set vigil_headless "${headless:-0}" "$@" +exec commands.cfg) >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    die "the engine ended badly"
  fi
}

# waits N: so many of the engine's frames.
waits() { for _ in $(seq "$1"); do echo wait; done; }
