"""Shapes as GeoJSON and as tables."""

import json

import numpy

from ._interop import crs_text


def collection(features, crs):
    """A FeatureCollection; `crs` as GeoJSON had it before RFC 7946, for those who still read it."""
    made = {"type": "FeatureCollection", "features": features}
    if crs:
        made["crs"] = {"type": "name", "properties": {"name": crs}}
    return made


def geojson_text(shapes):
    """(text, coordinate system or None) of GeoJSON or of something with a __geo_interface__."""
    crs = crs_text(getattr(shapes, "crs", None)) or None
    shape = getattr(shapes, "__geo_interface__", shapes)
    if isinstance(shape, (list, tuple)):
        shape = collection([_feature(one) for one in shape], None)
    if not hasattr(shape, "get"):
        raise TypeError(f"features: {type(shapes).__name__} is no GeoJSON and has no __geo_interface__")
    named = shape.get("crs") or {}
    crs = crs or named.get("properties", {}).get("name")
    shape = {name: value for name, value in shape.items() if name != "crs"}
    if shape.get("type") not in ("FeatureCollection", "Feature"):
        shape = _feature(shape)
    return json.dumps(shape, default=_plain), crs


def _feature(shape):
    shape = getattr(shape, "__geo_interface__", shape)
    return shape if shape.get("type") == "Feature" else {"type": "Feature", "properties": {}, "geometry": shape}


def _plain(value):
    """Numbers and arrays of NumPy."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"features: {type(value).__name__} has no place in GeoJSON")


def to_geodataframe(features, crs):
    import geopandas
    return geopandas.GeoDataFrame.from_features(features, crs=crs or None)


def table(features):
    """Columns of the features' properties, and their (first) places."""
    columns = {"x": [], "y": []}
    for feature in features:
        place = feature["geometry"]["coordinates"]
        while not isinstance(place, tuple):
            place = place[0]
        columns["x"].append(place[0])
        columns["y"].append(place[1])
        for name, value in feature["properties"].items():
            columns.setdefault(name, []).append(value)
    return {name: numpy.array(values) for name, values in columns.items()}
