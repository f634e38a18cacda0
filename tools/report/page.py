# SPDX-License-Identifier: Apache-2.0
"""index.html of report.json, and nothing else."""

from pathlib import Path

import jinja2

import builds
import chart
import maps
import moving
import pairs
import steady
import steps
import words
import work


def sections(document, book):
    """Of the parts that the document has, in the order of the page."""
    if "accuracy" in document or "deforming" in document:
        yield from work.sections(document, book)
        yield from work.promises(document)
    if "extremes_by_map" in document:
        yield from maps.summary(document)
    if "extremes" in document:
        yield from maps.extremes(document, book)
    if "response" in document:
        yield from moving.sections(document)
    if "response_maps" in document:
        yield from maps.response(document)
    if "steadiness" in document:
        yield from steady.sections(document)
    if "universe" in document:
        yield from steps.sections(document)
    if "builds" in document:
        yield from builds.sections(document)


def render(document):
    environment = jinja2.Environment(autoescape=True, trim_blocks=True, undefined=jinja2.ChainableUndefined,
                                     loader=jinja2.FileSystemLoader(Path(__file__).resolve().parent))
    book = pairs.Book(document)
    every = list(sections(document, book))
    letters = "; ".join(f"{letter}: {what}" for letter, what in words.FAILURES.values())
    return environment.get_template("page.html").render(
        machine=document["machine"], sections=every, pairs=list(book.entries()), key=chart.key,
        failure_words=f"Errors are parts of the size, the sum of the diameters of both shapes, beside an oracle in 113-bit floating "
                      f"point that shares no code with abut. What failed is not in them. {letters}.")
