#!/usr/bin/env python3
"""Draws who includes whom in src/seamount as docs/includes.svg: modules, families and rooms in the order of the layers.

An arrow goes from a box to one that it includes; its number and width say how many #include lines there are (tests aside).
--check draws nothing and fails if the drawing is not that of the sources.
"""

import collections
import html
import pathlib
import re
import sys

import check_layers

ROOT = pathlib.Path(__file__).resolve().parent.parent
DRAWING = ROOT / "docs/includes.svg"
INCLUDE = re.compile(r'^\s*#\s*include\s*"seamount/([^"]+)"', re.MULTILINE)
# Modules from the top down, a row each; beside each other where neither includes the other.
ROWS = [["apps"], ["server", "tiles"], ["recipe", "train"], ["ops", "io"], ["geom"], ["model"], ["base"]]
HOUSES = [house for house in check_layers.ROOMS if "/" in house]  # families with rooms of their own, drawn below
COLOURS = {"apps": "#7b5ea7", "server": "#a8577e", "tiles": "#a8577e", "recipe": "#a8577e", "train": "#a8577e", "ops": "#2f7d6d", "io": "#b07a2a",
           "geom": "#2c6e9e", "model": "#4a5d73", "base": "#59636e"}
MARGIN, GAP = 30, 26
BOX_WIDTH, BOX_HEIGHT, BOX_GAP, TITLE, ROW_GAP = 118, 46, 18, 40, 74


def places(path):
    """Where a file below src/seamount is: (module, family or room or "") and, in a family with rooms, (family, room)."""
    *parts, _ = path.parts
    yield parts[0], parts[1] if len(parts) > 1 else ""
    if "/".join(parts[:2]) in HOUSES and len(parts) > 2:
        yield "/".join(parts[:2]), parts[2]


def count_includes():
    """(number of files by place, number of #include lines by pair of places)."""
    files, lines = collections.Counter(), collections.Counter()
    for folder, name in [(ROOT / "src/seamount", None), (ROOT / "apps", "apps")]:
        for path in sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cpp") and not p.stem.endswith("_test")):
            targets = [there for target in INCLUDE.findall(path.read_text()) for there in places(pathlib.PurePath(target))]
            for here in [(name, "")] if name else places(path.relative_to(folder)):
                files[here] += 1
                lines.update((here, there) for there in targets if there != here and (here[0] == there[0] or
                             not {here[0], there[0]} & set(HOUSES)))
    return files, lines


def parts_of(module, files):
    """The families or rooms of a module, those that others stand on first."""
    parts = sorted(part for name, part in files if name == module and part)
    order = check_layers.ROOMS.get(module, "").split()
    return sorted(parts, key=lambda part: (order.index(part) if part in order else len(order), part))


def text(x, y, words, size, colour, weight="400", anchor="middle"):
    return (f'<text x="{x:g}" y="{y:g}" font-size="{size}" fill="{colour}" font-weight="{weight}" '
            f'text-anchor="{anchor}">{html.escape(words)}</text>')


def pale(colour):
    """The colour, nine parts white."""
    return "#" + "".join(f"{round(0.9 * 255 + 0.1 * int(colour[i:i + 2], 16)):02x}" for i in (1, 3, 5))


