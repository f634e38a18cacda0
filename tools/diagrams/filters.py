# SPDX-License-Identifier: Apache-2.0
"""Who meets whom: the questions in the order in which they are asked."""

from picture import Picture

QUESTIONS = (
    ("Do the boxes overlap?", "abut_universe_refresh, abut_universe_step"),
    ("Are the parts two, and one of them dynamic?", "abut_part_set_motion"),
    ("Is neither geometry parked?", "abut_geometry_park"),
    ("Have they no exclusion bit in common?", "abut_geometry_options.exclusion"),
    ("Does each one's layer meet the other one's mask?", "abut_geometry_options.layers, .mask"),
    ("Does the most specific rule allow it?", "abut_rule_set"),
    ("Does your filter keep it?", "abut_universe_set_filter"),
    ("Do the two kinds have an answer?", "abut_pair_support"),
    ("Is the distance on the right side of the tolerance?", "abut_universe_options.tolerance_mode"),
)


def draw():
    picture = Picture(760, 470, "A pair has contacts when it passes all of these questions")
    picture.text(24, 34, "From two geometries to a contact", size=16, is_bold=True)
    picture.text(736, 34, "where it is said", anchor="end", name="soft")
    for i, (question, call) in enumerate(QUESTIONS):
        y = 50 + i * 41
        name = "soft" if i == 0 else "b" if i > 6 else "a"
        picture.rectangle(24, y, 386, 32, name, pale=name, round_by=6)
        picture.text(38, y + 21, f"{i + 1}", name=name, is_bold=True)
        picture.text(62, y + 21, question)
        picture.lines([(416, y + 16), (430, y + 16)], "soft", thick=1, dash="3 3")
        picture.text(438, y + 20, call, size=12, name=name, is_code=True)
        picture.arrow((217, y + 33), (217, y + 41), "ink", head=6)
    y = 50 + len(QUESTIONS) * 41
    picture.rectangle(24, y, 386, 32, "good", pale="good", round_by=6)
    picture.text(217, y + 21, "contacts, events", anchor="middle", name="good", is_bold=True)
    picture.text(438, y + 20, "The first no ends it.", name="soft")
    return picture
