# SPDX-License-Identifier: Apache-2.0
"""A small report.json for tests, with a row of every kind."""

FAILURES = {"ended": 0, "none": 0, "not_finite": 0, "wrong_side": 0}


def judged(**members):
    return {"question": "distance", "contender": "abut", "nanoseconds": 80.0, "median": 1e-16, "p99": 1e-15, "worst": 2e-15, "cases": 4,
            "failures": dict(FAILURES), "worst_pair": 0} | members


def document():
    pose = {"position": [0.0, 0.0, 0.0], "quaternion": [1.0, 0.0, 0.0, 0.0]}
    shapes = [{"kind": "sphere", "radius": 1.0}, {"kind": "box", "half": [1.0, 2.0, 3.0]}]
    pairs = [{"a": 0, "pose_a": pose, "b": 1, "pose_b": pose | {"position": [4.0, 0.0, 0.0]}, "truth": 2.0}]
    names = ("abut", "abut 1e-2", "abut 1e-9", "bullet", "fcl")
    accuracy = [judged(condition=condition, pair=pair, contender=name, nanoseconds=50.0 * (i + 1), worst=10.0 ** (i - 15))
                for condition in ("ordinary", "far") for pair in ("sphere-box", "sphere-sphere") for i, name in enumerate(names)]
    accuracy[3]["failures"] = FAILURES | {"none": 2}
    for row in accuracy:
        if row["contender"].startswith("abut"):
            row["broken"] = {"outside": 0, "beyond": 0, "wide": 0}
    extremes = [judged(map=name, x=10.0 ** i, y=y, contender=contender) for i in range(4) for contender in ("abut", "fcl")
                for name, y in (("size ratio and aspect", 10.0), ("angle from parallel", "box-box"))]
    extremes[1]["failures"] = FAILURES | {"ended": 4}
    for name in ("median", "p99", "worst"):
        del extremes[1][name]
    deforming = [judged(question=question, condition="ordinary", pair="deforming_two", contender=name, nanoseconds=1e6 * (i + 1), worst=0.0)
                 for question in ("candidates", "overlap") for i, name in enumerate(("abut", "all pairs"))]
    for row in deforming:
        del row["worst_pair"]
    return {
        "version": 1, "machine": {"processor": "one of <many> & more", "run": "quick"},
        "accuracy": {"shapes": shapes, "pairs": pairs, "rows": accuracy},
        "deforming": {"steps": 3, "rows": deforming},
        "extremes": {"shapes": shapes, "pairs": pairs, "rows": extremes},
        "response": {"rows": [{"trial": "rolling", "error_is": "squared error, m^2", "contender": contender, "effort": effort,
                               "milliseconds": 0.1 + i, "error": 10.0 ** -i, "course": [[0.1, 1e-3], [0.2, 1e-2]]}
                              for contender in ("abut Newton", "Bullet") for i, effort in enumerate(("10", "50"))]},
        "response_maps": {"maps": [{"name": "spring", "error": "speed", "x": "stiffness, N/m", "y": "step, s", "rows": [
            {"x": 10.0 ** i, "y": 1e-3, "contender": "Bullet", "error": 0.1, "gain": 2.0, "microseconds": 3.0} for i in range(3)]}]},
        "steadiness": {"steps": 10, "dt": 1e-3, "rows": [
            {"ground": "plane", "body": "ball", "motion": "resting", "jitter": jitter, "lost": 0, "flicker": 0.1, "churn": 0, "lean": 0,
             "drift": 1e-9, "microseconds": 20.0} for jitter in ("0", "1 ulp")]},
        "universe": {"rows": [{"scene": "pile", "contender": name, "milliseconds": 6.0 + i} for i, name in enumerate(("abut", "bullet"))]},
        "builds": {"rows": [{"name": "release", "shapes": "all", "features": "hull", "bytes": 7000000, "stripped_bytes": 5000000,
                             "start_milliseconds": 1.5, "resident_bytes": 9000000, "step_microseconds": 900.0,
                             "libraries": ["libccd.so.2"]}]}}
