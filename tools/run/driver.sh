# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# A faster software Vulkan driver on Debian 12 without a graphics card, whose Mesa 22.3 runs compute at little more than half
# the speed of 25.0.

# Prints the mirror from which this system installs Debian's suite $1.
mirror_of() {
  cat /etc/apt/sources.list.d/*.sources /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null |
    awk -v suite="$1" '
      /^[ \t]*#/ { next }
      /^URIs:/ { uri = $2 }
      /^Suites:/ { for (i = 2; i <= NF; i++) if ($i == suite && uri != "") { print uri; exit } }
      /^[ \t]*$/ { uri = "" }
      /^deb / {
        sub(/\[[^]]*\]/, "")
        if ($3 == suite) { print $2; exit }
      }' || true
}

# What Debian did not sign is refused here, whatever the system's own settings allow.
only_signed=(
  -o APT::Get::AllowUnauthenticated=false
  -o Acquire::AllowInsecureRepositories=false
  -o Acquire::AllowWeakRepositories=false
  -o Acquire::AllowDowngradeToInsecureRepositories=false
)

# own_apt FOLDER COMMAND ...: apt-get with lists and cache in FOLDER, so that the system's packages and sources stay as they
# are.
own_apt() {
  local folder=$1
  shift
  APT_CONFIG=$folder/apt.conf apt-get -q "${only_signed[@]}" "$@" </dev/null
}

# make_own_apt FOLDER SUITE COMPONENT: makes the folder anew for own_apt, with that part of Debian as its only source. Fails
# where this system installs nothing from Debian.
make_own_apt() {
  local folder=$1 suite=$2 component=$3 mirror keyring=/usr/share/keyrings/debian-archive-keyring.gpg
  mirror=$(mirror_of "${suite%%-*}")
  if [ -z "$mirror" ] || [ ! -r $keyring ]; then return 1; fi
  rm -rf "$folder"
  mkdir -m 700 "$folder" || return 1
  mkdir -p "$folder"/{state,lists/partial,cache/archives/partial,files} || return 1
  echo "deb [signed-by=$keyring] $mirror $suite $component" >"$folder/sources.list"
  cat >"$folder/apt.conf" <<CONF
Dir::Etc::sourcelist "$folder/sources.list";
Dir::Etc::sourceparts "/dev/null";
Dir::Etc::preferencesparts "/dev/null";
Dir::State "$folder/state";
Dir::State::lists "$folder/lists";
Dir::State::status "/var/lib/dpkg/status";
Dir::Cache "$folder/cache";
APT::Sandbox::User "$(id -un)";
Acquire::Languages "none";
Acquire::IndexTargets::deb::DEP-11::DefaultEnabled "false";
Acquire::http::Timeout "20";
CONF
}

# fetch_mesa HOME: the driver of bookworm-backports, put together in HOME.part and then moved to HOME. Debian's signature is
# checked.
fetch_mesa() {
  local home=$1 part=$1.part
  make_own_apt "$part" bookworm-backports main || return 1
  local log=$part/log driver
  own_apt "$part" update >"$log" 2>&1 || return 1
  (cd "$part" && own_apt "$part" download mesa-vulkan-drivers/bookworm-backports) >>"$log" 2>&1 || return 1
  dpkg -x "$part"/mesa-vulkan-drivers_*.deb "$part/files" >>"$log" 2>&1 || return 1
  driver=$(cd "$part" && find files -name libvulkan_lvp.so)
  if [ -z "$driver" ]; then return 1; fi
  # Everything the driver links to must come from the installed packages, down to the last symbol.
  if ldd -r "$part/$driver" 2>&1 | grep -E 'not found|undefined symbol' >>"$log"; then return 1; fi
  rm -rf "$part/lists" "$part/cache" "$part"/*.deb
  sed "s|\"library_path\": *\"[^\"]*\"|\"library_path\": \"$home/$driver\"|" \
    "$part"/files/usr/share/vulkan/icd.d/lvp_icd*.json >"$part/lvp_icd.json" || return 1
  rm -rf "$home"
  mv "$part" "$home"
}

# younger FILE DAYS: whether FILE is there and was changed in the last DAYS days.
younger() { [ -n "$(find "$1" -prune -mtime "-$2" 2>/dev/null)" ]; }

# refresh_mesa HOME INSTALLED: a driver of this month in HOME, where that can be had. INSTALLED: the system's version.
refresh_mesa() {
  local home=$1 installed=$2
  if younger "$home/lvp_icd.json" 30; then return 0; fi
  if younger "$home-failed" 1; then return 0; fi # try again on another day
  step "Fetching a faster software Vulkan driver from bookworm-backports into $home (11 MB)"
  if fetch_mesa "$home"; then return 0; fi
  touch "$home-failed"
  if [ -e "$home/lvp_icd.json" ]; then
    note "not available: the one of last month is used (why: $home.part/log)"
  else
    note "not available: the system's Mesa $installed is used, slower (why: $home.part/log; rm $home-failed to try again)"
  fi
}

# Makes the programs that run later use the faster driver where there is one to gain: Debian 12 without a graphics card.
choose_driver() {
  [ "${VIGIL_MESA:-}" != system ] || return 0
  [ -z "${VK_DRIVER_FILES:-}${VK_ICD_FILENAMES:-}" ] || return 0 # the person chose
  local codename
  codename=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release 2>/dev/null) || return 0
  [ "$codename" = bookworm ] || return 0
  # A render node or NVIDIA's device file: the loader finds the card's driver by itself.
  if compgen -G '/dev/dri/renderD*' >/dev/null || [ -e /dev/nvidiactl ]; then return 0; fi
  local installed home
  installed=$(dpkg-query -W -f='${Version}' mesa-vulkan-drivers 2>/dev/null) || return 0
  dpkg --compare-versions "$installed" lt 25 || return 0
  if ! home=$(cache_folder); then
    note "the faster software Vulkan driver has no place: the system's Mesa $installed is used"
    return 0
  fi
  home=$home/mesa
  { flock 9 && refresh_mesa "$home" "$installed"; } 9>"$home.lock" # two runs at a time fetch it once
  if [ -e "$home/lvp_icd.json" ] && ! exposed "$home"; then
    export VK_DRIVER_FILES=$home/lvp_icd.json VK_ICD_FILENAMES=$home/lvp_icd.json
  fi
}
