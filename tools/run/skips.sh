# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# What the tests of one run skipped, and the judge of it: continuous integration names what it must be able to do
# (capabilities), and which skips are no loss (.ci/skips); any other skip fails it.

# skip_reasons FOLDER ...: one line for each skip in these folders of results. GoogleTest writes "file:line, line feed,
# reason" into NAME.xml; a program that was skipped as one has its name in the file ctest only.
skip_reasons() {
  local folder name status
  find "$@" -name '*.xml' -exec cat {} + |
    sed -n 's/.*<skipped message="\([^"]*\)".*/\1/p' |
    sed 's/^[^&]*:[0-9]*&#x0A;//; s/&#x0A;.*//; s/&apos;/'"'"'/g; s/&quot;/"/g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g' |
    grep -v '^SKIP_' || true # junit.xml's word for a whole program
  for folder in "$@"; do
    while read -r name status; do
      if [ "$status" = skipped ] && [ ! -e "$folder/$name.xml" ]; then echo "all of $name"; fi
    done < <(cat "$folder/ctest" 2>/dev/null)
  done
}

# judge_skips LIST: reads reasons, prints those that no line of the file LIST allows; fails if there are any. A line of LIST is a
# whole reason; lines with # say why it is no loss.
judge_skips() {
  ! grep -vxF -f <(grep -v '^\(#\|$\)' "$1") | sort | uniq -c | grep .
}

# has CAPABILITY: whether this machine can do what the tests need it for.
has() {
  case $1 in
  validation) [ -n "$(find /usr/share/vulkan/explicit_layer.d /etc/vulkan/explicit_layer.d "${VK_LAYER_PATH:-/nonexistent}" \
    -name '*khronos_validation*.json' 2>/dev/null)" ] ;;
  windows) command -v Xvfb >/dev/null && command -v xvfb-run >/dev/null && command -v xauth >/dev/null ;;
  typing) command -v xdotool >/dev/null && grep -qx 'X11_X11_LIB:FILEPATH=/.*' build/CMakeCache.txt ;;
  fuzzing) can_fuzz ;;
  embree) grep -q '^embree_DIR:PATH=/' build/CMakeCache.txt ;;
  gltf) grep -q '^VIGIL_tinygltf_INCLUDE:PATH=/' build/CMakeCache.txt ;;
  formatting) clang-format --version | grep -q 'version 14\.' ;;
  spelling) command -v codespell >/dev/null ;;
  tidying) clang-tidy --version | grep -q 'version 14\.' ;;
  levels) [ -d ../shared/levels ] && [ -d ../shared/tools ] ;;
  pages) python3 -c 'import flip_evaluator, matplotlib, numpy, OpenEXR, PIL' 2>/dev/null ;;
  *) die "there is no capability $1" ;;
  esac
}

# Puts the Python that the pages of measurements need first, as it is for `./run report`.
use_report_python() {
  local python
  python=$(python3 tools/python_environment.py tools/report/requirements.txt report "what reports need" | tail -n 1)
  if [ -x "$python" ]; then PATH=$(dirname "$python"):$PATH; fi
}

# Ends the run where this machine lacks something of $VIGIL_CAPABILITIES, before the tests have taken their time.
demand_capabilities() {
  local name missing=()
  for name in ${VIGIL_CAPABILITIES:-}; do
    if [ "$name" = pages ]; then use_report_python; fi
    has "$name" || missing+=("$name")
  done
  [ ${#missing[@]} = 0 ] || die "this machine must be able to do, and cannot: ${missing[*]} (tools/run/skips.sh)"
}
