#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds every target under $SANITIZER and puts it with its seeds into $OUT. Compiler and flags are the project's own; the
# engine is what $LIB_FUZZING_ENGINE links.
set -euo pipefail
case ${SANITIZER:-address} in
  address) sanitize=fuzzer-address ;;
  undefined) sanitize=fuzzer-undefined ;;
  coverage) sanitize=coverage ;;
  memory)
    echo "build.sh: SANITIZER is memory, which needs libraries of others (qhull, ccd, tbb, libstdc++) built with it; there are address, undefined and coverage." >&2
    exit 1
    ;;
  *)
    echo "build.sh: SANITIZER is \"$SANITIZER\"; there are address, undefined and coverage." >&2
    exit 1
    ;;
esac
cd "$SRC/abut"
unset CC CXX CFLAGS CXXFLAGS
# Targets run on another image, which lacks the libraries that they load. Programs find them in lib, and they each other.
cmake --preset fuzz -D "ABUT_SANITIZE=$sanitize" -D "ABUT_FUZZ_ENGINE=${LIB_FUZZING_ENGINE:--fsanitize=fuzzer}" \
  -D CMAKE_BUILD_RPATH_USE_ORIGIN=ON -D 'CMAKE_BUILD_RPATH=$ORIGIN/lib;$ORIGIN'
cmake --build build/fuzz --target abut_fuzz_targets
.clusterfuzzlite/gather.sh build/fuzz/fuzz "$OUT"
