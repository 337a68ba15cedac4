# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Yamagi Quake II with Vigil as its renderer: finds the engine or fetches Debian's package, finds the game's data or makes the
# little that our own levels need, and starts. docs/play/quake2.md has more.

# The folder that holds an engine: quake2, and baseq2/game.so beside it. VIGIL_YQ2 says another.
installed_engine() {
  local folder
  for folder in "${VIGIL_YQ2:-}" /usr/lib/yamagi-quake2 /usr/lib/games/yamagi-quake2 /usr/libexec/yamagi-quake2 \
    /usr/lib64/yamagi-quake2 /opt/yamagi-quake2; do
    if [ -n "$folder" ] && [ -x "$folder/quake2" ] && [ -e "$folder/baseq2/game.so" ]; then
      echo "$folder"
      return
    fi
  done
  return 1
}

# fetch_engine HOME CODENAME: Debian's package, unpacked into HOME.part, then moved to HOME; nothing is installed.
fetch_engine() {
  local home=$1 part=$1.part
  make_own_apt "$part" "$2" contrib || return 1
  local log=$part/log package
  own_apt "$part" update >"$log" 2>&1 || return 1
  (cd "$part" && own_apt "$part" download yamagi-quake2 yamagi-quake2-core) >>"$log" 2>&1 || return 1
  for package in "$part"/*.deb; do
    dpkg -x "$package" "$part/files" >>"$log" 2>&1 || return 1
  done
  if [ ! -x "$part/files/usr/lib/yamagi-quake2/quake2" ]; then return 1; fi
  rm -rf "$part/lists" "$part/cache" "$part/state" "$part"/*.deb "$home"
  mv "$part" "$home"
}

# Prints the engine's folder; fetches it where this is Debian.
find_engine() {
  local home=$1 codename folder
  if folder=$(installed_engine); then
    echo "$folder"
    return
  fi
  folder=$home/engine/files/usr/lib/yamagi-quake2
  if [ ! -x "$folder/quake2" ]; then
    codename=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release 2>/dev/null) || codename=''
    step "Fetching Yamagi Quake II from Debian's contrib into $home (2 MB)" >&2
    fetch_engine "$home/engine" "${codename:-none}" ||
      die "Yamagi Quake II is not here: install the package yamagi-quake2 (on Debian: of the component contrib), or set" \
        "VIGIL_YQ2 to the folder of its program quake2 (why: $home/engine.part/log)"
  fi
  echo "$folder"
}

# Prints the folder of the game's own data, which holds baseq2/pak0.pak; VIGIL_QUAKE2 says another. None: fails.
find_game_data() {
  local folder
  for folder in "${VIGIL_QUAKE2:-}" "$HOME/.steam/steam/steamapps/common/Quake 2" \
    "$HOME/.local/share/Steam/steamapps/common/Quake 2" "$HOME/GOG Games/Quake II" "$HOME/GOG Games/Quake 2" \
    "$HOME/.yq2" /usr/share/games/quake2 /usr/local/share/games/quake2; do
    if [ -n "$folder" ] && compgen -G "$folder/baseq2/[pP][aA][kK]0.[pP][aA][kK]" >/dev/null; then
      echo "$folder"
      return
    fi
  done
  return 1
}

# lay_out ENGINE FOLDER DATA: what the engine is started from. It looks for renderers beside its program alone, so that the
# program is copied and all else are links. Without DATA, levels and a little game of our own are there too.
lay_out() {
  local engine=$1 folder=$2 data=$3 name
  rm -rf "$folder"
  mkdir -p "$folder/baseq2/maps" || return 1
  cp "$engine/quake2" "$folder/quake2" || return 1
  ln -s "$PWD/build/ref_vigil.so" "$folder/ref_vigil.so"
  for name in "$engine"/ref_*.so; do ln -s "$name" "$folder/"; done
  ln -s "$engine/baseq2/game.so" "$folder/baseq2/game.so"
  for name in baseq2/maps/*.bsp; do ln -s "$PWD/$name" "$folder/$name"; done
  for name in textures env materials.json; do ln -s "$PWD/baseq2/$name" "$folder/baseq2/$name"; done
  if [ -n "$data" ]; then return 0; fi
  python3 tools/quake2/make_game.py baseq2 "$folder/baseq2"
  ln -s "$PWD/baseq2/models/"*.glb "$folder/baseq2/models/"
}

# quake2 ARGS ...: the game, with these arguments for the engine.
quake2() {
  local home engine data folder arguments=()
  [ "$(uname -m)" = x86_64 ] || die "quake2: the module speaks the engine's interface of x86-64; this is $(uname -m)"
  [ "$(id -u)" != 0 ] || die "quake2: the engine does not start for root: do this as another user"
  home=$(cache_folder) || die "quake2: there is no place for it"
  home=$home/quake2
  mkdir -p "$home"
  engine=$(find_engine "$home") || exit 1
  set_up game
  configure build
  step "Building build/ref_vigil.so"
  ninja -C build ref_vigil
  folder=$home/run
  if data=$(find_game_data); then
    note "game data: $data"
    arguments=(-datadir "$data")
  else
    data=''
    note "no game data found (VIGIL_QUAKE2=FOLDER says where): levels and a little game of Vigil's own"
    arguments=(-datadir "$folder" +set s_initsound 0)
    # Without a command the engine waits for a film that is not there.
    if [ $# = 0 ]; then set -- +menu_main; fi
  fi
  lay_out "$engine" "$folder" "$data" || die "quake2: cannot make $folder"
  mkdir -p "${XDG_DATA_HOME:-$HOME/.local/share}" # which versions since 8.70 expect
  choose_driver
  cd "$folder"
  exec ./quake2 "${arguments[@]}" +set vid_renderer vigil +set allow_download 0 "$@"
}
