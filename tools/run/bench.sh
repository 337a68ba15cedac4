# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# `./run bench` and `./run report`: measurements, their plots and the page of all of them.

# Draws the report of benchmark $1, if it has left one and there are plots for it.
plot() {
  local script=tools/report/$1.py report=out/$1.json
  if [ ! -e "$script" ] || [ ! "$report" -nt build/.bench-start ]; then return 0; fi
  if ! python3 -c 'import matplotlib' 2>/dev/null; then
    note "plots need matplotlib (apt-get install python3-matplotlib), then: python3 $script $report"
    return 0
  fi
  python3 "$script" "$report"
}

# The page of all experiments, in a Python environment that has what it needs.
report() {
  [ $# -gt 0 ] || set -- out
  python3 tools/report/report.py "$@"
}

# All experiments that make the page; finished ones are kept, so that this goes on after an interruption.
bench_all() {
  local name pictures
  for name in quality adapt ring timing scale trade confirm; do
    step "$name"
    pictures=()
    if [ $name = quality ]; then pictures=(--pictures out/quality); fi
    build/vigil_bench $name --keep "${pictures[@]}" "$@"
  done
  report
}
