# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The folder for what is fetched or made once: drivers, sources, systems. Programs and libraries in it are run, so that it must
# be the person's own.

# Whether others could put something into folder $1: it is not ours, or its permissions let them, or those of the folder
# around it. Prints the reason.
exposed() {
  local folder=$1 around owner mode
  around=$(dirname "$folder")
  if [ -L "$folder" ]; then
    echo "$folder is a link"
  elif [ ! -O "$folder" ]; then
    echo "$folder belongs to somebody else"
  elif mode=$(stat -c %a "$folder") && ((0$mode & 022)); then
    echo "others can write to $folder"
  elif owner=$(stat -c %u "$around") && [ "$owner" != "$(id -u)" ] && [ "$owner" != 0 ]; then
    echo "$around belongs to somebody else"
  elif mode=$(stat -c %a "$around") && ((0$mode & 022 && !(0$mode & 01000))); then
    echo "others can write to $around"
  else
    return 1
  fi
}

# Prints the cache folder, which it makes if needed. Fails, with a message, where there is no place that is only ours; a shared
# temporary folder is none.
cache_folder() {
  local base=${XDG_CACHE_HOME:-} folder reason
  case $base in
  /*) ;;
  *)
    case ${HOME:-} in
    /*) base=$HOME/.cache ;;
    *)
      echo "run: HOME is not set: there is no folder of yours to keep things in" >&2
      return 1
      ;;
    esac
    ;;
  esac
  folder=$base/vigil
  if [ ! -d "$folder" ] && ! { mkdir -p "$base" && mkdir -m 700 "$folder"; }; then return 1; fi
  if reason=$(exposed "$folder"); then
    echo "run: $reason: nothing in it can be trusted" >&2
    return 1
  fi
  chmod 700 "$folder" || return 1
  echo "$folder"
}
