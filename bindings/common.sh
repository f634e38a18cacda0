# SPDX-License-Identifier: Apache-2.0
# Shared by the tests of the languages, which source it first.
# usage of each: test.sh <folder of libabut.so> <folder to build in>
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[1]}")" && pwd -P)
libraries=$1
out=$2
mkdir -p "$out"
export LD_LIBRARY_PATH="$libraries${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"

# need TOOL...: skips the test where one is missing.
need() {
  local tool
  for tool in "$@"; do
    command -v "$tool" >/dev/null || skip "$tool is missing; scripts/setup languages installs it"
  done
}

# What an installed library has: a file that tells pkg-config where it is.
describe_library() {
  cat > "$out/abut.pc" <<END
Name: abut
Description: the library of this build
Version: 0.2.0
Cflags: -I$(cd "$here/../../include" && pwd -P)
Libs: -L$libraries -labut
END
  sed 's/^Name: abut/&_picking/; s/-labut$/-labut_picking -labut/' "$out/abut.pc" > "$out/abut_picking.pc"
  export PKG_CONFIG_PATH=$out
}

skip() {
  echo "skipped: $*"
  exit 77
}

# first_query COMMAND...: the first query prints the same in every language.
first_query() {
  diff - <("$@") <<'EXPECTED' || { echo "the first query prints something else"; exit 1; }
distance -0.25, normal (0, 0, 1)
two boxes touch in 4 points
contact 0.25 deep
EXPECTED
}
