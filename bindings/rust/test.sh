#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the crate, its documents and its first query.
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
need cargo pkg-config

export CARGO_TARGET_DIR=$out CARGO_INCREMENTAL=0 CARGO_PROFILE_DEV_DEBUG=0
cd "$here"
features=()
if [[ -e $libraries/libabut_picking.so ]]; then
  features=(--features picking)
fi
ABUT_LIB_DIR=$libraries cargo test --offline --locked --quiet "${features[@]}"
describe_library
first_query cargo run --offline --locked --quiet --example first_query
