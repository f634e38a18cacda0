# SPDX-License-Identifier: Apache-2.0
"""What builds without a feature or a kind of shape answer: each function of theirs refuses.

A function belongs to what the folders of capi are called that it is defined in.
"""

import re
import textwrap
from pathlib import Path

PATH = "capi/absent.cpp"
FEATURES = ("universe", "motion", "deforming")
KINDS = {"fields": "distance_field"}
HEAD = """// SPDX-License-Identifier: Apache-2.0
// {notice}
// clang-format off
// Functions of features and of kinds of shapes that a build may leave out. They are weak: where the build has the
// feature, its own function takes their place. Options are filled with zeros, since nothing reads them.
#include "guard.hpp"
#include "options.hpp"

import abut.core.standard;

using namespace abut::capi;

namespace {{

abut_status refuse_absent(std::initializer_list<std::string_view> features) {{
  return guard([&] {{
    std::string_view missing;
    for (const std::string_view name : features) {{
      missing = missing.empty() && abut_has_feature(name.data()) == 0 ? name : missing;
    }}
    return refuse(ABUT_UNSUPPORTED, "this build of abut is without the feature \\"" + std::string(missing) + "\\"");
  }});
}}

abut_status refuse_kind(std::string_view name) {{
  return guard([&] {{ return refuse(ABUT_UNSUPPORTED, "this build of abut has no shape named " + std::string(name)); }});
}}

}}  // namespace

"""


def _rooms(root):
    """For each name that a source of capi defines the folders that this source lies in."""
    rooms = {}
    for path in sorted(Path(root, "capi").rglob("*.cpp")):
        folders = path.relative_to(Path(root, "capi")).parts[:-1]
        for name in re.findall(r"^[a-z]\w+ \*?(abut_\w+)\(", path.read_text(encoding="utf-8"), re.MULTILINE):
            rooms[name] = folders
    return rooms


def _body(function, features, kind):
    if function.can_fail:
        return f'return refuse_kind("{kind}");' if kind else \
            f"return refuse_absent({{{', '.join(f'{chr(34)}{name}{chr(34)}' for name in features)}}});"
    if function.name.endswith("_init"):
        out, size = function.parameters
        return f"fill_defaults({out.type.name}{{}}, {size.name}, {out.name});"
    return ""


def _weak(function, features, kind):
    is_used = function.name.endswith("_init")
    parameters = ", ".join(f"{its.type} {its.name}" if is_used else str(its.type) for its in function.parameters)
    lines = textwrap.wrap(f"[[gnu::weak]] {function.result} {function.name}({parameters}) {{", 118, subsequent_indent="    ",
                          break_on_hyphens=False)
    return "\n".join([*lines, *[f"  {body}" for body in [_body(function, features, kind)] if body], "}"])


def files(interface, notice):
    rooms = _rooms(interface.root)
    text = HEAD.format(notice=notice)
    for function in interface.headers[0].functions:
        folders = rooms.get(function.name, ())
        features = [name for name in FEATURES if name in folders]
        kinds = [KINDS[name] for name in folders if name in KINDS]
        if features or kinds:
            text += _weak(function, features, kinds[0] if kinds else None) + "\n"
    return {PATH: text + "// clang-format on\n"}
