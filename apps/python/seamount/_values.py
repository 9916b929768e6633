"""What flows between operators. Rasters are NumPy arrays with their frame beside them; none of them is copied."""

import os

import numpy

from . import _core, _geo, _interop, _pictures
from ._frame import Frame, _frame, as_tuple
from ._notes import say


class Value:
    """Base of all values. They are made by operators, read from files, and can be pickled."""

    __slots__ = ("_held", "__weakref__")
    kind = ""

    @classmethod
    def _of(cls, held):
        value = object.__new__(cls)
        value._held = held
        return value

    @classmethod
    def read(cls, path, *, frame=None):
        """Of a file; what says nothing of its place is laid over `frame`. Raises IoError."""
        held, notes = _core.read(cls.kind, os.fsencode(path), None if frame is None else as_tuple(frame))
        say(notes)
        return cls._of(held)

    def save(self, path, as_=None, *, with_=None, progress=None, **params):
        """Writes the value as an output of a recipe: the format by the file's ending, or by its name `as_` ("map", "unreal",
        "mesh", ...) with its parameters. `with_`: values that belong to it, by name ("labels", "rivers"). Returns the files.
        Raises WriteError, InvalidArgument."""
        companions = {name: value._held for name, value in (with_ or {}).items()}
        files, notes = _core.save(self._held, os.fsencode(path), as_, params, companions, progress)
        say(notes)
        return files

    def __reduce__(self):
        return _restore, (self._held.dump(),)

    def __repr__(self):
        return f"<seamount.{type(self).__name__}>"


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
                raise _invalid("frame", "is missing: give a Frame, or cell_m")
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
        where = f", {frame.crs[:40]}" if frame.crs else ""
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


class Image(Value):
    """A picture: rows x columns x 3 of uint8, sRGB."""

    __slots__ = ()
    kind = "image"

    def __init__(self, array):
        array = numpy.ascontiguousarray(array, dtype=numpy.uint8)
        if array.ndim != 3:
            raise _invalid("array", "has no rows, columns and colours")
        self._held = _core.image(array, array.shape[1], array.shape[0])

    @property
    def array(self):
        return numpy.asarray(self._held.bands()[0])

    def __array__(self, dtype=None, copy=None):
        return _interop.asked_array(self.array, dtype, copy)

    def _repr_png_(self):
        return _pictures.encode(self.array)

    def __repr__(self):
        rows, columns, _ = self.array.shape
        return f"<seamount.Image {columns} x {rows}>"


class Features(Value):
    """Base of values that are shapes with properties, as GeoJSON has them."""

    __slots__ = ()

    @property
    def crs(self):
        """Coordinate system of the places: "EPSG:32604", WKT, or "" for local metres."""
        return _core.features(self._held)[1]

    @property
    def features(self):
        """A list of GeoJSON's features; places are metres in `crs`."""
        return _core.features(self._held)[0]

    @property
    def __geo_interface__(self):
        features, crs = _core.features(self._held)
        return _geo.collection(features, crs)

    def to_geodataframe(self):
        """A geopandas.GeoDataFrame with a row for each feature."""
        return _geo.to_geodataframe(*_core.features(self._held))

    def _repr_svg_(self):
        return _pictures.svg_of(self.features)

    def __len__(self):
        return len(self.features)


class Drawing(Features):
    """Areas, lines and points: coastlines, rivers, summits."""

    __slots__ = ()
    kind = "drawing"

    def __init__(self, features, crs=None):
        """Of GeoJSON, or whatever has a `__geo_interface__`: shapes of shapely, tables of geopandas. `crs`: their system; absent:
        what they say, else local metres. What is in degrees is brought to metres."""
        text, said = _geo.geojson_text(features)
        self._held, notes = _core.drawing(text, crs if crs is not None else said or "local")
        say(notes)


class Contours(Features):
    """Nested contours with their heights."""

    __slots__ = ()
    kind = "contours"


class Objects(Features):
    """Environmental objects with all that decides how they go on."""

    __slots__ = ()
    kind = "objects"

    @property
    def scene(self):
        """What surrounds them: catalogue, timeline, iteration, seed."""
        return _core.document(self._held)

    def table(self):
        """A column for each property, and x and y of each object's (first) place: NumPy arrays by name, as pandas.DataFrame takes
        them."""
        return _geo.table(self.features)


class Tin(Value):
    """A triangulated network. `nodes` (places), `triangles` (indices), and of each node `region`, `rank`, `bed_m` and
    `height_m`, empty where they are not known: NumPy arrays, not copied."""

    __slots__ = ()
    kind = "tin"
    nodes = property(lambda self: self._column("nodes"))
    triangles = property(lambda self: self._column("triangles"))
    region = property(lambda self: self._column("region"))
    rank = property(lambda self: self._column("rank"))
    bed_m = property(lambda self: self._column("bed_m"))
    height_m = property(lambda self: self._column("height_m"))

    def _column(self, name):
        return numpy.asarray(_core.network(self._held)[name])


class Things(Value):
    """Models of trees, corals, rocks, and where they stand."""

    __slots__ = ()
    kind = "things"

    def table(self):
        """A row for each thing: place (x, y), z_m, rotation (a quaternion x, y, z, w), scale, health, tint, shape, level as NumPy
        arrays, not copied; `shapes` lists the names of the models."""
        columns = _core.instances(self._held)
        return {name: numpy.asarray(column) if name != "shapes" else column for name, column in columns.items()}


class Catalogue(Value):
    """Classes of environmental objects and materials."""

    __slots__ = ()
    kind = "catalogue"

    def __init__(self, document):
        """Of a mapping as catalogues in JSON are. Raises RecipeError with all its defects."""
        self._held = _core.catalogue(document)

    @property
    def document(self):
        return _core.document(self._held)


class Report(Value):
    """Measured numbers and curves."""

    __slots__ = ()
    kind = "report"

    @property
    def document(self):
        """All of it as dicts and lists, as `report.json` holds it."""
        return _core.document(self._held)

    def _repr_html_(self):
        return _pictures.page_of(_core.page(self._held))


CLASSES = {cls.kind: cls for cls in (Terrain, Labels, Field, Current, Image, Drawing, Tin, Contours, Report, Things,
                                     Catalogue, Objects)}


def wrap(held):
    return CLASSES[held.kind]._of(held)


def read(path, kind="terrain", *, frame=None):
    """A value of a kind from a file."""
    if kind not in CLASSES:
        raise _invalid("kind", f"there is no '{kind}', known are: {', '.join(CLASSES)}")
    return CLASSES[kind].read(path, frame=frame)


def _restore(state):
    return wrap(_core.load(state))


def _invalid(field, problem):
    error = _core.InvalidArgument(f"{field}: {problem}")
    error.field, error.diagnostics = field, []
    return error
