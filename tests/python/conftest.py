"""Tests of the package seamount: PYTHONPATH names the folder that it was built to."""

import pathlib

import pytest

import seamount as sm

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture
def frame():
    return sm.Frame(96, 64, 50)


@pytest.fixture
def hills(frame):
    return sm.terrain.noise(domain=frame, seed=1, height_m=600)


@pytest.fixture(scope="session", autouse=True)
def own_cache(tmp_path_factory):
    """Recipes with the ordinary cache keep their results out of the user's."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("SEAMOUNT_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield
