#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the C# wrapper and its first query with the compiler and the runtime of Mono, which are in Debian.
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"
need mcs mono
export LC_ALL=C

# The test looks into the structs of the wrapper, so it is compiled with it.
mcs -warnaserror -out:"$out/test.exe" -reference:System.Core.dll "$here"/Abut/*.cs "$here/Test/Test.cs"
picking=()
if [[ -e $libraries/libabut_picking.so ]]; then
  picking=(picking)
fi
mono "$out/test.exe" "${picking[@]}"
mcs -warnaserror -target:library -out:"$out/Abut.dll" "$here"/Abut/*.cs
mcs -warnaserror -out:"$out/first_query.exe" -reference:"$out/Abut.dll" "$here/FirstQuery/FirstQuery.cs"
first_query mono "$out/first_query.exe"
