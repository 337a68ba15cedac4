#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Sources are taken at the commit that is written down, and at no other.
# shellcheck source-path=SCRIPTDIR source=check.sh
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

command -v git >/dev/null || exit 0
git init -q "$scratch/upstream"
echo 'int x;' >"$scratch/upstream/imgui.h"
git -C "$scratch/upstream" add .
git -C "$scratch/upstream" -c user.name=A -c user.email=a@b commit -qm one
git -C "$scratch/upstream" tag v1
head=$(git -C "$scratch/upstream" rev-parse HEAD)

# shellcheck disable=SC2317 # called by the part
source_table() { echo "imgui file://$scratch/upstream v1 $head"; }
expect "" source_options
fetch_source imgui >/dev/null
[ -e "$HOME/.cache/vigil/sources/imgui/imgui.h" ] || failed "nothing fetched"
expect "-DVIGIL_IMGUI_SOURCE=$HOME/.cache/vigil/sources/imgui" source_options

source_table() { echo "imgui file://$scratch/upstream v1 0123456789012345678901234567890123456789"; }
refuses "is not the commit" fetch_source imgui
[ ! -e "$HOME/.cache/vigil/sources/imgui" ] || failed "kept what nobody wrote down"
