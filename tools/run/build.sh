# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Build folders.

# In continuous integration warnings are errors; elsewhere a newer compiler may warn of something new and still build.
if [ "${CI:-}" = true ]; then warnings_are_errors=ON; else warnings_are_errors=OFF; fi

# Or ccache would not keep what was compiled with precompiled headers.
export CCACHE_SLOPPINESS=pch_defines,time_macros

# configure FOLDER OPTIONS: a build folder, made once; ninja runs CMake again when its files change.
configure() {
  local folder=$1
  shift
  if [ -e "$folder/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$PWD" "$folder/CMakeCache.txt"; then
    note "$folder/ belongs to another checkout: making it again"
    rm -rf "$folder"
  fi
  local options=(-DVIGIL_WERROR="$warnings_are_errors")
  if command -v ccache >/dev/null; then options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  mapfile -t -O ${#options[@]} options < <(source_options)
  mapfile -t -O ${#options[@]} options < <(xargs -r -n 1 <<<"${VIGIL_CMAKE_OPTIONS:-}")
  # A folder made by another compiler is made anew.
  if [ "$(cat "$folder/options" 2>/dev/null)" != "$*" ]; then
    options+=(--fresh)
  elif [ -e "$folder/build.ninja" ] && [ -z "$packages_are_new" ]; then
    return 0
  fi
  step "Configuring $folder/"
  cmake -G Ninja -S . -B "$folder" "${options[@]}" "$@"
  echo "$*" >"$folder/options"
}

# The build folder with sanitizers: by Clang where it can fuzz, so that one build serves unit tests and fuzz targets.
configure_sanitized() {
  local compiler=()
  if can_fuzz; then
    compiler=(-DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++)
  else
    note "no fuzzing: clang with libFuzzer is missing"
  fi
  configure build-asan -DVIGIL_SANITIZE=ON "${compiler[@]}"
}

# build NEED ...: the program, and the packages for these needs. What else the build folder can make is made by those who
# need it.
build() {
  set_up "$@"
  configure build
  step "Building build/vigil"
  ninja -C build vigil
}

# A Debian package of what is in build/.
package() {
  command -v dpkg-shlibdeps >/dev/null || die "package: needs dpkg-shlibdeps (apt-get install dpkg-dev)"
  rm -rf build/package
  (cd build && cpack -G DEB)
  note "install it with: apt install $(find "$PWD/build/package" -maxdepth 1 -name '*.deb')"
}
