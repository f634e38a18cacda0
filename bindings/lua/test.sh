#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the LuaJIT module, its first query, and that it declares what the header does.
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
need luajit python3

diff "$here/abut_cdef.lua" <("$here/cdef.py") || {
  echo "abut_cdef.lua is not that of the header: bindings/lua/cdef.py > bindings/lua/abut_cdef.lua"
  exit 1
}
export LUA_PATH="$here/?.lua"
luajit "$here/test_abut.lua"
first_query luajit "$here/first_query.lua"
