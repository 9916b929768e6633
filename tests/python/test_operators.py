"""Operators as functions: signatures, documents, errors, threads."""

import importlib
import inspect
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import seamount as sm
from seamount import _core

SCHEMA = _core.schema()
RESERVED = {"domain", "seed", "threads", "progress"}


def function(op):
    family, _, name = op["name"].partition(".")
    module = importlib.import_module("seamount." + family)
    return getattr(module, name + "_" if name == "import" else name)


@pytest.mark.parametrize("op", SCHEMA["operators"], ids=lambda op: op["name"])
def test_every_operator_is_a_function_that_describes_itself(op):
    call = function(op)
    signature = inspect.signature(call)
    named = set(signature.parameters)
    for param in op["params"]:
        assert param["name"].removesuffix("_") in {name.removesuffix("_") for name in named}
        assert param["help"].split(";")[0].split()[0] in call.__doc__
        if param["unit"]:
            assert f"[{param['unit']}" in call.__doc__
        if not op["in"] or param["name"] not in {port["name"] for port in op["in"]}:
            assert signature.parameters[param["name"]].default == param["default"]
    assert not RESERVED & {param["name"] for param in op["params"]} | RESERVED & {port["name"] for port in op["in"]}
    assert ("seed" in named) == op["stochastic"]
    assert call.__module__ == "seamount." + op["name"].partition(".")[0]
    assert call.__name__ in importlib.import_module(call.__module__).__all__
    assert op["summary"].split()[0] in call.__doc__


@pytest.mark.parametrize("op", SCHEMA["operators"], ids=lambda op: op["name"])
def test_numbers_out_of_range_are_refused_by_name(op):
    for param in op["params"]:
        if param["kind"] != "number" or "max" not in param or param["name"] in {port["name"] for port in op["in"]}:
            continue
        with pytest.raises(sm.InvalidArgument) as caught:
            function(op)(**{param["name"]: param["max"] + abs(param["max"]) + 1})
        assert caught.value.field == param["name"] and "outside" in str(caught.value)


def test_errors_know_the_field():
    for call, field in [(lambda: sm.terrain.noise(octaves=99), "octaves"), (lambda: sm.terrain.noise(octave=9), "octave"),
                        (lambda: sm.terrain.noise(octaves="9"), "octaves"), (lambda: sm.terrain.noise(gain=object()), "gain"),
                        (lambda: sm.island.build(widths={"beach_m": -1}), "widths.beach_m"),
                        (lambda: sm.island.build(summits=[{"height_m": 100}, {"height_m": -1}]), "summits[1].height_m"),
                        (lambda: sm.terrain.smooth(), "terrain")]:
        with pytest.raises(sm.InvalidArgument) as caught:
            call()
        assert caught.value.field == field and isinstance(caught.value, ValueError)
    with pytest.raises(sm.InvalidArgument) as caught:
        sm.terrain.noise(octaves=99, gain=7)
    assert sorted(row["pointer"] for row in caught.value.diagnostics) == ["/gain", "/octaves"]


def test_seeds_and_threads(hills):
    for call, field in [(lambda: sm.terrain.noise(seed=-1), "seed"), (lambda: sm.terrain.noise(seed=2**64), "seed"),
                        (lambda: sm.terrain.smooth(hills, threads=-2), "threads"),
                        (lambda: sm.terrain.smooth(hills, threads=5000), "threads")]:
        with pytest.raises(sm.InvalidArgument) as caught:
            call()
        assert caught.value.field == field
    with pytest.raises(TypeError, match="takes no seed"):
        sm.terrain.smooth(hills, seed=1)
    with pytest.raises(TypeError):
        sm.terrain.noise(seed=1.5)
    largest = sm.terrain.noise(domain=hills, seed=np.uint64(2**64 - 1))
    assert np.array_equal(largest.array, sm.terrain.noise(domain=hills, seed=2**64 - 1, threads=1).array)


def test_names_of_files_that_are_no_text(tmp_path, hills):
    path = os.fsencode(tmp_path) + b"/\xff hills.tif"
    hills.save(tmp_path / "hills.tif")
    os.rename(tmp_path / "hills.tif", path)
    assert np.array_equal(sm.terrain.import_(file=os.fsdecode(path)).array, hills.array)
    assert np.array_equal(sm.Terrain.read(os.fsdecode(path)).array, hills.array)


