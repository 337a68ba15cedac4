#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# A comparison of nothing is no success.
# shellcheck source-path=SCRIPTDIR source=check.sh
source "$(dirname "${BASH_SOURCE[0]}")/check.sh"

command -v python3 >/dev/null || exit 0 # no scripts run here, and these neither
status_of() {
  PYTHONPATH=tools:tools/crosscheck python3 -c "from verdict import status_of; print(status_of($1))" | tail -n 1
}
expect 0 status_of '[True, None, True]'
expect 1 status_of '[True, False, None]'
expect 1 status_of '[None, False]'
expect 3 status_of '[None, None]'
expect 3 status_of '[]'

# Without a place for Mitsuba.
status=0
XDG_CACHE_HOME=/dev/null python3 tools/crosscheck/crosscheck.py build/vigil "$scratch/out" lamp >"$scratch/said" || status=$?
[ $status = 3 ] || failed "status $status without Mitsuba: $(cat "$scratch/said")"
