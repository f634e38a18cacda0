# SPDX-License-Identifier: Apache-2.0
"""What builds without some shapes and features save."""

import words


def sections(document):
    head = ["build", "shapes", "features", "libabut.so", "stripped", "start of a program", "resident", "step of 3,375 bodies", "libraries loaded"]
    rows = []
    for one in document["builds"]["rows"]:
        rows.append([one["name"], one.get("shapes", "-"), one.get("features", "-") or "none", words.size(one["bytes"]),
                     words.size(one["stripped_bytes"]), f"{one['start_milliseconds']:.2f} ms", words.size(one["resident_bytes"]),
                     words.time(one["step_microseconds"] * 1e3) if one["step_microseconds"] else "-", ", ".join(one["libraries"])])
    yield {"id": "builds", "title": "What was left out", "figures": [], "keys": [], "tables": [{"head": head, "rows": rows}],
           "text": ["Real builds. The start is that of a program which makes a universe, or asks for a pair where the build has none, less that "
                    "of one which does nothing. "
                    "Resident bytes are those of the process after the steps."]}
