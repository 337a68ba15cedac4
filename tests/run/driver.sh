#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The fetched driver: what nobody signed is refused whatever the system's settings allow, one of last month is fetched again,
# and a failure keeps what there is.
# shellcheck source-path=SCRIPTDIR source=check.sh
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# The real apt, and a source that has no signature at all.
if command -v apt-get >/dev/null; then
  folder=$scratch/apt
  mkdir -p "$folder"/{state,lists/partial,cache/archives/partial,source/dists/any/main/binary-all}
  : >"$folder/source/dists/any/main/binary-all/Packages"
  printf '%s\n' "Suite: any" "Codename: any" "Components: main" "Architectures: all" "SHA256:" \
    " $(sha256sum </dev/null | cut -d ' ' -f 1) 0 main/binary-all/Packages" >"$folder/source/dists/any/Release"
  echo "deb file:$folder/source any main" >"$folder/sources.list"
  cat >"$folder/apt.conf" <<CONF
Dir::Etc::sourcelist "$folder/sources.list";
Dir::Etc::sourceparts "/dev/null";
Dir::State "$folder/state";
Dir::State::lists "$folder/lists";
Dir::State::status "/dev/null";
Dir::Cache "$folder/cache";
APT::Sandbox::User "$(id -un)";
APT::Get::AllowUnauthenticated "true";
Acquire::AllowInsecureRepositories "true";
CONF
  careless() { APT_CONFIG=$folder/apt.conf apt-get -q update; }
  careless >"$scratch/said" 2>&1 || failed "the settings of this test allow nothing: $(cat "$scratch/said")"
  rm -rf "$folder/lists" && mkdir -p "$folder/lists/partial"
  refuses "is not signed" own_apt "$folder" update
fi

# When it is fetched.
fetch_mesa() {
  echo fetched >>"$scratch/fetched"
  if [ -n "${fails:-}" ]; then return 1; fi
  mkdir -p "$1" && touch "$1/lvp_icd.json"
}
fetched() { wc -l <"$scratch/fetched"; }
: >"$scratch/fetched"
home=$(cache_folder)/mesa
refresh_mesa "$home" 22.3 >/dev/null
[ "$(fetched)" = 1 ] || failed "not fetched"
refresh_mesa "$home" 22.3 >/dev/null
[ "$(fetched)" = 1 ] || failed "fetched twice in a month"
touch -d '31 days ago' "$home/lvp_icd.json"
fails=yes
refresh_mesa "$home" 22.3 >"$scratch/said"
[ "$(fetched)" = 2 ] || failed "not fetched again after a month"
grep -q "the one of last month is used" "$scratch/said" || failed "said: $(cat "$scratch/said")"
[ -e "$home/lvp_icd.json" ] || failed "a failure took the old one away"
refresh_mesa "$home" 22.3 >/dev/null
[ "$(fetched)" = 2 ] || failed "after a failure, tried again on the same day"
touch -d '2 days ago' "$home-failed"
fails=
refresh_mesa "$home" 22.3 >/dev/null
[ "$(fetched)" = 3 ] || failed "after a failure, not tried on another day"

# Where it is used.
play dpkg-query <<<'echo 22.3.6-1'
play dpkg <<<'exit 0'
codename=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
if [ "$codename" = bookworm ] && ! compgen -G '/dev/dri/renderD*' >/dev/null && [ ! -e /dev/nvidiactl ]; then
  chosen() {
    choose_driver
    echo "${VK_DRIVER_FILES:-the system}"
  }
  expect "$home/lvp_icd.json" chosen
  VIGIL_MESA=system expect "the system" chosen
  VK_DRIVER_FILES=mine expect mine chosen
  homeless() (unset HOME && chosen)
  homeless >"$scratch/said" 2>&1 || failed "without HOME: $(cat "$scratch/said")"
  if ! grep -q "HOME is not set" "$scratch/said" || [ "$(tail -n 1 "$scratch/said")" != "the system" ]; then
    failed "without HOME: $(cat "$scratch/said")"
  fi
  chmod 777 "$home"
  [ "$(chosen | tail -n 1)" = "the system" ] || failed "a driver that others can replace"
fi
