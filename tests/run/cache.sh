#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The cache folder is the person's own, or there is none.
# shellcheck source-path=SCRIPTDIR source=check.sh
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

expect "$HOME/.cache/vigil" cache_folder
[ "$(stat -c %a "$HOME/.cache/vigil")" = 700 ] || failed "others can read the cache"
expect "$HOME/.cache/vigil" cache_folder # it is there now
XDG_CACHE_HOME=$scratch/xdg expect "$scratch/xdg/vigil" cache_folder
XDG_CACHE_HOME=relative expect "$HOME/.cache/vigil" cache_folder # the specification: to be ignored

# Never in a shared folder.
nowhere() (unset HOME && cache_folder)
refuses "HOME is not set" nowhere
mkdir -m 777 "$scratch/shared"
XDG_CACHE_HOME=$scratch/shared refuses "others can write to $scratch/shared" cache_folder
chmod 1777 "$scratch/shared" # where only owners remove what is theirs, like /tmp
XDG_CACHE_HOME=$scratch/shared expect "$scratch/shared/vigil" cache_folder

chmod 770 "$HOME/.cache/vigil"
refuses "others can write to $HOME/.cache/vigil" cache_folder
rm -r "$HOME/.cache/vigil"
mkdir "$HOME/elsewhere"
ln -s "$HOME/elsewhere" "$HOME/.cache/vigil"
refuses "is a link" cache_folder
if [ "$(id -u)" = 0 ]; then
  rm "$HOME/.cache/vigil"
  mkdir -m 700 "$HOME/.cache/vigil"
  chown 12345 "$HOME/.cache/vigil"
  refuses "belongs to somebody else" cache_folder
fi
