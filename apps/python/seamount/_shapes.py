"""Values that are shapes with properties."""

from . import _core, _geo, _pictures
from ._notes import say
from ._value import Value


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
        """Of GeoJSON, or whatever has a `__geo_interface__`: shapes of shapely, tables of geopandas. `crs`: their system;
        absent: what they say, else local metres. What is in degrees is brought to metres."""
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
        """A column for each property, and x and y of each object's (first) place: NumPy arrays by name, as
        pandas.DataFrame takes them."""
        return _geo.table(self.features)
