# SPDX-License-Identifier: Apache-2.0
"""A picture as SVG. It refuses text that is small, leaves the picture, or runs into other text."""

import math
from xml.sax.saxutils import escape

from palette import style

LEAST_TEXT = 12
_NARROW, _WIDE = "fijltrI.,:;'|!()[]-/ ", "mwMW@%"


def text_width(text, size, is_bold=False):
    """About how wide a text is in a sans-serif font, rather too much than too little."""
    units = sum(0.33 if c in _NARROW else 0.88 if c in _WIDE else 0.7 if c.isupper() else 0.57 for c in text)
    return units * size * (1.06 if is_bold else 1.0)


def turned(point, angle, centre=(0.0, 0.0)):
    """A point turned about a centre; a positive angle, in degrees, turns counter-clockwise as the reader sees it."""
    c, s = math.cos(math.radians(angle)), -math.sin(math.radians(angle))
    x, y = point
    return (centre[0] + c * x - s * y, centre[1] + s * x + c * y)


def _number(value):
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _points(points):
    return " ".join(f"{_number(x)},{_number(y)}" for x, y in points)


class Picture:
    """x runs to the right and y down, in pixels."""

    def __init__(self, width, height, title):
        self.width, self.height, self.title = width, height, title
        self._parts, self._texts = [], []

    def _draw(self, element, line=None, area=None, pale=None, thick=1.5, dash="", opacity=1.0):
        classes = [f"{kind}-{name}" for kind, name in (("l", line), ("f", area), ("p", pale)) if name]
        attributes = f' class="{" ".join(classes)}"'
        attributes += "" if area or pale else ' fill="none"'
        attributes += f' stroke-width="{_number(thick)}"' if line else ""
        attributes += f' stroke-dasharray="{dash}"' if dash else ""
        attributes += f' opacity="{_number(opacity)}"' if opacity < 1 else ""
        self._parts.append(f"<{element}{attributes}/>")

    def lines(self, points, line="ink", **how):
        self._draw(f'polyline points="{_points(points)}" stroke-linejoin="round" stroke-linecap="round"', line, **how)

    def polygon(self, points, line=None, **how):
        self._draw(f'polygon points="{_points(points)}" stroke-linejoin="round"', line, **how)

    def rectangle(self, x, y, width, height, line=None, round_by=0, **how):
        corner = f' rx="{_number(round_by)}"' if round_by else ""
        where = f'x="{_number(x)}" y="{_number(y)}" width="{_number(width)}" height="{_number(height)}"'
        self._draw(f"rect {where}{corner}", line, **how)

    def circle(self, centre, radius, line=None, **how):
        self._draw(f'circle cx="{_number(centre[0])}" cy="{_number(centre[1])}" r="{_number(radius)}"', line, **how)

    def ellipse(self, centre, radius_x, radius_y, line=None, **how):
        where = f'cx="{_number(centre[0])}" cy="{_number(centre[1])}" rx="{_number(radius_x)}" ry="{_number(radius_y)}"'
        self._draw(f"ellipse {where}", line, **how)

    def path(self, data, line=None, **how):
        self._draw(f'path d="{data}" stroke-linejoin="round"', line, **how)

    def arc(self, centre, radius, begin, end, line="ink", **how):
        """Part of a circle, from one angle to another in degrees, counter-clockwise as the reader sees it."""
        count = max(2, int(abs(end - begin) / 4))
        angles = [begin + (end - begin) * i / count for i in range(count + 1)]
        self.lines([turned((radius, 0), angle, centre) for angle in angles], line, **how)

    def dot(self, centre, name="ink", radius=4.0):
        self.circle(centre, radius, area=name)

    def arrow(self, begin, end, line="ink", head=9.0, is_double=False, **how):
        length = math.dist(begin, end)
        along = ((end[0] - begin[0]) / length, (end[1] - begin[1]) / length)
        tail = (begin[0] + along[0] * head * 0.8, begin[1] + along[1] * head * 0.8) if is_double else begin
        self.lines([tail, (end[0] - along[0] * head * 0.8, end[1] - along[1] * head * 0.8)], line, **how)
        for tip, sign in [(end, 1)] + ([(begin, -1)] if is_double else []):
            back = (tip[0] - sign * along[0] * head, tip[1] - sign * along[1] * head)
            across = (-along[1] * head * 0.4, along[0] * head * 0.4)
            self.polygon([tip, (back[0] + across[0], back[1] + across[1]), (back[0] - across[0], back[1] - across[1])], area=line)

    def measure(self, begin, end, line="ink"):
        """A length between two points: thin, with a head on both ends."""
        self.arrow(begin, end, line, head=7, is_double=True, thick=1.2)

    def _claim(self, text, box):
        """Remembers where a text lies, and refuses it where nobody could read it."""
        if box[0] < 4 or box[1] < 4 or box[2] > self.width - 4 or box[3] > self.height - 4:
            raise ValueError(f"{text!r} leaves the picture {self.title!r}: {[round(side) for side in box]}")
        for other, its in self._texts:
            if box[0] < its[2] and its[0] < box[2] and box[1] < its[3] and its[1] < box[3]:
                raise ValueError(f"{text!r} runs into {other!r} in the picture {self.title!r}")
        self._texts.append((text, box))

    def text(self, x, y, text, size=13, anchor="start", name="ink", is_bold=False, is_code=False, is_upward=False):
        """One line of text from a point of its base line, to the right or upward."""
        if size < LEAST_TEXT:
            raise ValueError(f"{text!r} has size {size}; at least {LEAST_TEXT} is readable")
        width = 0.62 * size * len(text) if is_code else text_width(text, size, is_bold)
        back = {"start": 0, "middle": width / 2, "end": width}[anchor]
        if is_upward:
            self._claim(text, (x - 0.76 * size, y + back - width, x + 0.22 * size, y + back))
        else:
            self._claim(text, (x - back, y - 0.76 * size, x - back + width, y + 0.22 * size))
        attributes = f' text-anchor="{anchor}"' if anchor != "start" else ""
        attributes += ' font-weight="600"' if is_bold else ""
        attributes += " style=\"font-family:ui-monospace,'Liberation Mono',Menlo,monospace\"" if is_code else ""
        attributes += f' transform="rotate(-90 {_number(x)} {_number(y)})"' if is_upward else ""
        where = f'x="{_number(x)}" y="{_number(y)}" font-size="{_number(size)}"'
        self._parts.append(f'<text {where} class="f-{name}"{attributes}>{escape(text)}</text>')

    def paragraph(self, x, y, lines, step=18, **how):
        for i, line in enumerate(lines):
            self.text(x, y + i * step, line, **how)

    def svg(self):
        head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}"'
        head += f' viewBox="0 0 {self.width} {self.height}" role="img">'
        ground = f'<rect class="ground" x="0.5" y="0.5" width="{self.width - 1}" height="{self.height - 1}" rx="8"/>'
        lines = ["<!-- SPDX-License-Identifier: Apache-2.0 -->", head, f"<title>{escape(self.title)}</title>"]
        return "\n".join([*lines, f"<style>{style()}</style>", ground, *self._parts, "</svg>", ""])
