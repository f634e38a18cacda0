# SPDX-License-Identifier: Apache-2.0
"""The questions of the table in README.md: time and worst error of abut and its peers, out of a report.json."""

# Words, question, pair of kinds; of a step the scene.
ASKED = [("gap of two boxes", "distance", "box-box"),
         ("gap of two cylinders", "distance", "cylinder-cylinder"),
         ("gap of two hulls of 200 points", "distance", "hull200-hull200"),
         ("whether two hulls of 32 points overlap", "overlap", "hull32-hull32"),
         ("contacts of two spheres", "contacts", "sphere-sphere"),
         ("contacts of two boxes", "contacts", "box-box"),
         ("contacts of two hulls of 32 points", "contacts", "hull32-hull32"),
         ("contacts of a ball on a mesh", "contacts", "mesh-sphere"),
         ("first hit of a ray on a mesh", "ray", "mesh"),
         ("first touch of two boxes that turn", "impact", "box-box")]
STEPS = [("step of 5,000 bodies in a pile", "pile"), ("step of 5,000 sparse bodies", "sparse")]
PEERS = {"abut": "abut", "Bullet": "bullet", "FCL": "fcl", "ODE": "ode"}

# An answer that is off by more, or that fails more often, is another one.
FAR_OFF, MOST_FAILED = 1e-3, 0.05
# So is one with fewer contacts than this part of those of abut.
LEAST_POINTS = 0.9


def _answer(row, ours):
    is_other = ((row.get("p99") or 0) > FAR_OFF or sum(row["failures"].values()) > MOST_FAILED * row["cases"]
                or row.get("points", 1) < LEAST_POINTS * ours.get("points", 1))
    return {"nanoseconds": row["nanoseconds"], "worst": row.get("worst"), "is_other": is_other}


def rows(document):
    """Of those questions that were measured."""
    found = []
    accuracy = document.get("accuracy", {}).get("rows", [])
    for words, question, pair in ASKED:
        its = {row["contender"]: row for row in accuracy if (row["question"], row["condition"], row["pair"]) == (question, "ordinary", pair)}
        if "abut" in its:
            found.append({"question": words, "answers": {name: _answer(its[key], its["abut"]) for name, key in PEERS.items()
                                                         if key in its and its[key]["nanoseconds"] > 0}})
    for words, scene in STEPS:
        its = {row["contender"]: row for row in document.get("universe", {}).get("rows", []) if row["scene"] == scene}
        if "abut" in its:
            found.append({"question": words, "answers": {name: {"nanoseconds": 1e6 * its[key]["milliseconds"], "worst": None, "is_other": False}
                                                         for name, key in PEERS.items() if key in its}})
    return found
