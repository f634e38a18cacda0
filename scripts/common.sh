# SPDX-License-Identifier: Apache-2.0
# Shared by the scripts of this folder, which source it first.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd -P)
script=$(basename "$0")
jobs=$(nproc 2>/dev/null || echo 2)

fail() {
  echo "$script: $*" >&2
  exit 1
}

stage() {
  printf '== %s\n' "$*"
}

# Installs what is missing; says nothing when nothing is.
setup() {
  stage setup
  "$root/scripts/setup"
}

# True when the build tree has to be configured again. Ninja itself sees changes of CMakeLists.txt;
# it does not see changed presets, nor that the tree was copied from somewhere else.
is_unconfigured() {
  local build=$1
  [ ! -e "$build/build.ninja" ] || [ ! -e "$build/.configured" ] ||
    [ "$root/CMakePresets.json" -nt "$build/.configured" ]
}

# configure PRESET [ARGUMENT...]
configure() {
  configure_in "$1" "$@"
}

# configure_in FOLDER PRESET [ARGUMENT...]: in another folder of build than that of the preset.
configure_in() {
  local folder=$1 build=$root/build/$1 preset=$2 fresh=()
  shift 2
  [ ! -e "$build" ] || [ -w "$build" ] || fail "$build belongs to another user; delete it or run as that user."
  if [ -e "$build/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    fresh=(--fresh)
    rm -f "$build/.configured"
  fi
  [ $# -gt 0 ] || is_unconfigured "$build" || return 0
  stage "configure $folder"
  (cd "$root" && cmake --preset "$preset" -B "$build" "${fresh[@]}" "$@") || fail "preset $preset could not be configured."
  touch "$build/.configured"
}

# build FOLDER [TARGET...]: the folder of build, which bears the name of its preset.
build() {
  local folder=$1
  shift
  stage "build $folder${*:+: $*}"
  ninja -C "$root/build/$folder" -j "$jobs" "$@" || fail "build/$folder could not be built."
}

# run_tests PRESET [CTEST ARGUMENT...]
run_tests() {
  local preset=$1
  shift
  stage "test $preset"
  (cd "$root" && ctest --preset "$preset" --parallel "$jobs" --no-tests=error "$@") ||
    fail "tests of preset $preset failed; the list is above."
}

# Names of the executables that a build tree can make in a folder, without the folder.
targets_in() {
  local preset=$1 folder=$2 prefix=$3
  ninja -C "$root/build/$preset" -t targets all |
    sed -n "s|^$folder/\($prefix[a-z0-9_]*\): CXX_EXECUTABLE_LINKER.*|\1|p" | sort
}
