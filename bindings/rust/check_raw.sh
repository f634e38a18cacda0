#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The raw layer of the crate is what bindgen makes of the header. Where bindgen is missing, it says so and ends with 77.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
made=$(./raw.sh) || exit $?
diff src/raw.rs <(echo "$made") || {
  echo "src/raw.rs is not that of the header: bindings/rust/raw.sh > bindings/rust/src/raw.rs"
  exit 1
}
