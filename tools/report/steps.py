# SPDX-License-Identifier: Apache-2.0
"""Steps of a universe beside the worlds of other libraries."""

import words


def sections(document):
    rows = document["universe"]["rows"]
    contenders = list(dict.fromkeys(row["contender"] for row in rows))
    table = []
    for scene in dict.fromkeys(row["scene"] for row in rows):
        its = {row["contender"]: row["milliseconds"] for row in rows if row["scene"] == scene}
        table.append([scene, *(words.time(1e6 * its[name]) if name in its else "-" for name in contenders)])
    yield {"id": "universe", "title": "Steps of 5,000 bodies that all move", "figures": [], "keys": [],
           "tables": [{"head": ["scene", *contenders], "rows": table}],
           "text": ["Poses are set and contacts are found, on one thread. In the pile the bodies lie on each other; in the other scene few touch."]}
