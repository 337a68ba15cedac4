# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# `./run soak`: random play.

# soak [sanitized] MINUTES [SEED]
soak() {
  local folder=build status=0
  if [ "${1:-}" = sanitized ]; then folder=build-asan && shift; fi
  [[ "${1:-}" =~ ^[0-9.]+$ ]] || die "soak: how many minutes?"
  if [ $folder = build ]; then
    build tests
    ninja -C build vigil_soak
  else
    set_up tests
    configure_sanitized
    step "Building the program with AddressSanitizer and UndefinedBehaviorSanitizer in build-asan/"
    ninja -C build-asan vigil_soak
  fi
  choose_driver
  # No frame of a soak takes ten minutes: one that does will never end.
  LSAN_OPTIONS=suppressions=$PWD/tests/lsan.supp:print_suppressions=0 UBSAN_OPTIONS=print_stacktrace=1 \
    timeout --foreground "$(awk -v minutes="$1" 'BEGIN { print 60 * minutes + 600 }')" \
    $folder/vigil_soak +set vid_driver headless +set vid_width 160 +set vid_height 90 +set vk_validation 2 \
    +soak "$1" "${2:-1}" +quit || status=$?
  [ $status != 124 ] || note "soak: stuck in a frame, and ended ten minutes after its time"
  [ $status = 0 ] || note "what was typed is in out/soak.cfg; docs/internals/tests.md tells how to type it again"
  return $status
}
