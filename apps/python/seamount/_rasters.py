"""Values with numbers in cells: NumPy arrays with their frame beside them, none of them copied."""

import numpy

from . import _core, _interop, _pictures
from ._frame import Frame, _frame, as_tuple
from ._value import Value, invalid


class Raster(Value):
    """Base of values with numbers in cells."""

    __slots__ = ("_array",)
    dtype = numpy.dtype("float32")

    def __init__(self, array, frame=None, *, cell_m=None, crs=""):
        """Over a NumPy array of rows from the north; one of the right type whose rows stand side by side is not copied.
        `frame`, or the size of its cells: it then lies around (0, 0)."""
        array = _interop.plain_array(array, self.dtype)
        if frame is None:
            if cell_m is None:
                raise invalid("frame", "is missing: give a Frame, or cell_m")
            frame = Frame(array.shape[1], array.shape[0], cell_m, crs=crs)
        self._held = _core.raster(self.kind, as_tuple(frame), [array])
        self._array = array

    @property
    def array(self):
        """The numbers: float32 (uint8 for labels), rows from the north. A view of the value's memory, which it keeps alive;
        results of recipes cannot be written to."""
        array = getattr(self, "_array", None)
        if array is None:
            array = self._array = numpy.asarray(self._held.bands()[0])
        return array

    @property
    def frame(self):
        return _frame(self._held.frame)

    @property
    def crs(self):
        """Coordinate system: "EPSG:32604", WKT, or "" for local metres."""
        return self._held.frame[5]

    @property
    def transform(self):
        return self.frame.transform

    @property
    def bounds(self):
        return self.frame.bounds

    @property
    def shape(self):
        return self.frame.shape

    def __array__(self, dtype=None, copy=None):
        return _interop.asked_array(self.array, dtype, copy)

    def replace(self, array):
        """Another raster of this kind and frame."""
        return type(self)(array, self.frame)

    def to_xarray(self):
        """An xarray.DataArray with coordinates x and y and the system as rioxarray has it; the numbers are not copied."""
        return _interop.to_xarray(self)

    @classmethod
    def from_xarray(cls, data):
        """Of an xarray.DataArray with evenly spaced coordinates x and y."""
        return cls(*_interop.from_xarray(data))

    def to_rasterio_profile(self):
        """What rasterio.open(path, "w", **profile) wants to hold the array."""
        return _interop.to_rasterio_profile(self)

    @classmethod
    def from_rasterio(cls, dataset, band=1):
        """Of a band of an open data set of rasterio; cells that it masks have no value."""
        return cls(*_interop.from_rasterio(dataset, band))

    def _repr_png_(self):
        return _pictures.png_of(self)

    def __repr__(self):
        frame = self.frame
        where = f", {_core.crs_name(frame.crs)}" if frame.crs else ""
        return f"<seamount.{type(self).__name__} {frame.width} x {frame.height} cells of {frame.cell_m:g} m{where}>"


class Terrain(Raster):
    """Heights in metres above the sea."""

    __slots__ = ()
    kind = "terrain"


class Field(Raster):
    """Any other number of each cell: a mask, a depth, a share."""

    __slots__ = ()
    kind = "field"


class Labels(Raster):
    """The region of each cell: 0 mountain, 1 beach, 2 lagoon, 3 reef, 4 abyss."""

    __slots__ = ()
    kind = "labels"
    dtype = numpy.dtype("uint8")
    regions = ("mountain", "beach", "lagoon", "reef", "abyss")


class Current(Raster):
    """The flow at each cell in m/s: `east` and `north`, each an array."""

    __slots__ = ("_bands",)
    kind = "current"

    def __init__(self, east, north, frame):
        """Both arrays are copied."""
        bands = [_interop.plain_array(band, self.dtype) for band in (east, north)]
        self._held = _core.raster(self.kind, as_tuple(frame), bands)

    def _both(self):
        bands = getattr(self, "_bands", None)
        if bands is None:
            bands = self._bands = [numpy.asarray(band) for band in self._held.bands()]
        return bands

    @property
    def east(self):
        return self._both()[0]

    @property
    def north(self):
        return self._both()[1]

    @property
    def array(self):
        """Both components as one array of 2 x rows x columns: a copy; `east` and `north` are none."""
        return numpy.stack(self._both())

    def replace(self, array):
        return Current(array[0], array[1], self.frame)

    from_xarray = from_rasterio = None  # of one band each; see Field
