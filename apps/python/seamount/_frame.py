"""Where a raster lies."""

import dataclasses
import operator
import typing

from . import _core


class Transform(typing.NamedTuple):
    """Column and row of a cell's outer corner to places, as rasterio and GDAL have it: x = a column + b row + c,
    y = d column + e row + f. `affine.Affine(*transform)` is rasterio's own."""

    a: float
    b: float
    c: float
    d: float
    e: float
    f: float


@dataclasses.dataclass(frozen=True)
class Frame:
    """Size, cell, corner and coordinate system of a raster. Without a corner its middle is (0, 0)."""

    width: int
    height: int
    cell_m: float
    west_m: typing.Optional[float] = None
    north_m: typing.Optional[float] = None
    crs: str = ""

    def __post_init__(self):
        width, height, cell = operator.index(self.width), operator.index(self.height), float(self.cell_m)
        west = -0.5 * width * cell if self.west_m is None else float(self.west_m)
        north = 0.5 * height * cell if self.north_m is None else float(self.north_m)
        crs = _core.metric_crs(self.crs) if self.crs else ""
        for name, value in zip(_NAMES, _core.frame((width, height, cell, west, north, crs))):
            object.__setattr__(self, name, value)

    @classmethod
    def of_domain(cls, width_m=10240, height_m=10240, cell_m=10, crs="", x_m=0, y_m=0):
        """Of a domain as recipes state it: sides in metres around the place (x_m, y_m)."""
        return _frame(_core.domain(width_m, height_m, cell_m, crs, x_m, y_m))

    @classmethod
    def from_transform(cls, transform, width, height, crs=""):
        """Of a transform of rasterio or GDAL's order (a, b, c, d, e, f): north up, square cells."""
        a, b, c, d, e, f = tuple(transform)[:6]
        if b != 0 or d != 0 or not a > 0 or abs(a + e) > 1e-9 * a:
            raise ValueError(f"transform: {(a, b, c, d, e, f)} has no square cells with north up; warp the raster first")
        return cls(width, height, a, c, f, crs)

    @property
    def transform(self):
        return Transform(self.cell_m, 0.0, self.west_m, 0.0, -self.cell_m, self.north_m)

    @property
    def shape(self):
        """(rows, columns), as NumPy has it."""
        return self.height, self.width

    @property
    def bounds(self):
        """(west, south, east, north) in metres, as rasterio and geopandas have it."""
        return (self.west_m, self.north_m - self.height * self.cell_m, self.west_m + self.width * self.cell_m, self.north_m)

    @property
    def extent(self):
        """(west, east, south, north), as matplotlib's imshow wants it."""
        west, south, east, north = self.bounds
        return west, east, south, north

    @property
    def x(self):
        """Eastwards places of the columns' centres: a NumPy array."""
        import numpy
        return self.west_m + (numpy.arange(self.width) + 0.5) * self.cell_m

    @property
    def y(self):
        """Northwards places of the rows' centres, from the north down: a NumPy array."""
        import numpy
        return self.north_m - (numpy.arange(self.height) + 0.5) * self.cell_m

    def index(self, x, y):
        """(rows, columns) of the cells that places lie in, or of the nearest; arrays for arrays: array[frame.index(x, y)]."""
        import numpy
        rows = numpy.floor((self.north_m - numpy.asarray(y)) / self.cell_m).clip(0, self.height - 1).astype(int)
        columns = numpy.floor((numpy.asarray(x) - self.west_m) / self.cell_m).clip(0, self.width - 1).astype(int)
        return rows, columns


_NAMES = tuple(field.name for field in dataclasses.fields(Frame))


def _frame(values):
    """A frame of what the compiled part says, which is sound."""
    frame = object.__new__(Frame)
    for name, value in zip(_NAMES, values):
        object.__setattr__(frame, name, value)
    return frame


def as_tuple(frame):
    return frame.width, frame.height, frame.cell_m, frame.west_m, frame.north_m, frame.crs
