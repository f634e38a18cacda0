# SPDX-License-Identifier: Apache-2.0
"""What got slower or less exact from one report to another, beyond noise.

All times of a part by the same contender are first divided by the median of their ratios: a machine that is slower as a whole
is no news of one question. The part as a whole is told where it is slower than the peers have become."""

import statistics

SLOWER = 1.5  # times of single rows on a shared machine scatter by less
LESS_EXACT = 4.0
LEAST_ERROR = 1e-14  # below it errors are rounding

_KEYS = {"accuracy": ("question", "condition", "pair", "contender"), "deforming": ("question", "pair", "contender"),
         "extremes": ("map", "question", "x", "y", "contender"),
         "response": ("trial", "contender", "effort"), "steadiness": ("ground", "body", "motion", "jitter"), "universe": ("scene", "contender"),
         "builds": ("name",)}
_TIMES = {"accuracy": "nanoseconds", "deforming": "nanoseconds", "response": "milliseconds", "steadiness": "microseconds", "universe": "milliseconds",
          "builds": "step_microseconds"}
_ERRORS = {"accuracy": ("worst",), "deforming": ("worst",), "extremes": ("worst",), "response": ("error",),
           "universe": (), "steadiness": ("lost", "flicker", "churn", "lean", "drift"), "builds": ("bytes", "resident_bytes")}


def _by_key(part, name):
    return {tuple(row.get(key) for key in _KEYS[name]): row for row in part["rows"]}


def _both(old, new, name):
    before, after = (_by_key(document[name], name) for document in (old, new))
    return [(key, before[key], after[key]) for key in after if key in before]


def _is_ours(key, name):
    return name in ("steadiness", "builds") or any(str(part).startswith("abut") for part in key)


def _slower(rows, name):
    ratios = {key: after[_TIMES[name]] / before[_TIMES[name]] for key, before, after in rows
              if before.get(_TIMES[name], 0) > 0 and after.get(_TIMES[name], 0) > 0}
    if not ratios:
        return
    ours = [ratio for key, ratio in ratios.items() if _is_ours(key, name)]
    peers = [ratio for key, ratio in ratios.items() if not _is_ours(key, name)]
    if ours and peers and statistics.median(ours) > 1.1 * statistics.median(peers):
        yield f"{name}: abut takes {statistics.median(ours) / statistics.median(peers):.2f} times as long, by the times of its peers"
    usual = statistics.median(peers or ratios.values())
    for key, ratio in ratios.items():
        if _is_ours(key, name) and ratio > SLOWER * usual:
            yield f"{name}: {'/'.join(map(str, key))} takes {ratio / usual:.2f} times as long"


def _less_exact(rows, name):
    for key, before, after in rows:
        if not _is_ours(key, name):
            continue
        for error in _ERRORS[name]:
            was, now = before.get(error), after.get(error)
            if was is None or now is None:
                if was is not None:
                    yield f"{name}: {'/'.join(map(str, key))} has no {error} any more, it was {was:.3g}"
                continue
            limit = 1.05 * was if name == "builds" else max(LESS_EXACT * was, LEAST_ERROR)
            if now > limit:
                yield f"{name}: {error} of {'/'.join(map(str, key))} is {now:.3g}, it was {was:.3g}"
        was, now = (sum(row.get("failures", {}).values()) for row in (before, after))
        if now > was:
            yield f"{name}: {'/'.join(map(str, key))} fails in {now} cases, it was {was}"


def differences(old, new):
    """Lines, the worst news of each part first by kind."""
    for name in _KEYS:
        if name in old and name in new:
            rows = _both(old, new, name)
            if name in _TIMES:
                yield from _slower(rows, name)
            yield from _less_exact(rows, name)
