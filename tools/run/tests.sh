# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# `./run test`: stages of ctest, and their results counted together.

# test_targets FOLDER FILTER OPTIONS: the programs of the tests that ctest chooses so: targets of the same name, but for
# what marks part of a program, or a way to run it.
test_targets() {
  local folder=$1 filter=$2
  shift 2
  comm -12 \
    <(ctest --test-dir "$folder" -N -R "$filter" "$@" |
      sed -nE 's/^ *Test *#[0-9]*: //; T; s/_(long|all|[0-9]+)$//; p' | sort -u) \
    <(ninja -C "$folder" -t targets all | sed -n 's/: .*//p' | sort)
}

stages=() # folders of results, which count_results and the end read

# run_tests FOLDER STAGE FILTER OPTIONS: one ctest run. Its results are in FOLDER/results/STAGE: the file ctest (one line
# a test program: name and status), and each GoogleTest program's own report, NAME.xml.
run_tests() {
  local folder=$1 results=$PWD/$1/results/$2 filter=$3
  shift 3
  rm -rf "$results"
  mkdir -p "$results"
  stages+=("$results")
  # A failed test is counted below; without tests ctest succeeds and writes no report.
  if ! GTEST_OUTPUT=xml:$results/ "${display[@]}" ctest --test-dir "$folder" -R "$filter" --output-on-failure \
    --no-tests=ignore --output-junit "$results/junit.xml" "$@"; then
    [ -e "$results/junit.xml" ] || die "ctest did not finish in $folder/"
  fi
  [ -e "$results/junit.xml" ] || return 0
  # A test that could not be started is a failure; only the test itself may ask to be skipped.
  awk -F '"' '
    function close_test() { if (name != "") print name, status }
    /<testcase / {
      close_test(); name = $2
      status = /status="run"/ ? "passed" : /status="disabled"/ ? "skipped" : "failed"
    }
    /<skipped message="SKIP_/ { status = "skipped" }
    END { close_test() }' "$results/junit.xml" >"$results/ctest"
}

# Prints "passed failed skipped" of all test programs of a stage's results $1: single test cases where a program wrote a
# report, else the program as one. A program that ended badly without a failed case (it crashed, hung or leaked)
# counts as one failure more.
count_results() {
  local results=$1 name status
  while read -r name status; do
    echo "program $status"
    cat "$results/$name.xml" 2>/dev/null || true
  done < <(cat "$results/ctest" 2>/dev/null) | awk '
    function number(key) { return match($0, key "=\"[0-9]+\"") ? substr($0, RSTART + length(key) + 2) + 0 : 0 }
    function close_program() {
      if (status == "") return
      if (status == "passed" && cases == 0) passed++
      if (status == "failed" && bad == 0) failed++
      if (status == "skipped") skipped++
    }
    /^program / { close_program(); status = $2; cases = bad = 0 }
    /<testsuite / {
      tests = number(" tests") - number(" disabled")
      cases += tests; bad += number(" failures")
      failed += number(" failures"); skipped += number(" skipped")
      passed += tests - number(" failures") - number(" skipped")
    }
    END { close_program(); print passed + 0, failed + 0, skipped + 0 }'
}

# build_tests FOLDER FILTER OPTIONS: the programs of the tests that ctest chooses so.
build_tests() {
  local folder=$1 targets
  shift
  ninja -C "$folder" build.ninja >/dev/null # so that the list of tests is today's
  mapfile -t targets < <(test_targets "$folder" "$@")
  [ ${#targets[@]} -gt 0 ] || return 0
  step "Building tests in $folder/"
  ninja -C "$folder" "${targets[@]}"
}

# What is too slow for every day, of the tests whose names match $1.
long_tests() {
  build_tests build "$1" -L 'unit|long'
  step "Unit tests without sanitizers, and those that take long"
  run_tests build unit "$1" -L 'unit|long' -j "$(nproc)"
  build_tests build-asan "$1" -L gpu
  step "GPU tests, host code under sanitizers, with core validation"
  VIGIL_VALIDATION=1 run_tests build-asan gpu "$1" -L gpu -j 2
  step "GPU tests with GPU-assisted validation"
  # Mesa's software driver takes a minute or two to compile what the layer makes of a path tracer; with LLVM's
  # optimisations many times as long.
  GALLIVM_PERF=nopt VIGIL_VALIDATION=3 run_tests build gpu_assisted "$1" -L assisted -j 2
}

# lap NAME: how long it took since the lap before, for the end.
laps=''
lap_start=0
lap() {
  laps+="${laps:+, }$1 $((SECONDS - lap_start)) s"
  lap_start=$SECONDS
}

test_all() {
  local long='' filter stage p f s passed=0 failed=0 skipped=0
  if [ "${1:-}" = long ]; then long=yes && shift; fi
  filter=${1:-.}
  build tests fuzz
  lap "packages and program"
  demand_capabilities
  build_tests build "$filter" -L gpu
  lap "building GPU tests"
  configure_sanitized
  build_tests build-asan "$filter" -L 'unit|fuzz'
  lap "building unit tests"
  choose_driver
  display=()
  if [ -z "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] && command -v xvfb-run >/dev/null && command -v xauth >/dev/null; then
    display=(xvfb-run -a -s "-screen 0 1280x720x24 -noreset")
  fi
  step "Unit tests and a short run of each fuzz target, under AddressSanitizer and UndefinedBehaviorSanitizer"
  run_tests build-asan unit "$filter" -L 'unit|fuzz' -j "$(nproc)"
  lap "unit tests"
  # Two GPU tests at a time: while one compiles shaders, on one core, the other may use the rest.
  step "GPU tests, with core and synchronisation validation"
  run_tests build gpu "$filter" -L gpu -j 2
  lap "GPU tests"
  if [ -n "$long" ]; then
    long_tests "$filter"
    lap "what takes long"
  fi
  for stage in "${stages[@]}"; do
    read -r p f s <<<"$(count_results "$stage")"
    passed=$((passed + p)) failed=$((failed + f)) skipped=$((skipped + s))
  done
  step "Done (build/ and build-asan/ together), commit $(git rev-parse --short HEAD 2>/dev/null || echo unknown)"
  note "$laps"
  if [ "$skipped" -gt 0 ]; then
    note "skipped, and why:"
    skip_reasons "${stages[@]}" | sort | uniq -c
  fi
  if [ $((passed + failed + skipped)) = 0 ]; then die "no test matches '$filter'"; fi
  if [ -n "${VIGIL_SKIPS:-}" ] && ! skip_reasons "${stages[@]}" | judge_skips "$VIGIL_SKIPS"; then
    note "these skips are not allowed by $VIGIL_SKIPS: they count as failures"
    failed=$((failed + 1))
  fi
  echo "$passed passed, $failed failed, $skipped skipped"
  [ "$failed" = 0 ]
}
