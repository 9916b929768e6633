"""What values show, hold, and are written to."""

import logging

import numpy as np
import pytest

import seamount as sm


def size_of(png):
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    return int.from_bytes(png[16:20], "big"), int.from_bytes(png[20:24], "big")


@pytest.fixture(scope="module")
def isle():
    return sm.island.build(domain=sm.Frame(120, 90, 60), seed=5, peak_m=700)


def test_rasters_show_themselves(isle):
    assert size_of(isle.terrain._repr_png_())[0] == 960
    assert size_of(isle.labels._repr_png_()) == size_of(isle.coordinate._repr_png_()) == (120, 90)
    large = sm.Field(np.zeros((1300, 2600), np.float32), cell_m=1)
    assert max(size_of(large._repr_png_())) <= 640
    assert size_of(sm.Field(np.full((3, 3), np.nan), cell_m=1)._repr_png_()) == (3, 3)
    ones = np.ones((4, 5), np.float32)
    assert size_of(sm.Current(ones, ones, sm.Frame(5, 4, 1))._repr_png_()) == (5, 4)
    assert size_of(sm.render.relief(isle.terrain)._repr_png_())[0] > 100


def test_shapes_and_reports_show_themselves(isle):
    outlines = sm.island.outlines(isle.labels)
    assert outlines._repr_svg_().count("<path") == len(outlines) > 0
    assert sm.contour.extract(terrain=isle.terrain)._repr_svg_().startswith("<svg")
    assert "<iframe" in sm.hydrology.describe(isle.terrain).report._repr_html_()


def test_values_say_what_they_are(isle):
    assert repr(isle.terrain) == "<seamount.Terrain 120 x 90 cells of 60 m>"
    assert repr(sm.render.relief(isle.terrain)).startswith("<seamount.Image")
    assert isle._fields == ("terrain", "labels", "coordinate")


def test_a_network_is_arrays():
    tin = sm.contour.grow(outlines=[[[-900, -900], [900, -900], [0, 900]]], particles=500)
    assert tin.nodes.shape[1] == 2 and tin.triangles.shape[1] == 3 and tin.triangles.max() < len(tin.nodes)
    assert len(tin.rank) == len(tin.region) == len(tin.nodes) and len(tin.height_m) == 0
    assert len(sm.contour.heights(tin).height_m) == len(tin.nodes)


def test_objects_and_things_are_tables(isle):
    things = sm.ecosystem.scatter(isle.terrain, seed=1)
    table = things.table()
    count = len(table["z_m"])
    assert count > 10 and table["place"].shape == (count, 2) and table["rotation"].shape == (count, 4)
    assert np.allclose(np.linalg.norm(table["rotation"], axis=1), 1, atol=1e-5)
    assert table["shape"].max() < len(table["shapes"])
    west, south, east, north = isle.terrain.bounds
    assert ((table["place"] >= (west, south)) & (table["place"] <= (east, north))).all()


def test_catalogues_are_documents():
    catalogue = sm.Catalogue.read(sm.SHARE / "data/catalogues/coral_reef_island.json")
    again = sm.Catalogue(catalogue.document)
    assert again.document == catalogue.document
    with pytest.raises(sm.RecipeError):
        sm.Catalogue({"seamount_catalogue": 1, "classes": [{"name": "no name"}]})


def test_pictures_are_arrays(isle):
    image = sm.render.relief(isle.terrain)
    assert image.array.dtype == np.uint8 and image.array.shape[2] == 3
    assert np.array_equal(sm.Image(image.array).array, image.array)
    for wrong in (np.zeros((4, 4), np.uint8), np.zeros((4, 4, 2), np.uint8)):
        with pytest.raises(ValueError):
            sm.Image(wrong)


def test_files(isle, tmp_path):
    assert isle.terrain.save(tmp_path / "height.tif") == [str(tmp_path / "height.tif")]
    assert np.array_equal(sm.Terrain.read(tmp_path / "height.tif").array, isle.terrain.array)
    files = isle.terrain.save(tmp_path / "map.png", "map", with_={"labels": isle.labels}, width_px=300)
    assert size_of((tmp_path / "map.png").read_bytes())[0] == 300 and files == [str(tmp_path / "map.png")]
    assert isle.terrain.save(tmp_path / "island.glb", max_triangles=500)
    sm.island.outlines(isle.labels).save(tmp_path / "outlines.geojson")
    assert len(sm.Drawing.read(tmp_path / "outlines.geojson")) > 0
    assert sm.read(tmp_path / "height.tif", "field").kind == "field"


def test_what_cannot_be_written(isle, tmp_path):
    for call, field in [(lambda: isle.terrain.save(tmp_path / "x.doc"), "path"),
                        (lambda: isle.terrain.save(tmp_path / "x.png", "mapp"), "as"),
                        (lambda: isle.terrain.save(tmp_path / "x.glb", max_triangls=3), "max_triangls"),
                        (lambda: sm.read(tmp_path, "nothing"), "kind")]:
        with pytest.raises(sm.InvalidArgument) as caught:
            call()
        assert caught.value.field == field
    with pytest.raises(sm.Error):
        isle.terrain.save("/proc/nowhere/height.tif")
    with pytest.raises(sm.IoError):
        sm.Report.read(tmp_path / "r.json")
    (tmp_path / "torn.tif").write_bytes(b"II*\0 torn")
    with pytest.raises(sm.IoError) as caught:
        sm.Terrain.read(tmp_path / "torn.tif")
    assert caught.value.path.endswith("torn.tif")


def test_notes_are_logged(isle, caplog):
    with caplog.at_level(logging.WARNING, "seamount"):
        sm.hydrology.describe(isle.terrain)
    assert any("counts as sea" in record.message for record in caplog.records)
