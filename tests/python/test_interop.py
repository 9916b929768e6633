"""xarray, rasterio, geopandas, shapely by their own conventions."""

import json

import numpy as np
import pytest

import seamount as sm

UTM = sm.Frame(96, 64, 50, 500000, 3100000, "EPSG:32627")


@pytest.fixture
def placed():
    return sm.terrain.noise(domain=UTM, seed=4)


def test_xarray(placed):
    xarray = pytest.importorskip("xarray")
    data = placed.to_xarray()
    assert isinstance(data, xarray.DataArray) and np.shares_memory(data.values, placed.array)
    assert float(data.x[0]) == 500025 and float(data.y[0]) == 3099975 and data.attrs["units"] == "m"
    assert data.spatial_ref.attrs["crs_wkt"] == "EPSG:32627"
    back = sm.Terrain.from_xarray(data)
    assert back.frame == placed.frame and np.shares_memory(back.array, placed.array)
    part = sm.Terrain.from_xarray(data[10:30, 5:25])
    assert part.frame == sm.Frame(20, 20, 50, 500250, 3099500, "EPSG:32627")
    upwards = sm.Terrain.from_xarray(data.isel(y=slice(None, None, -1)))
    assert upwards.frame == placed.frame and np.array_equal(upwards.array, placed.array)
    assert np.array_equal(sm.terrain.smooth(data).array, sm.terrain.smooth(placed).array)
    with pytest.raises(ValueError, match="evenly"):
        sm.Terrain.from_xarray(data[:, [0, 1, 5]])
    with pytest.raises(ValueError, match="dimensions"):
        sm.Terrain.from_xarray(data.rename(x="lon"))


def test_rasterio(placed, tmp_path):
    rasterio = pytest.importorskip("rasterio")
    with rasterio.open(tmp_path / "theirs.tif", "w", **placed.to_rasterio_profile()) as file:
        file.write(placed.array, 1)
    ours = sm.Terrain.read(tmp_path / "theirs.tif")
    assert ours.frame == placed.frame and np.array_equal(ours.array, placed.array)
    placed.save(tmp_path / "ours.tif")
    with rasterio.open(tmp_path / "ours.tif") as file:
        assert tuple(file.transform)[:6] == tuple(placed.transform) and file.bounds == placed.bounds
        theirs = sm.Terrain.from_rasterio(file)
    assert theirs.frame == placed.frame and np.array_equal(theirs.array, placed.array)


def test_rasterio_masks(tmp_path):
    rasterio = pytest.importorskip("rasterio")
    flat = sm.Terrain(np.zeros((5, 6), np.float32), sm.Frame(6, 5, 50, 500000, 3100000, "EPSG:32627"))
    profile = {**flat.to_rasterio_profile(), "nodata": -9999}
    with rasterio.open(tmp_path / "holes.tif", "w", **profile) as file:
        array = np.ones((5, 6), np.float32)
        array[2, 3] = -9999
        file.write(array, 1)
    with rasterio.open(tmp_path / "holes.tif") as file:
        assert np.argwhere(np.isnan(sm.Terrain.from_rasterio(file).array)).tolist() == [[2, 3]]


def test_transforms():
    assert sm.Frame.from_transform(UTM.transform, 96, 64, "EPSG:32627") == UTM
    for wrong in ((50, 1, 0, 0, -50, 0), (50, 0, 0, 0, 50, 0), (50, 0, 0, 0, -40, 0)):
        with pytest.raises(ValueError, match="transform"):
            sm.Frame.from_transform(wrong, 4, 4)


def test_geopandas(placed):
    geopandas = pytest.importorskip("geopandas")
    outlines = sm.hydrology.flow(placed).catchments
    table = geopandas.GeoDataFrame.from_features(outlines, crs=outlines.crs)
    assert len(table) == len(outlines) and table.crs.to_epsg() == 32627
    assert outlines.to_geodataframe().equals(table)
    assert table.area.sum() == pytest.approx(sum(feature["properties"]["area_m2"] for feature in outlines.features), rel=0.01)
    back = sm.Drawing(table)
    assert back.crs == "EPSG:32627" and len(back) == len(outlines)
    degrees = sm.Drawing(table.to_crs(4326))
    assert degrees.crs and degrees.features[0]["geometry"]["type"] in ("Polygon", "MultiPolygon")
    mask = sm.terrain.mask(placed, drawing=table.iloc[:1], criteria=[{"tool": "area"}])
    assert 0 < mask.array.mean() < 1


def test_shapely():
    shapely = pytest.importorskip("shapely.geometry")
    drawing = sm.Drawing([shapely.Point(10, 20), shapely.LineString([(0, 0), (50, 60)]), shapely.box(0, 0, 100, 200)])
    kinds = sorted(feature["geometry"]["type"] for feature in drawing.features)
    assert kinds == ["LineString", "Point", "Polygon"] and drawing.crs == ""
    assert sum(shapely.shape(feature["geometry"]).area for feature in drawing.features) == 20000


def test_geojson_goes_there_and_back(placed):
    contours = sm.contour.extract(terrain=placed)
    text = json.dumps(contours.__geo_interface__)
    again = sm.Drawing(json.loads(text))
    assert again.crs == "EPSG:32627" and len(again) == len(contours)
    heights = [feature["properties"]["height_m"] for feature in contours.features]
    assert sorted(heights) == sorted(feature["properties"]["height_m"] for feature in again.features)
    for wrong in (7, [{"type": "Feature"}], {"type": "FeatureCollection", "features": []},
                  {"type": "Polygon", "coordinates": [[[0]]]}):
        with pytest.raises((sm.Error, TypeError, ValueError)):
            sm.Drawing(wrong)


def test_rings_turn_as_geojson_wants():
    ring = [[0, 0], [0, 90], [90, 90], [90, 0], [0, 0]]
    (feature,) = sm.Drawing({"type": "Polygon", "coordinates": [ring]}).features
    rings = feature["geometry"]["coordinates"]
    area = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(rings[0], rings[0][1:])) / 2
    assert area == 8100 and rings[0][0] == rings[0][-1]


def test_numpys_own_functions(placed):
    assert np.mean(placed) == pytest.approx(placed.array.mean()) and np.asarray(placed) is placed.array
    assert np.asarray(placed, dtype=float).dtype == float
    assert np.gradient(placed)[0].shape == placed.shape