def test_wrong_kinds_and_sizes(hills):
    with pytest.raises(sm.InvalidArgument, match="is a field, not a terrain"):
        sm.terrain.smooth(sm.Field(hills.array, hills.frame))
    with pytest.raises(sm.Error):
        sm.terrain.blend(hills, sm.Terrain(hills.array[:, :50], cell_m=50))
    with pytest.raises(TypeError):
        sm.terrain.smooth(hills, hills, hills, hills)
    with pytest.raises(TypeError, match="twice"):
        sm.terrain.smooth(hills, terrain=hills)
    with pytest.raises(sm.IncompatibleInputs):
        sm.contour.extract()
    with pytest.raises(sm.IoError) as caught:
        sm.terrain.smooth("nothing/there.tif")
    assert caught.value.path == "nothing/there.tif" and isinstance(caught.value, OSError)


def test_the_same_bytes_as_the_command_line(tmp_path, frame):
    program = os.environ.get("SEAMOUNT_PROGRAM")
    if not program:
        pytest.skip("the program is not built")
    subprocess.run([program, "terrain.noise", "--out", tmp_path, "--domain", "4800x3200", "--cell", "50", "--seed", "5",
                    "--height_m", "300", "--no-cache"], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    theirs = sm.Terrain.read(tmp_path / "terrain.tif")
    assert np.array_equal(theirs.array, sm.terrain.noise(domain=frame, seed=5, height_m=300).array)


def test_one_name_for_an_input_and_a_parameter(frame):
    triangle = {"type": "Polygon", "coordinates": [[[-900, -900], [900, -900], [0, 900]]]}
    drawn = sm.island.build(domain=frame, outlines=sm.Drawing(triangle))
    polar = sm.island.build(domain=frame, outlines=[900])
    assert not np.array_equal(drawn.terrain.array, polar.terrain.array)


def test_domains(frame, hills):
    same = [sm.terrain.noise(domain=domain, seed=1, height_m=600).array for domain in
            (frame, hills, {"width_m": 4800, "height_m": 3200, "cell_m": 50})]
    assert all(np.array_equal(array, hills.array) for array in same)
    placed = sm.terrain.noise(domain=sm.Frame(10, 20, 5, 500000, 3100000, "EPSG:32627"))
    assert placed.crs == "EPSG:32627" and placed.bounds == (500000, 3099900, 500050, 3100000)


def test_progress(frame):
    seen = []
    sm.erosion.run(sm.terrain.noise(domain=sm.Frame(256, 256, 30)), progress=seen.append)
    assert seen == sorted(seen) and len(seen) <= 102 and seen[-1] == 1


def test_an_exception_of_the_progress_function_stops_the_work():
    def stop(fraction):
        if fraction > 0.1:
            raise LookupError("enough")

    hills = sm.terrain.noise(domain=sm.Frame(512, 512, 30))
    with pytest.raises(LookupError, match="enough"):
        sm.erosion.run(hills, progress=stop)


def test_interrupted():
    hills = sm.terrain.noise(domain=sm.Frame(1500, 1500, 10))
    threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
    begin = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        for _ in range(20):
            sm.erosion.run(hills)
    assert time.monotonic() - begin < 15
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert sm.terrain.smooth(hills).shape == hills.shape


def test_a_handler_of_the_users_own():
    heard = []
    before = signal.signal(signal.SIGINT, lambda *_: heard.append(True))
    try:
        hills = sm.terrain.noise(domain=sm.Frame(1500, 1500, 10))
        threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
        with pytest.raises(sm.Cancelled):
            for _ in range(20):
                sm.erosion.run(hills)
        assert heard
    finally:
        signal.signal(signal.SIGINT, before)


def test_operators_within_a_progress_function():
    small, made = sm.Frame(32, 32, 30), []
    sm.erosion.run(sm.terrain.noise(domain=sm.Frame(128, 128, 30)),
                   progress=lambda fraction: made.append(sm.terrain.noise(domain=small, seed=1)))
    assert len(made) > 1 and all(np.array_equal(one.array, made[0].array) for one in made)


def test_other_threads_run_meanwhile():
    """The interpreter's lock is not held: this thread counts while the work goes on, and two operators run at once."""
    done, made = threading.Event(), {}

    def work(seed):
        made[seed] = sm.terrain.noise(domain=sm.Frame(1500, 1500, 10), seed=seed, octaves=16, threads=1)
        done.set()

    threads = [threading.Thread(target=work, args=(seed,)) for seed in (1, 2)]
    for thread in threads:
        thread.start()
    count = 0
    while not done.is_set():
        count += 1
    for thread in threads:
        thread.join()
    assert count > 1000
    assert np.array_equal(made[2].array, sm.terrain.noise(domain=sm.Frame(1500, 1500, 10), seed=2, octaves=16).array)


def test_the_module_alone_brings_nothing_but_numpy():
    asked = "import sys, seamount; print({'xarray', 'rasterio', 'geopandas', 'pandas', 'affine'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", asked], text=True, check=True, stdout=subprocess.PIPE)
    assert done.stdout.strip() == "set()"
