"""Every operator is called with values of the kinds that it takes, and returns those that it says."""

import numpy as np
import pytest

import seamount as sm
from test_operators import SCHEMA, function

NEEDS = {  # what an operator cannot do without, beside its inputs
    "terrain.import": {"file": "dem.tif"}, "terrain.join": {"files": ["dem.tif"]},
    "drawing.import": {"file": "areas.geojson"}, "contour.import": {"file": "contours.geojson"}, "contour.grow": {"particles": 400},
    "learned.sketch": {"rivers": [{"points": [[-1500, -900], [0, 200], [1200, 800]]}]},
    "ecosystem.field": {"of": "ground"}, "ecosystem.grow": {"iterations": 3},
}
TAKES = {"learned.island": ["labels"], "ecosystem.grow": ["catalogue"]}  # inputs that are optional alone


@pytest.fixture(scope="module")
def values(tmp_path_factory):
    """A value of each kind."""
    frame = sm.Frame(64, 48, 60)
    isle = sm.island.build(domain=frame, seed=2, peak_m=400)
    tin = sm.contour.heights(sm.contour.grow(outlines=[[[-900, -900], [900, -900], [0, 900]]], particles=400))
    catalogue = sm.Catalogue.read(sm.SHARE / "data/catalogues/coral_reef_island.json")
    grown = sm.ecosystem.grow(isle.terrain, catalogue, iterations=2)
    made = {"terrain": isle.terrain, "labels": isle.labels, "field": sm.Field(np.full(frame.shape, 0.5, np.float32), frame),
            "drawing": sm.island.outlines(isle.labels), "contours": sm.contour.extract(terrain=isle.terrain), "tin": tin,
            "catalogue": catalogue, "objects": grown.objects, "current": grown.current,
            "things": sm.ecosystem.scatter(isle.terrain), "image": sm.render.relief(isle.terrain)}
    folder = tmp_path_factory.mktemp("files")
    made["terrain"].save(folder / "dem.tif")
    made["drawing"].save(folder / "areas.geojson")
    made["contours"].save(folder / "contours.geojson")
    return folder, frame, made


@pytest.mark.parametrize("op", SCHEMA["operators"], ids=lambda op: op["name"])
def test_called(op, values, monkeypatch):
    folder, frame, made = values
    monkeypatch.chdir(folder)
    params = dict(NEEDS.get(op["name"], {}))
    for param in op["params"]:
        if param["name"] in ("width_px", "height_px", "size_px"):
            params[param["name"]] = 64
    ports = [port for port in op["in"] if port["required"]] or (op["in"][:1] if op["needs_one"] else [])
    ports += [port for port in op["in"] if port["name"] in TAKES.get(op["name"], [])]
    inputs = {port["name"] + ("_" if port["name"] == "with" else ""): made[port["kind"]] for port in ports}
    result = function(op)(**inputs, **params, domain=frame)
    results = result if len(op["out"]) > 1 else (result,)
    assert [one.kind for one in results] == [port["kind"] for port in op["out"]]
    for one in results:
        assert isinstance(one, sm.Value) and repr(one)
        if isinstance(one, sm.Raster):
            assert one.shape == np.shape(one.array)[-2:]
