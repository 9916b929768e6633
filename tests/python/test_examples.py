"""The worked examples, run as programs in a folder of their own."""

import csv
import subprocess
import sys

import numpy as np
import pytest

import seamount as sm
from conftest import ROOT

EXAMPLES = ROOT / "examples/python"


def run(name, folder, *arguments):
    done = subprocess.run([sys.executable, "-B", EXAMPLES / name, *arguments], cwd=folder, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_data_set(tmp_path):
    assert "6 pairs of (5, 128, 128)" in run("dataset.py", tmp_path, "6")
    with np.load(tmp_path / "islands.npz") as data:
        assert data["regions"].shape == (6, 5, 128, 128) and np.all(data["regions"].sum(axis=1) == 1)
        assert np.isfinite(data["heights"]).all() and not np.array_equal(data["heights"][0], data["heights"][1])


def test_eroded_and_compared(tmp_path):
    assert "lower on average" in run("erode_dem.py", tmp_path)
    assert sm.Terrain.read(tmp_path / "worn.tif").shape == (200, 200)
    assert "<svg" in (tmp_path / "compared.html").read_text() and (tmp_path / "worn.png").exists()
    assert "lower on average" in run("erode_dem.py", tmp_path, tmp_path / "worn.tif", "1000")


def test_an_atoll_grows(tmp_path):
    run("atoll_growth.py", tmp_path, "3")
    content = (tmp_path / "atoll.png").read_bytes()
    assert content.count(b"fcTL") == 3 and content.count(b"fdAT") == 2
    image = pytest.importorskip("PIL.Image")
    with image.open(tmp_path / "atoll.png") as animation:
        assert animation.n_frames == 3
        frames = []
        for index in range(3):
            animation.seek(index)
            frames.append(np.array(animation.convert("RGB")))
    assert not np.array_equal(frames[0], frames[1]) and not np.array_equal(frames[1], frames[2])


def test_an_ecosystem_is_a_table(tmp_path):
    assert "conifer" in run("ecosystem_table.py", tmp_path, "3")
    with open(tmp_path / "objects.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert {row["class"] for row in rows} >= {"conifer", "brook"} and all(float(row["height_m"]) > 0 for row in rows)


def test_a_sweep(tmp_path):
    run("sweep.py", tmp_path)
    with open(tmp_path / "sweep.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 12
    for peak in {row["peak_m"] for row in rows}:
        land = [float(row["land_km2"]) for row in rows if row["peak_m"] == peak]
        assert land == sorted(land, reverse=True)
    assert (tmp_path / "sweep.png").exists()
