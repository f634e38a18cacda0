#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Gathers the live targets as for ClusterFuzzLite, and checks what it asks of them: regular files that run and name the
# function of a target, without the folder of the build. One of them runs over its seeds.
# usage: gathered.sh ROOT FOLDER-OF-TARGETS OUT
set -euo pipefail
root=$1 programs=$2 out=$3
fail() {
  echo "gathered: $*" >&2
  exit 1
}

rm -rf "$out"
"$root/.clusterfuzzlite/gather.sh" "$programs" "$out"
count=0
for target in "$out"/fuzz_*; do
  [[ $target != *.zip ]] || continue
  count=$((count + 1))
  [ -f "$target" ] && [ ! -L "$target" ] && [ -x "$target" ] || fail "$target is no regular file that runs."
  grep -q LLVMFuzzerTestOneInput "$target" || fail "$target does not name LLVMFuzzerTestOneInput."
  # The 171 of all pairs and the libraries are to fit into 500 MB.
  [ "$(stat -c %s "$target")" -le 2500000 ] || fail "$target has $(stat -c %s "$target") bytes; 2500000 are allowed."
  seeds=${target}_seed_corpus.zip
  [ -s "$seeds" ] || fail "$target has no seeds."
done
[ "$count" -gt 0 ] || fail "there are no targets in $programs."
rm -rf "$out/seeds" && mkdir "$out/seeds"
python3 -m zipfile -e "$seeds" "$out/seeds"
name=$(basename "$seeds" _seed_corpus.zip)
runs=$("$out/$name" -runs=0 -artifact_prefix="$out/" "$out/seeds" 2>&1) || fail "$name fails: $runs"
grep -q "INFO: *$("$root/fuzz/corpus_of.sh" "${name#fuzz_}" | wc -l) files found" <<<"$runs" || fail "$name did not read its seeds: $runs"
echo "gathered: $count targets of $(du -sm "$out" | cut -f1) MB in all"
