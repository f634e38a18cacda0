#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints what the Lua module declares: the header as ffi.cdef takes it, without comments and macros.

usage: bindings/lua/cdef.py > bindings/lua/abut_cdef.lua
"""

import re
from pathlib import Path

header = (Path(__file__).resolve().parents[2] / "include/abut/abut.h").read_text(encoding="utf-8")
version = re.search(r"#define ABUT_VERSION_MAJOR (\d+)\n#define ABUT_VERSION_MINOR (\d+)", header)
text = re.sub(r"/\*.*?\*/", "", header, flags=re.DOTALL)
text = re.sub(r'#ifdef __cplusplus\n.*?#endif\n', "", text, flags=re.DOTALL)
text = re.sub(r"^\s*#(?:.*\\\n)*.*\n", "", text, flags=re.MULTILINE)
text = text.replace("ABUT_API ", "")
text = re.sub(r" ABUT_ENUM\(\w+\)", "", text)
text = re.sub(r"[ \t]+$", "", text, flags=re.MULTILINE)
text = re.sub(r"\n{2,}", "\n", text).strip()

print("-- SPDX-License-Identifier: Apache-2.0")
print("-- Made by bindings/lua/cdef.py from include/abut/abut.h, where each name is described. Do not edit.")
print('require("ffi").cdef [[')
print(text)
print("]]")
print(f"return {{major = {version[1]}, minor = {version[2]}}}")
