#!/usr/bin/env bash
# Builds every pair's target with the project's own flags and puts it with its seeds into $OUT.
set -euo pipefail
cd "$SRC/abut"
unset CFLAGS CXXFLAGS
cmake --preset fuzz
cmake --build build/fuzz --target abut_fuzz_targets
for target in build/fuzz/fuzz/fuzz_*_*; do
  [ -f "$target" ] && [ -x "$target" ] || continue
  name=$(basename "$target") pair=${target##*/fuzz_}
  cp "$target" "$OUT/$name"
  [ ! -d "fuzz/corpus/$pair" ] || zip -qj "$OUT/${name}_seed_corpus.zip" fuzz/corpus/"$pair"/*
done
