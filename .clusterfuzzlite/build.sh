#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Builds every pair's target and puts it with its seeds into $OUT. Compiler and flags are the project's
# own; the engine is what $LIB_FUZZING_ENGINE links.
set -euo pipefail
cd "$SRC/abut"
unset CC CXX CFLAGS CXXFLAGS
# Targets run on another image, which lacks the libraries that they load.
cmake --preset fuzz -D "ABUT_FUZZ_ENGINE=${LIB_FUZZING_ENGINE:--fsanitize=fuzzer}" -D 'CMAKE_BUILD_RPATH=$ORIGIN/lib'
cmake --build build/fuzz --target abut_fuzz_targets
mkdir -p "$OUT/lib"
for target in build/fuzz/fuzz/fuzz_*; do
  [ -f "$target" ] && [ -x "$target" ] || continue
  name=$(basename "$target") pair=${target##*/fuzz_}
  cp "$target" "$OUT/$name"
  ldd "$target" | sed -n 's#.* => \(/.*/lib\(abut\|ccd\|qhull\|tbb\).*\) (.*#\1#p' | xargs -r cp -t "$OUT/lib" --dereference
  [ ! -d "fuzz/corpus/$pair" ] || zip -qj "$OUT/${name}_seed_corpus.zip" fuzz/corpus/"$pair"/*
done
