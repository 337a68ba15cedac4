# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Libraries that some systems have no package of. Their sources come from the authors' repositories, at a commit that is
# written here, into the cache folder.

source_table() {
  cat <<'TABLE'
imgui   https://github.com/ocornut/imgui.git v1.91.9b f5befd2d29e66809cd1110a152e375a7f1981f06
tinyexr https://github.com/syoyo/tinyexr.git v1.0.7   6e8cac308cdf4d717078f3f37c4aa39bf3b356b4
TABLE
}

source_folder() {
  local cache
  cache=$(cache_folder) || return 1
  echo "$cache/sources/$1"
}

# fetch_source NAME: from address, tag and commit of the table.
fetch_source() {
  local folder name url tag commit
  folder=$(source_folder "$1") || return 1
  read -r name url tag commit < <(source_table | grep "^$1 ")
  note "fetching the sources of $name $tag into $folder"
  mkdir -p "$(dirname "$folder")"
  rm -rf "$folder" "$folder.part"
  git clone -q --depth 1 --branch "$tag" -c advice.detachedHead=false "$url" "$folder.part" || return 1
  if [ "$(git -C "$folder.part" rev-parse HEAD)" != "$commit" ]; then
    note "$url: $tag is not the commit $commit: not used"
    rm -rf "$folder.part"
    return 1
  fi
  mv "$folder.part" "$folder"
}

# Prints CMake's options for the sources that were fetched.
source_options() {
  local folder
  if folder=$(source_folder imgui 2>/dev/null) && [ -d "$folder" ]; then echo "-DVIGIL_IMGUI_SOURCE=$folder"; fi
  if folder=$(source_folder tinyexr 2>/dev/null) && [ -d "$folder" ]; then echo "-DVIGIL_tinyexr_INCLUDE=$folder"; fi
}