class Drawing:
    def __init__(self, files, lines):
        self.files, self.lines = files, lines
        self.boxes, self.arrows, self.arcs, self.labels, self.frames = [], [], [], [], {}
        rows = [[module for module in row if any(name == module for name, _ in files)] for row in ROWS]
        self.width = 2 * MARGIN + max(self.row_width(row) for row in rows)
        y = 92
        for row in rows:
            y = self.add_row(row, y) + ROW_GAP
        self.add_arrows()
        y = self.add_row(HOUSES, y - ROW_GAP / 2)
        self.height = y + MARGIN

    def module_width(self, module):
        return max(150, len(parts_of(module, self.files)) * (BOX_WIDTH + BOX_GAP) + BOX_GAP)

    def row_width(self, row):
        return sum(self.module_width(module) for module in row) + GAP * 2 * (len(row) - 1)

    def add_row(self, row, y):
        widths = [self.module_width(module) for module in row]
        x = (self.width - self.row_width(row)) / 2
        height = max(TITLE + (BOX_HEIGHT + 40 if parts_of(module, self.files) else 14) for module in row)
        for module, width in zip(row, widths):
            self.add_module(module, x, y, width, height)
            x += width + GAP * 2
        return y + height

    def add_module(self, module, x, y, width, height):
        colour = COLOURS[module.split("/")[0]]
        parts = parts_of(module, self.files)
        number = sum(n for (name, _), n in self.files.items() if name == module)
        self.frames[module] = (x, y, width, height)
        self.boxes.append(f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{height:g}" rx="9" '
                          f'fill="{pale(colour)}" stroke="{colour}" stroke-width="1.6"/>')
        middle = y + (26 if parts else height / 2 + 5)
        self.boxes.append(text(x + width / 2, middle, f"{module}  ·  {number} files", 15, colour, "600"))
        centres = {}
        for index, part in enumerate(parts):
            left, top = x + BOX_GAP + index * (BOX_WIDTH + BOX_GAP), y + TITLE
            centres[part] = left + BOX_WIDTH / 2
            self.boxes.append(f'<rect x="{left:g}" y="{top:g}" width="{BOX_WIDTH}" height="{BOX_HEIGHT}" rx="6" '
                              f'fill="#ffffff" stroke="{colour}" stroke-width="1.1"/>')
            self.boxes.append(text(centres[part], top + 20, part, 14, "#1f2933", "600"))
            self.boxes.append(text(centres[part], top + 37, f"{self.files[module, part]} files", 11.5, "#66707b"))
        self.add_inner_arrows(module, centres, y + TITLE + BOX_HEIGHT, colour)

    def add_inner_arrows(self, module, centres, y, colour):
        """Arcs below the parts of a module: from a part to one that it includes."""
        for (here, there), count in sorted(self.lines.items()):
            if here[0] == there[0] == module and here[1] in centres and there[1] in centres:
                start, end = centres[here[1]] - 8, centres[there[1]] + 8
                mark = module.split("/")[0]
                depth = 8 + 7 * abs(start - end) / (BOX_WIDTH + BOX_GAP)
                self.arcs.append(f'<path d="M{start:g} {y:g} C{start:g} {y + depth:g} {end:g} {y + depth:g} {end:g} {y + 3:g}" '
                                   f'fill="none" stroke="{colour}" stroke-opacity="0.75" stroke-width="{self.stroke(count):.1f}" '
                                   f'marker-end="url(#{mark})"><title>{here[1]} → {there[1]}: {count}</title></path>')

    @staticmethod
    def stroke(count):
        return min(7.0, 0.8 + 0.42 * count ** 0.5)

    def add_arrows(self):
        """Arrows between modules, spread along their edges."""
        between = collections.Counter()
        for (here, there), count in self.lines.items():
            if here[0] != there[0]:
                between[here[0], there[0]] += count
        order = {module: index for index, row in enumerate(ROWS) for module in row}
        leaving, reaching = collections.defaultdict(list), collections.defaultdict(list)
        for pair in sorted(between, key=lambda pair: (self.middle(pair[1]), order[pair[1]])):
            leaving[pair[0]].append(pair)
        for pair in sorted(between, key=lambda pair: (self.middle(pair[0]), -order[pair[0]])):
            reaching[pair[1]].append(pair)
        for pair, count in sorted(between.items()):
            x0 = self.spread(pair, leaving[pair[0]], pair[0])
            x1 = self.spread(pair, reaching[pair[1]], pair[1])
            y0 = self.frames[pair[0]][1] + self.frames[pair[0]][3]
            y1 = self.frames[pair[1]][1] - 5
            self.add_arrow(pair, count, (x0, y0), (x1, y1), order[pair[1]] - order[pair[0]])

    def middle(self, module):
        x, _, width, _ = self.frames[module]
        return x + width / 2

    def spread(self, pair, pairs, module):
        x, _, width, _ = self.frames[module]
        return x + width * (pairs.index(pair) + 1) / (len(pairs) + 1)

    def add_arrow(self, pair, count, start, end, rows):
        (x0, y0), (x1, y1) = start, end
        colour, bend = COLOURS[pair[0]], 0.45 * (y1 - y0)
        self.arrows.append(f'<path d="M{x0:g} {y0:g} C{x0:g} {y0 + bend:g} {x1:g} {y1 - bend:g} {x1:g} {y1:g}" fill="none" '
                           f'stroke="{colour}" stroke-opacity="0.55" stroke-width="{self.stroke(count):.1f}" '
                           f'marker-end="url(#{pair[0]})"><title>{pair[0]} → {pair[1]}: {count}</title></path>')
        self.labels.append(f'<rect x="{x0 - 15:g}" y="{y0 + 9:g}" width="30" height="17" rx="8" fill="#ffffff" '
                           f'stroke="{colour}" stroke-opacity="0.5"/>')
        self.labels.append(text(x0, y0 + 21.5, str(count), 11.5, colour, "600"))

    def svg(self):
        markers = "".join(f'<marker id="{name}" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="9" markerHeight="9" '
                          f'markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0 L8 4 L0 8 z" fill="{colour}"/></marker>'
                          for name, colour in COLOURS.items())
        title = [text(MARGIN, 40, "Who includes whom", 22, "#1f2933", "700", "start"),
                 text(MARGIN, 64, "Arrows go from what includes to what is included; numbers count #include lines, tests aside.",
                      13, "#66707b", "400", "start")]
        return "\n".join([
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {self.width:g} {self.height:g}" width="{self.width:g}" '
            f'height="{self.height:g}" font-family="DejaVu Sans, Helvetica, Arial, sans-serif">',
            f"<defs>{markers}</defs>",
            f'<rect width="{self.width:g}" height="{self.height:g}" fill="#ffffff"/>',
            *title, *self.arrows, *self.boxes, *self.arcs, *self.labels, "</svg>", ""])


def main(arguments):
    svg = Drawing(*count_includes()).svg()
    if "--check" not in arguments:
        DRAWING.write_text(svg)
    elif not DRAWING.exists() or DRAWING.read_text() != svg:
        print("docs/includes.svg is not of these sources: tools/draw_includes.py draws it anew", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
