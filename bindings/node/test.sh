#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the Node package, its types and its first query, in a copy that has what the lock file names.
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
need node npm

cp "$here"/*.mjs "$here"/*.ts "$here"/*.json "$out"
cd "$out"
if ! cmp -s package-lock.json node_modules/.installed; then
  npm ci --ignore-scripts --no-audit --no-fund --fetch-retries=0 >npm.log 2>&1 ||
    skip "koffi is not installed and npm could not fetch it: $(grep --max-count=1 "error" npm.log)"
  cp package-lock.json node_modules/.installed
fi
export ABUT_LIBRARY=$libraries/libabut.so
if [[ -e $libraries/libabut_picking.so ]]; then
  export ABUT_PICKING_LIBRARY=$libraries/libabut_picking.so
fi
npx --no-install tsc
node --expose-gc --test
first_query node first_query.mjs
