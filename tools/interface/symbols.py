# SPDX-License-Identifier: Apache-2.0
"""What each library exports: the list that its link and its test go by."""


def files(interface, _notice):
    lists = {}
    for header in interface.headers:
        prefix = "" if header is interface.headers[0] else f"{header.name}_"
        lists[f"capi/{prefix}symbols.txt"] = "".join(f"{name}\n" for name in sorted(f.name for f in header.functions))
    return lists
