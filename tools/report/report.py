#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures abut beside its peers and writes a page about it.

usage: report.py [--quick] [--only PART]... [--build FOLDER] [--lean FOLDER]... [--from FILE] [--compare FILE] [--publish]
       [--out FOLDER]
"""

import argparse
import json
import sys
from pathlib import Path

try:
    import compare
    import condense
    import document
    import page
    import publish
except ImportError as missing:
    print(f"report: {missing.name} is missing; Debian has python3-matplotlib and python3-jinja2", file=sys.stderr)
    sys.exit(2)


def arguments():
    parser = argparse.ArgumentParser(description="Measures abut beside its peers; writes report.json and index.html.")
    parser.add_argument("--quick", action="store_true", help="few cases and short runs, at most 3 minutes")
    parser.add_argument("--only", action="append", metavar="PART", help="accuracy, deforming, extremes, response, response_maps, steadiness, universe or builds")
    parser.add_argument("--build", type=Path, help="the build whose programs run")
    parser.add_argument("--lean", type=Path, action="append", default=[], metavar="FOLDER", help="another build, to be weighed beside")
    parser.add_argument("--from", dest="source", type=Path, metavar="FILE", help="draws a report.json; measures nothing")
    parser.add_argument("--compare", type=Path, metavar="FILE", help="prints what got slower or less exact since that report.json")
    parser.add_argument("--publish", action="store_true", help="writes the tables of the documents, and docs/report/report.json")
    parser.add_argument("--out", type=Path, help="where index.html and report.json go")
    return parser.parse_args()


def measured(its):
    import builds_measure
    import measure

    parts = [*measure.PROGRAMS, "universe", "builds"]
    for name in its.only or []:
        if name not in parts:
            raise document.Wrong(f"--only is {name}; there are: {', '.join(parts)}")
    build = its.build or measure.ROOT / "build" / "release"
    if not (build / "bench").is_dir():
        raise document.Wrong(f"{build} has no folder bench; expected a build with benchmarks, by --build, or a report.json that is drawn")
    report = measure.run(build, its.quick, its.only)
    if not its.only or "builds" in its.only:
        report["builds"] = {"rows": builds_measure.rows(build, its.lean)}
    return document.check(report)


def _out_folder():
    """That of the sources, or where the program is installed that of the caller."""
    root = Path(__file__).resolve().parents[2]
    return (root if (root / "CMakeLists.txt").exists() else Path.cwd()) / "out" / "report"


def main():
    its = arguments()
    report = document.read(its.source) if its.source else measured(its)
    old = document.read(its.compare) if its.compare else None
    out = its.out or (its.source.parent if its.source else _out_folder())
    out.mkdir(parents=True, exist_ok=True)
    if not its.source:
        (out / "report.json").write_text(json.dumps(report) + "\n", encoding="utf-8")
    (out / "index.html").write_text(page.render(report), encoding="utf-8")
    print(out / "index.html")
    if its.publish:
        publish.write(condense.condensed(report))
    if old:
        report = condense.condensed(report) if old.get("condensed") and not report.get("condensed") else report
        lines = list(compare.differences(old, report))
        print("\n".join(lines) if lines else "nothing got slower or less exact beyond noise")
        return 1 if lines else 0
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except document.Wrong as error:
        print(f"report: {error}", file=sys.stderr)
        sys.exit(2)
