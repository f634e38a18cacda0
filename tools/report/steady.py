# SPDX-License-Identifier: Apache-2.0
"""What trembling does to contacts over many steps, on each kind of ground."""

import maps

MEASURES = {"flicker": "steps at which the number of contacts changed", "lost": "steps without any contact",
            "churn": "contacts that were new", "lean": "sine of the worst normal to the vertical", "drift": "distance from the closed form, m"}


def sections(document):
    part = document["steadiness"]
    rows = part["rows"]
    figures = []
    for measure, what in MEASURES.items():
        for motion in dict.fromkeys(row["motion"] for row in rows):
            its = [row for row in rows if row["motion"] == motion]
            # Of all bodies the worst.
            worst = {}
            for row in its:
                place = (row["jitter"], row["ground"])
                worst[place] = max(worst.get(place, 0), row[measure])
            cells = [{"x": jitter, "y": ground, "error": value, "letters": ""} for (jitter, ground), value in worst.items()]
            figures.append({"svg": maps.draw(f"{measure}, {motion}", cells, "jitter, m", "", -16, 0), "caption": f"{what}, {motion}",
                            "table": None})
    head = ["ground", "body", "motion", "jitter", *MEASURES, "time of a step"]
    table = [[row["ground"], row["body"], row["motion"], row["jitter"], *(f"{row[name]:.2g}" for name in MEASURES),
              f"{row['microseconds']:.3g} µs"] for row in rows]
    yield {"id": "steady", "title": "Over time: contacts that tremble", "figures": figures, "keys": [],
           "tables": [{"head": head, "rows": table}],
           "text": [f"Flat grounds of every kind under bodies whose poses tremble, {part.get('steps', '?')} steps of {part.get('dt', '?')} s. Each "
                    "place shows the worst body as a power of ten; empty places are 0. "
                    + "; ".join(f"{name}: {what}" for name, what in MEASURES.items()) + ". Flicker, lost and churn are shares."]}
