#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the Go package and its first query.
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
need go pkg-config cc

# What an installed library has: a file that says where it is.
cat > "$out/abut.pc" <<END
Name: abut
Description: the library of this build
Version: 0
Cflags: -I$(cd "$here/../../include" && pwd -P)
Libs: -L$libraries -labut
END
export PKG_CONFIG_PATH=$out GOCACHE=$out/cache GOFLAGS=-buildvcs=false GOPROXY=off CGO_ENABLED=1
cd "$here"
go test ./...
first_query go run ./first_query
