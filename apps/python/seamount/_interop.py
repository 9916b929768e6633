"""Arrays of NumPy, xarray and rasterio by their own conventions. None of the latter two is needed; what they are given is
theirs only if they are there."""

import numpy

from . import _core
from ._frame import Frame


def plain_array(array, dtype):
    """Two-dimensional, of the type, row after row; itself if it is so. Masked cells have no value."""
    if isinstance(array, numpy.ma.MaskedArray) and dtype.kind == "f":
        array = array.astype(dtype).filled(numpy.nan)
    array = numpy.asarray(array)
    if array.dtype.kind not in "fiub":
        raise TypeError(f"array: holds {array.dtype}, no numbers")
    if dtype.kind == "u" and array.dtype != dtype:
        if array.size and not (numpy.min(array) >= 0 and numpy.max(array) <= 255 and numpy.all(array == numpy.floor(array))):
            raise ValueError("array: labels are whole numbers from 0 to 4")
    array = numpy.require(array, dtype, ["C", "A"]) if array.ndim == 2 else array
    if array.ndim != 2 or array.size == 0:
        raise ValueError(f"array: has the shape {array.shape}, not rows and columns")
    return array


def asked_array(array, dtype, copy):
    """For __array__: NumPy 1 asks for a type, NumPy 2 for a copy too."""
    if dtype is not None and numpy.dtype(dtype) != array.dtype:
        if copy is False:
            raise ValueError("another type cannot be had without a copy")
        return array.astype(dtype)
    return array.copy() if copy else array


def to_xarray(raster):
    import xarray
    frame = raster.frame
    reference = {"GeoTransform": "{2!r} {0!r} {1!r} {5!r} {3!r} {4!r}".format(*frame.transform)}
    if frame.crs:
        reference.update(crs_wkt=frame.crs, spatial_ref=frame.crs)
    coordinates = {"y": ("y", frame.y, {"axis": "Y", "units": "m"}), "x": ("x", frame.x, {"axis": "X", "units": "m"}),
                   "spatial_ref": ((), 0, reference)}
    attributes = {"grid_mapping": "spatial_ref"}
    if raster.kind == "terrain":
        attributes.update(units="m", long_name="height above the sea")
    return xarray.DataArray(raster.array, coordinates, ("y", "x"), name=raster.kind, attrs=attributes)


def from_xarray(data):
    """(array, frame)."""
    data = data.squeeze(drop=True)
    if set(data.dims) != {"x", "y"}:
        raise ValueError(f"data: has the dimensions {tuple(data.dims)}, not x and y")
    x, y = numpy.asarray(data["x"], float), numpy.asarray(data["y"], float)
    array = numpy.asarray(data.transpose("y", "x"))
    if y.size > 1 and y[1] > y[0]:
        array, y = array[::-1], y[::-1]
    cells = numpy.concatenate([numpy.diff(x), -numpy.diff(y)])
    if cells.size == 0 or not numpy.allclose(cells, cells[0], rtol=1e-6) or cells[0] <= 0:
        raise ValueError("data: x and y are not evenly spaced by the same")
    cell = abs(x[-1] - x[0]) / (x.size - 1) if x.size > 1 else abs(y[0] - y[-1]) / (y.size - 1)
    return array, Frame(x.size, y.size, float(cell), float(x[0] - cell / 2), float(y[0] + cell / 2), _crs_of_xarray(data))


def _crs_of_xarray(data):
    reference = data.coords["spatial_ref"].attrs if "spatial_ref" in data.coords else {}
    return crs_text(reference.get("crs_wkt") or reference.get("spatial_ref") or data.attrs.get("crs"))


def crs_text(crs):
    """Of what pyproj, rasterio and geopandas call a system: its authority's code, else WKT."""
    if crs is None or isinstance(crs, str):
        return crs or ""
    code = crs.to_epsg() if hasattr(crs, "to_epsg") else None
    return f"EPSG:{code}" if code else crs.to_wkt()


def to_rasterio_profile(raster):
    transform = raster.transform
    try:
        from affine import Affine
        transform = Affine(*transform)
    except ImportError:
        pass
    return {"driver": "GTiff", "dtype": raster.dtype.name, "count": 1, "width": raster.frame.width,
            "height": raster.frame.height, "transform": transform, "crs": raster.crs or None,
            "nodata": float("nan") if raster.dtype.kind == "f" else None}


def from_rasterio(dataset, band):
    """(array, frame)."""
    array = dataset.read(band, masked=True)
    return array, Frame.from_transform(dataset.transform, dataset.width, dataset.height, crs_text(dataset.crs))
