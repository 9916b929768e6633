#!/usr/bin/python3
"""Are what hydrology.flow has written water that gathers, whatever the size of the world? Read in windows.

  check_flow.py WATER DIRECTION [SURFACE [--sea LEVEL]]

WATER is its `cells` or `area`, DIRECTION its `direction`, SURFACE its `terrain`. Looked at is each cell beside its neighbours:

- what drains through it is itself and what drains through the neighbours that flow there, and so, with what ends where flow ends, all cells
  of the world: from counts of 2^22 on as exactly as float32 holds them;
- flow never leaves the world or the unknown, and never climbs on SURFACE; where a neighbour is lower it takes the steepest descent, the first of equal ones.

Flow along flats is told by the first of these: it comes from them, and never back. Needs python3-rasterio.
"""

import argparse
import sys

import numpy
import rasterio
import rasterio.errors
import rasterio.windows

DX = [1, 1, 0, -1, -1, -1, 0, 1]
DY = [0, -1, -1, -1, 0, 1, 1, 1]
ENDS, UNKNOWN = 8, 9  # codes beside the directions 0 to 7, counter-clockwise from east
ROUNDING = 2.0**-23
DIAGONAL = numpy.float32(0.70710678)


class Windows:
    """Blocks of a raster with a ring of one cell, `beyond` outside of it."""

    def __init__(self, path, beyond):
        self.file, self.beyond = rasterio.open(path), beyond
        self.width, self.height = self.file.width, self.file.height

    def ringed(self, column, row, width, height):
        made = numpy.full((height + 2, width + 2), self.beyond, self.file.dtypes[0])
        left, top = max(0, column - 1), max(0, row - 1)
        right, bottom = min(self.width, column + width + 1), min(self.height, row + height + 1)
        cells = self.file.read(1, window=rasterio.windows.Window(left, top, right - left, bottom - top))
        made[top - row + 1:bottom - row + 1, left - column + 1:right - column + 1] = cells
        return made


def codes_of(bearing):
    codes = numpy.where(bearing < 0, float(ENDS), numpy.mod(90.0 - bearing, 360.0) / 45.0)
    return numpy.where(numpy.isnan(bearing), UNKNOWN, codes).astype("uint8")


def beside(ringed, k, sign=1):
    """Of each inner cell, the neighbour in direction k, or opposite to it."""
    height, width = ringed.shape[0] - 2, ringed.shape[1] - 2
    return ringed[1 + sign * DY[k]:1 + sign * DY[k] + height, 1 + sign * DX[k]:1 + sign * DX[k] + width]


def steepest(surface, sea):
    """The direction of the steepest descent on the sea's surface or above it; ENDS where no neighbour is lower."""
    here = surface[1:-1, 1:-1]
    raised = numpy.maximum(surface, numpy.float32(sea))
    best, code = numpy.zeros_like(here), numpy.full(here.shape, ENDS, "uint8")
    for k in range(8):
        drop = here - beside(raised, k)
        drop = drop * DIAGONAL if k % 2 else drop
        better = drop > best
        best, code = numpy.where(better, drop, best), numpy.where(better, k, code).astype("uint8")
    return code


class Check:
    def __init__(self, options):
        self.water, self.direction = Windows(options.water, 0), Windows(options.direction, numpy.nan)
        self.surface = Windows(options.surface, numpy.nan) if options.surface else None
        sizes = {(one.width, one.height) for one in (self.water, self.direction, self.surface) if one}
        if len(sizes) > 1:
            sys.exit(f"they have different cells: {sorted(sizes)}")
        self.sea, self.one = options.sea, self.cells_of_a_count()
        self.known, self.ended, self.wrong = 0, 0.0, []

    def cells_of_a_count(self):
        """What WATER says of a cell through which nothing else drains: 1, or its area."""
        across, down = self.water.file.res
        first = self.water.ringed(0, 0, self.water.width, min(64, self.water.height))[1:-1, 1:-1]
        least = numpy.nanmin(first)
        return 1.0 if least == 1 else float(numpy.float32(across * down))

    def note(self, bad, column, row, what):
        if bad.any() and len(self.wrong) < 20:
            y, x = numpy.argwhere(bad)[0]
            self.wrong.append(f"column {column + x}, row {row + y}: {what} ({int(bad.sum())} cells in this block)")

    def block(self, column, row, width, height):
        place = (column, row, width, height)
        codes = codes_of(self.direction.ringed(*place))
        counts = numpy.nan_to_num(self.water.ringed(*place).astype("float64") / self.one)
        here, code = counts[1:-1, 1:-1], codes[1:-1, 1:-1]
        known = code != UNKNOWN
        entering, leaves = numpy.zeros_like(here), code == ENDS
        for k in range(8):
            entering += numpy.where(beside(codes, k, -1) == k, beside(counts, k, -1), 0.0)
            leaves |= (code == k) & (beside(codes, k) == UNKNOWN)
        unlike = numpy.abs(numpy.rint(here) - 1 - numpy.rint(entering)) > numpy.floor(ROUNDING * (here + entering))
        self.note(known & unlike, column, row, "not what enters and itself")
        self.known += int(known.sum())
        self.ended += float(here[known & leaves].sum())
        if self.surface:
            self.slopes(code, known, self.surface.ringed(*place), place)

    def slopes(self, code, known, surface, place):
        column, row, width, height = place
        here = surface[1:-1, 1:-1]
        y, x = numpy.mgrid[row:row + height, column:column + width]
        edge = (x == 0) | (y == 0) | (x == self.direction.width - 1) | (y == self.direction.height - 1)
        outside = edge | (here <= self.sea)
        self.note(known & (outside != (code == ENDS)), column, row, "flow ends elsewhere than at the edge or the sea")
        lowest = numpy.where(numpy.isnan(surface), -numpy.inf, surface)  # the unknown is below all
        way = steepest(lowest, self.sea)
        inner = known & ~outside
        self.note(inner & (way != ENDS) & (way != code), column, row, "not the steepest descent")
        climbs = numpy.zeros_like(known)
        for k in range(8):
            climbs |= (code == k) & (beside(lowest, k) > here)
        self.note(inner & climbs, column, row, "flow climbs")

    def run(self, size):
        for row in range(0, self.water.height, size):
            for column in range(0, self.water.width, size):
                self.block(column, row, min(size, self.water.width - column), min(size, self.water.height - row))
        if abs(self.ended - self.known) > ROUNDING * self.known:
            self.wrong.append(f"{self.ended:.0f} cells arrive where flow ends, of {self.known}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("water")
    parser.add_argument("direction")
    parser.add_argument("surface", nargs="?")
    parser.add_argument("--sea", type=float, default=-numpy.inf, help="height at and below which is open water; none if absent")
    parser.add_argument("--block", type=int, default=2048, help="cells of a side of what is looked at at once")
    options = parser.parse_args()
    try:
        check = Check(options)
    except rasterio.errors.RasterioIOError as error:
        sys.exit(str(error))
    check.run(options.block)
    for line in check.wrong:
        print(line)
    print(f"{check.known} cells, {check.ended:.0f} arrive where flow ends: {'WRONG' if check.wrong else 'right'}")
    return 1 if check.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
