#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Set-up asks the system's package manager for what the table lists, and judges by what is there afterwards.
# shellcheck source-path=SCRIPTDIR source=check.sh
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

# The table: five columns, a need and names in each.
package_table | awk -F '|' 'NF != 5 || $1 !~ /^[a-z]+ *$/ || $3 !~ /[a-z]/ || $4 !~ /[a-z-]/ || $5 !~ /[a-z-]/' >"$scratch/odd"
[ ! -s "$scratch/odd" ] || failed "rows of package_table: $(cat "$scratch/odd")"
for manager in apt dnf pacman; do
  rows_of $manager program | grep -q '^|.*cmake' || failed "$manager: no row of cmake"
  for name in $(rows_of $manager program tests fuzz bench report faults | tr ' |' '\n' | grep '^@' | tr -d @); do
    source_table | grep -q "^$name " || failed "no sources of $name"
  done
done
expect "" rows_of apt no_such_need

# An apt whose installed packages are the files of a folder. It knows the lines of `known`; `update` fails, as it does when a
# third party's source is gone.
mkdir "$scratch/installed"
play dpkg-query <<BODY
[ -e "$scratch/installed/\${*: -1}" ] && echo installed
BODY
play apt-get <<BODY
echo "\$@" >>"$scratch/asked"
case "\$*" in
*update*) echo "E: a third party's source is gone" >&2; exit 100 ;;
*install*) for name in "\$@"; do if grep -qxF -- "\$name" "$scratch/known"; then : >"$scratch/installed/\$name"; fi; done ;;
esac
BODY
play apt-cache <<BODY
grep -x -- "\${*: -1}" "$scratch/known"
BODY
as_root() { "$@"; }
asked() { grep -c "${1:-.}" "$scratch/asked" || true; }
start_anew() {
  rm -rf "$scratch/asked" "$scratch/installed" "$HOME/.cache"
  mkdir "$scratch/installed"
  touch "$scratch/asked"
  # shellcheck disable=SC2034 # read by the parts
  lists_are_new='' packages_are_new=''
}

# Everything known: all is installed although a source failed; the alternative of this system is taken.
rows_of apt program tests | cut -d '|' -f 2 | tr ' /' '\n' | grep -vx pkg-config >"$scratch/known"
start_anew
set_up tests >"$scratch/said" 2>&1
expect "" missing_of cmake pkg-config/pkgconf xdotool
[ ! -e "$scratch/installed/pkg-config" ] || failed "a package that does not exist"
[ "$(asked update)" = 1 ] || failed "lists updated $(asked update) times"
[ -n "$packages_are_new" ] || failed "build folders would not look again"
# A later alternative that is there for another reason is not enough, if the first one could be had.
touch "$scratch/installed/clang"
echo libclang-rt-dev >>"$scratch/known"
expect "libclang-rt-dev/clang" missing_of libclang-rt-dev/clang
expect "" missing_of no-such-package/clang
# And the next time nothing is asked.
: >"$scratch/asked"
# shellcheck disable=SC2034
lists_are_new=''
expect "" set_up tests
[ "$(asked)" = 0 ] || failed "asked again: $(cat "$scratch/asked")"

# A missing required package ends it and is named; others are not.
grep -vx libglm-dev "$scratch/known" >"$scratch/fewer" && mv "$scratch/fewer" "$scratch/known"
start_anew
refuses "could not be installed: libglm-dev" set_up
echo libglm-dev >>"$scratch/known"

# An optional one does not: it is asked for once, also when nothing else is missing, and told each time in one line.
grep -vx xdotool "$scratch/known" >"$scratch/fewer" && mv "$scratch/fewer" "$scratch/known"
start_anew
set_up tests >"$scratch/said" 2>&1
grep -q '^   without xdotool.*: no test types into a window (rm ' "$scratch/said" || failed "not told: $(cat "$scratch/said")"
: >"$scratch/asked"
set_up tests >"$scratch/said" 2>&1
[ "$(asked)" = 0 ] || failed "asked for xdotool again"
if [ "$(grep -c . "$scratch/said")" != 1 ] || ! grep -q 'without xdotool' "$scratch/said"; then
  failed "the second time: $(cat "$scratch/said")"
fi
rm "$scratch/installed/xvfb"
set_up tests >"$scratch/said" 2>&1
[ -e "$scratch/installed/xvfb" ] || failed "optional packages are looked for only when required ones are missing"

# A pacman and a dnf with the same kind of memory, and sources where there is no package.
git init -q "$scratch/upstream"
git -C "$scratch/upstream" -c user.name=A -c user.email=a@b commit -q --allow-empty -m one
git -C "$scratch/upstream" tag v1
head=$(git -C "$scratch/upstream" rev-parse HEAD)
# shellcheck disable=SC2317 # called by the parts
source_table() { printf '%s\n' "imgui file://$scratch/upstream v1 $head" "tinyexr file://$scratch/upstream v1 $head"; }
play pacman <<BODY
case \$1 in
-T) [ -e "$scratch/installed/\$2" ] ;;
-Sp) grep -qxF -- "\$2" "$scratch/known" ;;
-S) shift; for name in "\$@"; do if grep -qxF -- "\$name" "$scratch/known"; then : >"$scratch/installed/\$name"; fi; done ;;
esac
BODY
play rpm <<BODY
[ -e "$scratch/installed/\${*: -1}" ]
BODY
play dnf <<BODY
case "\$*" in
*repoquery*) grep -x -- "\${*: -1}" "$scratch/known" ;;
*install*) for name in "\$@"; do if grep -qxF -- "\$name" "$scratch/known"; then : >"$scratch/installed/\$name"; fi; done ;;
esac
BODY
for kind in pacman dnf; do
  # shellcheck disable=SC2317
  package_manager() { echo "$kind"; }
  rows_of "$kind" program tests | cut -d '|' -f 2 | tr ' /' '\n' | grep -v '^@' | grep -vx 'sdl2\|SDL2-devel' >"$scratch/known"
  start_anew
  set_up tests >"$scratch/said" 2>&1 || failed "$kind: $(cat "$scratch/said")"
  for name in $(rows_of "$kind" program tests | cut -d '|' -f 2); do
    expect "" missing_of "$name"
  done
  grep -q . < <(source_options) || failed "$kind: no sources of Dear ImGui"
  sed -i '/^fmt/d' "$scratch/known"
  start_anew
  refuses "could not be installed: fmt" set_up
done
