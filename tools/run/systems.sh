# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# `./run systems`: set-up, build and a short test in roots of other systems, each as a newcomer would: from a copy of what git
# tracks, by `./run` itself. The roots stay in the cache folder and are used again.

# Columns: name; the suite of Debian; compiler; CMake's options.
system_table() {
  cat <<'TABLE'
trixie         trixie  g++
testing-clang  testing clang++ -DVIGIL_HEADER_LIBRARIES=ON
testing        testing g++
trixie-clang   trixie  clang++
bookworm       bookworm g++
TABLE
}

# Unmounts everything below folder $1, the innermost first.
unmount_below() {
  local folder
  while read -r folder; do
    umount "$folder" || umount -l "$folder"
  done < <(awk -v root="$1/" 'index($2, root) == 1 { print $2 }' /proc/mounts | sort -r)
}

# make_root SUITE ROOT: a fresh system of the mirror that this system installs from.
make_root() {
  local suite=$1 root=$2 codename mirror
  codename=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
  mirror=$(mirror_of "$codename")
  [ -n "$mirror" ] || die "systems: no source of $codename here names a mirror"
  step "Making a root of $suite in $root"
  rm -rf "$root.part"
  debootstrap --variant=minbase "$suite" "$root.part" "$mirror" >"$root.log" 2>&1 ||
    die "systems: debootstrap failed: $root.log"
  # A mirror that is a copy can be older than its lists say they are good for; they are signed all the same.
  # Nobody needs these files after a power cut.
  echo force-unsafe-io >"$root.part/etc/dpkg/dpkg.cfg.d/unsafe-io"
  echo 'Acquire::Check-Valid-Until "false";' >"$root.part/etc/apt/apt.conf.d/90copied-mirror"
  # What is compiled once stays for the next time.
  chroot "$root.part" sh -c 'apt-get -q update && apt-get -q install -y --no-install-recommends ccache' >>"$root.log" 2>&1
  mv "$root.part" "$root"
}

# in_root ROOT COMMAND: by a shell in the root, in the checkout there, with what a login gives.
in_root() {
  local root=$1
  shift
  # shellcheck disable=SC2016 # for the shell in there
  nice -n 4 chroot "$root" /usr/bin/env -i HOME=/srv TERM=dumb LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    "${system_environment[@]}" bash -c 'cd /srv/vigil && eval "$1"' bash "$*"
}

# A few tests of formats, files, text, export and of the overlay, whose libraries differ most between systems.
system_tests='^(run_.*|cvar_test|scene_export_test|client_console_test|client_picture_test|overlay_test)$'

# try_system SUITE COMPILER OPTIONS: one row of the table.
try_system() {
  local suite=$1 compiler=$2 root=$systems/$1
  shift 2
  [ -d "$root" ] || make_root "$suite" "$root"
  unmount_below "$root"
  mount --bind /dev "$root/dev"
  mount -t proc proc "$root/proc"
  cp /etc/resolv.conf "$root/etc/resolv.conf"
  # The newcomer's copy: what git tracks, as it is now.
  rm -rf "$root/srv/vigil"
  mkdir -p "$root/srv/vigil"
  git ls-files -z | xargs -0 tar -c | tar -x -C "$root/srv/vigil"
  local cc=${compiler/clang++/clang}
  system_environment=(CXX="$compiler" CC="${cc/g++/gcc}" VIGIL_CMAKE_OPTIONS="$*")
  if [ "$compiler" = clang++ ]; then in_root "$root" apt-get -q install -y --no-install-recommends clang; fi
  local start=$SECONDS
  in_root "$root" ./run +set vid_driver headless +set vid_width 160 +set vid_height 90 +map warehouse +screenshot systems +quit
  in_root "$root" ls -l out/systems.png
  echo "first picture after $((SECONDS - start)) s" >"$systems/$suite.first"
  in_root "$root" "./run test '$system_tests'"
  if [ -n "$long" ]; then in_root "$root" ninja -C build; fi # all other programs and tests
  unmount_below "$root"
}

systems='' # the folder of the roots

# systems [long] [NAME]: all rows of the table, or one.
systems() {
  local name suite compiler options failed='' log long=''
  if [ "${1:-}" = long ]; then long=yes && shift; fi
  [ "$(id -u)" = 0 ] || die "systems: a root of another system can be made and entered by root only"
  command -v debootstrap >/dev/null || install debootstrap || die "systems: debootstrap is missing"
  systems=$(cache_folder)/systems || exit 1
  mkdir -p "$systems"
  trap 'unmount_below "$systems"' EXIT
  while read -r -u 3 name suite compiler options; do
    if [ -n "${1:-}" ] && [ "$1" != "$name" ]; then continue; fi
    log=$systems/$name.log
    step "$name ($compiler${options:+, $options}): $log"
    # In a shell of its own, whose first failure ends it and not the other systems.
    # shellcheck disable=SC2086 # options are words
    (try_system "$suite" "$compiler" $options) >"$log" 2>&1 </dev/null &
    if wait $!; then
      note "$(cat "$systems/$suite.first"); then the tests: $(tail -n 1 "$log")"
    else
      note "failed: $(tail -n 3 "$log" | paste -sd ' ')"
      failed=yes
    fi
  done 3< <(system_table)
  [ -z "$failed" ]
}
