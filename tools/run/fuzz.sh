# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# `./run fuzz`: libFuzzer on every parser.

# Whether clang is here, with its fuzzer.
can_fuzz() {
  local probe status=0
  probe=$(mktemp -d)
  echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }' |
    clang++ -fsanitize=fuzzer,address,undefined -x c++ - -o "$probe/fuzzer" >/dev/null 2>&1 || status=1
  rm -rf "$probe"
  return $status
}

# The first and the last number behind `$1` in libFuzzer's log $2: "FIRST LAST".
fuzz_numbers() {
  grep -aoE "$1 *[0-9]+" "$2" 2>/dev/null | awk -v OFS=' ' '
    { number = $0; gsub(/[^0-9]/, "", number); if (NR == 1) first = number; last = number }
    END { print first + 0, last + 0 }'
}

# One row for each target that ran, from its log.
fuzz_table() {
  local log target runs before after findings all=0
  printf '\n%-12s %12s %10s %12s %9s\n' target runs coverage new findings
  for log in build-asan/logs/*.log; do
    [ -e "$log" ] || continue
    target=$(basename "$log" .log)
    read -r _ runs < <(fuzz_numbers '#' "$log")
    read -r before after < <(fuzz_numbers 'cov:' "$log")
    findings=$(find out/fuzz -name "$target-*" -newer "build-asan/logs/start" 2>/dev/null | wc -l)
    all=$((all + findings))
    printf '%-12s %12s %10s %12s %9s\n' "$target" "$runs" "$after" "+$((after - before))" "$findings"
  done
  if [ "$all" -gt 0 ]; then note "inputs that failed are in out/fuzz/; docs/internals/files.md tells what to do with them"; fi
  [ "$all" = 0 ]
}

# fuzz_target TARGET SECONDS, into build-asan/logs/TARGET.log.
fuzz_target() {
  local folders=("build-asan/corpus/$1" "build-asan/seeds/$1")
  if [ -d "tests/fuzz/regressions/$1" ]; then folders+=("tests/fuzz/regressions/$1"); fi
  mkdir -p "${folders[0]}"
  local options
  read -ra options <"build-asan/tests/fuzz/$1.options"
  nice "build-asan/tests/fuzz/fuzz_$1" "${options[@]}" -max_total_time="$2" -artifact_prefix="out/fuzz/$1-" \
    "${folders[@]}" >"build-asan/logs/$1.log" 2>&1
}

# fuzz [TARGET] [SECONDS]: inputs that reached something new stay in build-asan/corpus/ for the next time.
fuzz() {
  local only='' seconds=300 known programs target interrupted=''
  if [[ "${1:-}" =~ ^[a-z] ]]; then only=$1 && shift; fi
  if [ -n "${1:-}" ]; then seconds=$1; fi
  [[ "$seconds" =~ ^[1-9][0-9]*$ ]] || die "fuzz: SECONDS is a whole number, not '$seconds'"
  known=$(sed -n 's/^ *ROW(\([a-z0-9_]*\),.*/\1/p' tests/fuzz/target_table.h)
  if [ -n "$only" ]; then
    grep -qx "$only" <<<"$known" || die "fuzz: there is no target $only (there are: ${known//$'\n'/ })"
    known=$only
  fi
  set_up tests fuzz
  can_fuzz || die "fuzz: clang with libFuzzer is missing"
  configure_sanitized
  mapfile -t programs < <(sed 's/^/fuzz_/' <<<"$known")
  step "Building ${#programs[@]} parsers with libFuzzer and sanitizers in build-asan/"
  ninja -C build-asan fuzz_seeds "${programs[@]}"
  rm -rf build-asan/logs
  mkdir -p build-asan/logs out/fuzz
  touch build-asan/logs/start
  ctest --test-dir build-asan -R '^fuzz_seeds$' >/dev/null || die "fuzz: the seeds could not be written"
  step "Fuzzing $(wc -w <<<"$known") targets, $seconds s each, $(nproc) at a time"
  trap 'interrupted=yes' INT # the programs hear Ctrl-C themselves and end
  for target in $known; do
    while [ "$(jobs -pr | wc -l)" -ge "$(nproc)" ]; do wait -n || true; done
    [ -z "$interrupted" ] || break
    note "$target"
    fuzz_target "$target" "$seconds" &
  done
  while [ -n "$(jobs -pr)" ]; do wait || true; done
  trap - INT
  fuzz_table
}
