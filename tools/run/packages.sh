# shellcheck shell=bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The packages that Vigil is built from, tested and measured with: their names on Debian, Ubuntu, Fedora and Arch, and their
# installation. docs/play/systems.md tells which of these systems were tried.

# Columns: what needs it; what is missing without it (empty: it is required); its names for apt (Debian, Ubuntu), dnf
# (Fedora) and pacman (Arch). A name that other releases call otherwise is written A/B: the first one that exists is
# taken. @NAME: there is no package, its sources are fetched (sources.sh). A dash: nothing is needed there.
package_table() {
  cat <<'TABLE'
program |                               | cmake ninja-build g++ pkg-config/pkgconf   | cmake ninja-build gcc-c++ pkgconf-pkg-config | cmake ninja gcc pkgconf
program |                               | git                                        | git-core                          | git
program |                               | libvulkan-dev glslang-tools                | vulkan-headers vulkan-loader-devel glslang | vulkan-headers vulkan-icd-loader glslang
program |                               | mesa-vulkan-drivers                        | mesa-vulkan-drivers               | vulkan-swrast
program |                               | libsdl2-dev libglfw3-dev                   | SDL2-devel/sdl2-compat-devel glfw-devel | sdl2-compat/sdl2 glfw
program |                               | libimgui-dev                               | @imgui                            | @imgui
program |                               | zlib1g-dev                                 | zlib-devel                        | zlib
program |                               | libturbojpeg0-dev libpng-dev               | turbojpeg-devel libpng-devel      | libjpeg-turbo libpng
program |                               | libglm-dev libfmt-dev nlohmann-json3-dev   | glm-devel fmt-devel json-devel    | glm fmt nlohmann-json
program |                               | libstb-dev libtinyexr-dev                  | stb_image-devel stb_image_write-devel tinyexr-devel | stb @tinyexr
tests   |                               | libgtest-dev libcli11-dev libboost-dev     | gtest-devel cli11-devel boost-devel | gtest cli11 boost
tests   | tests run without Vulkan's validation | vulkan-validationlayers            | vulkan-validation-layers          | vulkan-validation-layers
tests   | exported scenes are not tested | libtinygltf-dev                           | tinygltf-devel                    | -
tests   | no test opens a window, where there is no display | xvfb xauth             | xorg-x11-server-Xvfb xorg-x11-xauth | xorg-server-xvfb xorg-xauth
tests   | no test types into a window   | xdotool libx11-dev                         | xdotool libX11-devel              | xdotool libx11
tests   | rays are not compared with Embree's | libembree-dev                        | embree-devel                      | embree
tests   | formatting is not checked     | clang-format                               | clang-tools-extra                 | clang
tests   | spelling is not checked       | codespell                                  | codespell                         | codespell
tests   | clang-tidy looks for no faults | clang-tidy                               | clang-tools-extra                 | clang
tests   | page, plots and faults are not tested | python3                            | python3                           | python
game    |                               | python3                                    | python3                           | python
fuzz    | no fuzzing                    | clang libclang-rt-dev/clang                | clang compiler-rt                 | clang compiler-rt
bench   |                               | libcli11-dev libboost-dev                  | cli11-devel boost-devel           | cli11 boost
bench   | `bench trace` has nothing to compare with | libembree-dev                  | embree-devel                      | embree
bench   | `bench economy` cannot tell how large shaders are | spirv-tools            | spirv-tools-devel                 | spirv-tools
bench   | no plots                      | python3-matplotlib                         | python3-matplotlib                | python-matplotlib
report  |                               | python3 python3-venv                       | python3 python3-pip               | python
faults  |                               | python3                                    | python3                           | python
TABLE
}

# Which of these package managers there is: prints apt, dnf or pacman.
package_manager() {
  if command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; then
    echo apt
  elif command -v dnf >/dev/null && command -v rpm >/dev/null; then
    echo dnf
  elif command -v pacman >/dev/null; then
    echo pacman
  fi
}

# rows_of MANAGER NEED ...: the rows of the table for these needs, as "what is missing without|names".
rows_of() {
  local manager=$1
  shift
  package_table | awk -F '|' -v manager="$manager" -v needs=" $* " '
    {
      for (i = 1; i <= NF; i++) gsub(/^ +| +$/, "", $i)
      column = manager == "apt" ? 3 : manager == "dnf" ? 4 : 5
      if (index(needs, " " $1 " ") && $column != "-") print $2 "|" $column
    }'
}

is_installed() {
  case $(package_manager) in
  apt) [ "$(dpkg-query -W -f='${db:Status-Status}\n' "$1" 2>/dev/null | sort -u)" = installed ] ;;
  dnf) rpm -q --whatprovides "$1" >/dev/null 2>&1 ;;
  pacman) pacman -T "$1" >/dev/null 2>&1 ;;
  esac
}

