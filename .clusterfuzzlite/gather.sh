#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Puts the targets of a build into a folder that moves to another machine: one small program for each target, the libraries
# that they share, once, and the seeds. A link would be no target there: only regular files count.
# usage: gather.sh FOLDER-OF-TARGETS OUT
set -euo pipefail
programs=$1 out=$(mkdir -p "$2/lib" && cd "$2" && pwd)
root=$(cd "$(dirname "$0")/.." && pwd)
for target in "$programs"/fuzz_*; do
  [ -f "$target" ] && [ -x "$target" ] || continue
  name=$(basename "$target") pair=${target##*/fuzz_}
  cp --dereference "$target" "$out/$name"
  "$root/fuzz/corpus_of.sh" "$pair" | xargs python3 -m zipfile -c "$out/${name}_seed_corpus.zip"
done
ldd "$programs"/fuzz_* | sed -n 's#.* => \(/.*/lib\(abut\|ccd\|qhull\|tbb\).*\) (.*#\1#p' | sort -u |
  xargs -r cp --dereference -t "$out/lib"
