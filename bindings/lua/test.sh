#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the LuaJIT module and its first query.
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
need luajit

export LUA_PATH="$here/?.lua"
luajit "$here/test_abut.lua"
if [[ -e $libraries/libabut_picking.so ]]; then
  luajit "$here/test_picking.lua"
fi
first_query luajit "$here/first_query.lua"