# Whether the package manager could install $1.
is_known() {
  case $(package_manager) in
  apt) [ -n "$(apt-cache search --names-only "^${1//+/\\+}\$" 2>/dev/null)" ] ;;
  dnf) dnf -q repoquery --whatprovides "$1" 2>/dev/null | grep -q . ;;
  pacman) pacman -Sp "$1" >/dev/null 2>&1 ;;
  esac
}

# missing_of NAME[/NAME] ...: prints those of which no alternative is there. One that is there does not count if an
# earlier one could be had: then it is there for another reason.
missing_of() {
  local wanted name found
  for wanted in "$@"; do
    found=''
    for name in ${wanted//\// }; do
      case $name in
      @*) [ ! -d "$(source_folder "${name#@}")" ] || found=yes ;;
      *) if is_installed "$name"; then found=yes; fi ;;
      esac
      if [ -n "$found" ] || [ "$wanted" = "$name" ] || is_known "$name"; then break; fi
    done
    [ -n "$found" ] || echo "$wanted"
  done
}

# Of the alternatives in each argument, the first that can be had.
choose_names() {
  local wanted name chosen
  for wanted in "$@"; do
    chosen=${wanted%%/*}
    for name in ${wanted//\// }; do
      if [ "$wanted" = "$name" ] || is_known "$name"; then
        chosen=$name
        break
      fi
    done
    echo "$chosen"
  done
}

as_root() {
  if [ "$(id -u)" = 0 ]; then
    "$@"
  elif [ -t 0 ]; then
    sudo "$@"
  else
    sudo -n "$@" # nobody is there to type a password
  fi
}

# Brings the lists of packages up to date, once. A source that fails is no reason to stop: whether the packages can be
# installed shows when they are.
lists_are_new=''
update_lists() {
  [ -z "$lists_are_new" ] || return 0
  lists_are_new=yes
  case $(package_manager) in
  apt) as_root apt-get -q update || note "a source of packages failed (see above): going on with the others" ;;
  pacman) ;; # new lists with old packages are what Arch warns of: pacman -Syu is the person's to say
  esac
}

# install NAME ...: packages, or @NAME: sources. Judged by what is there afterwards.
install() {
  local name packages=() status=0
  for name in "$@"; do
    case $name in
    @*) fetch_source "${name#@}" || status=1 ;;
    *) packages+=("$name") ;;
    esac
  done
  if [ ${#packages[@]} = 0 ]; then return $status; fi
  update_lists
  mapfile -t packages < <(choose_names "${packages[@]}")
  case $(package_manager) in
  apt) as_root env DEBIAN_FRONTEND=noninteractive apt-get -q install -y --no-install-recommends "${packages[@]}" ;;
  dnf) as_root dnf install -y --setopt=install_weak_deps=False "${packages[@]}" ;;
  pacman) as_root pacman -S --needed --noconfirm "${packages[@]}" ;;
  esac || true
  [ -z "$(missing_of "${packages[@]}")" ] || status=1
  return $status
}

# An optional package is asked for once; then its absence is remembered here, one name a line.
remembered() {
  local cache
  cache=$(cache_folder) || return 1
  echo "$cache/packages-not-there"
}

# Set when something was installed: build folders look for it again (configure).
packages_are_new=''

# set_up NEED ...: installs what the table lists for the program and for these needs.
set_up() {
  local manager row names missing=() optional=() without
  manager=$(package_manager)
  if [ -z "$manager" ]; then
    note "no apt, dnf or pacman here: install the equivalents of what tools/run/packages.sh lists"
    return
  fi
  while IFS='|' read -r without names; do
    read -ra row <<<"$names"
    mapfile -t row < <(missing_of "${row[@]}")
    [ ${#row[@]} -gt 0 ] || continue
    if [ -n "$without" ]; then
      optional+=("$without|${row[*]}")
    else
      missing+=("${row[@]}")
    fi
  done < <(rows_of "$manager" program "$@")
  if [ ${#missing[@]} -gt 0 ]; then
    step "Installing packages: ${missing[*]}"
    install "${missing[@]}" ||
      die "these packages are missing and could not be installed: $(missing_of "${missing[@]}" | paste -sd ' ')"
    packages_are_new=yes
  fi
  for row in "${optional[@]}"; do set_up_optional "${row%%|*}" "${row#*|}"; done
}

# set_up_optional WITHOUT NAMES: installs those that were not asked for before, and says what is missing without them.
set_up_optional() {
  local without=$1 names name list
  read -ra names <<<"$2"
  list=$(remembered) || list=/dev/null
  for name in "${names[@]}"; do
    if grep -qxF "$name" "$list" 2>/dev/null; then continue; fi
    step "Installing an optional package: $name"
    if install "$name"; then packages_are_new=yes; else echo "$name" >>"$list"; fi
  done
  mapfile -t names < <(missing_of "${names[@]}")
  [ ${#names[@]} = 0 ] || note "without ${names[*]}: $without (rm $list to try again)"
}
