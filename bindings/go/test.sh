#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the Go package and its first query.
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
need go pkg-config cc

describe_library
export GOCACHE=$out/cache GOFLAGS=-buildvcs=false GOPROXY=off CGO_ENABLED=1
cd "$here"
packages=(.)
if [[ -e $libraries/libabut_picking.so ]]; then
  packages+=(./picking)
fi
go vet "${packages[@]}" ./first_query
go test "${packages[@]}"
first_query go run ./first_query
