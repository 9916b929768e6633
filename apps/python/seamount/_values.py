"""All kinds of values by name, and those that are neither rasters nor shapes."""

import numpy

from . import _core, _interop, _pictures
from ._rasters import Current, Field, Labels, Raster, Terrain
from ._shapes import Contours, Drawing, Features, Objects
from ._value import Value, invalid

__all__ = ["Catalogue", "Contours", "Current", "Drawing", "Features", "Field", "Image", "Labels", "Objects", "Raster",
           "Report", "Terrain", "Things", "Tin", "Value", "read"]


class Image(Value):
    """A picture: rows x columns x 3 of uint8, sRGB."""

    __slots__ = ()
    kind = "image"

    def __init__(self, array):
        array = numpy.ascontiguousarray(array, dtype=numpy.uint8)
        if array.ndim != 3:
            raise invalid("array", "has no rows, columns and colours")
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
        """A row for each thing: place (x, y), z_m, rotation (a quaternion x, y, z, w), scale, health, tint, shape, level as
        NumPy arrays, not copied; `shapes` lists the names of the models."""
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
        raise invalid("kind", f"there is no '{kind}', known are: {', '.join(CLASSES)}")
    return CLASSES[kind].read(path, frame=frame)
