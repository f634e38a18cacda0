#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints the raw layer of the crate, made from the C header by bindgen 0.60, which is that of Debian 12.
# usage: bindings/rust/raw.sh > bindings/rust/src/raw.rs
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd -P)

if [[ $(bindgen --version 2>/dev/null) != "bindgen 0.60."* ]] || ! command -v rustfmt >/dev/null; then
  echo "raw.sh: skipped: bindgen 0.60 or rustfmt is missing" >&2
  exit 77
fi
echo "// SPDX-License-Identifier: Apache-2.0"
echo "// Made by bindings/rust/raw.sh from include/abut/abut.h, where each name is described. Do not edit."
echo
bindgen "$root/include/abut/abut.h" --disable-header-comment --no-doc-comments --no-layout-tests --no-prepend-enum-name \
  --no-recursive-allowlist --allowlist-function 'abut_.*' --allowlist-type 'abut_.*' --allowlist-var 'ABUT_.*' \
  --with-derive-default --size_t-is-usize --rust-target 1.47 \
  --rustfmt-configuration-file "$root/bindings/rust/rustfmt.toml" -- -std=c99
