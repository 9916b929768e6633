"""Arrays are views both ways: by address."""

import gc
import pickle
import sys

import numpy as np
import pytest

import seamount as sm


def address(array):
    return array.__array_interface__["data"][0]


def core_address(raster):
    """Where the library's own grid stands."""
    return address(np.asarray(raster._held.bands()[0]))


@pytest.mark.parametrize("cls, dtype", [(sm.Terrain, np.float32), (sm.Field, np.float32), (sm.Labels, np.uint8)])
@pytest.mark.parametrize("side", [1, 5, 1500])
def test_an_array_given_is_not_copied(cls, dtype, side):
    array = np.ones((side, side + 1), dtype)
    raster = cls(array, cell_m=10)
    assert raster.array is array
    assert core_address(raster) == address(array)
    array[0, 0] = 3
    assert np.asarray(raster)[0, 0] == 3


def test_a_read_only_array_is_not_copied_either():
    array = np.zeros((3, 4), np.float32)
    array.flags.writeable = False
    assert core_address(sm.Terrain(array, cell_m=1)) == address(array)


@pytest.mark.parametrize("array", [np.arange(12).reshape(3, 4), np.arange(12.0).reshape(3, 4),
                                   np.zeros((4, 3), np.float32).T, np.zeros((6, 8), np.float32)[::2, ::2],
                                   np.zeros((3, 4), bool), np.zeros((3, 4), ">f4"),
                                   np.frombuffer(bytes(49), np.uint8)[1:].view(np.float32).reshape(3, 4),
                                   np.zeros((3, 4), np.float32)[::-1]])
def test_another_type_or_order_is_copied_once(array):
    raster = sm.Terrain(array, cell_m=1)
    assert raster.array.dtype == np.float32 and raster.array.shape == (3, 4)
    assert core_address(raster) == address(raster.array) != address(array)
    assert np.array_equal(raster.array, array.astype(np.float32))


def test_results_are_views_that_keep_their_memory(frame):
    terrain = sm.terrain.noise(domain=frame)
    array = terrain.array
    assert array.dtype == np.float32 and array.shape == (64, 96) and array.flags.writeable and not array.flags.owndata
    assert address(array) == core_address(terrain)
    before = array.copy()
    del terrain
    gc.collect()
    others = [sm.terrain.noise(domain=frame, seed=i) for i in range(20)]
    assert np.array_equal(array, before) and others


def test_arrays_given_are_let_go():
    array = np.zeros((300, 300), np.float32)
    before = sys.getrefcount(array)
    terrain = sm.Terrain(array, cell_m=10)
    assert sys.getrefcount(array) > before
    smooth = sm.terrain.smooth(terrain)
    del terrain
    gc.collect()
    assert sys.getrefcount(array) == before and smooth.array.shape == array.shape


def test_a_result_goes_on_without_a_copy(hills):
    again = sm.Terrain(hills.array, hills.frame)
    assert core_address(again) == core_address(hills)
    assert np.array_equal(sm.terrain.smooth(again).array, sm.terrain.smooth(hills).array)


def test_what_is_written_to_a_result_is_what_the_next_operator_sees(hills):
    hills.array[:] = 7
    assert np.all(sm.terrain.smooth(hills).array == 7)


def test_an_array_lies_where_the_raster_before_it_does(hills):
    mask = np.zeros(hills.shape, np.float32)
    mask[:, :48] = 1
    made = sm.terrain.blend(hills, hills.replace(hills.array + 100), mask)
    assert np.allclose(made.array[:, 60:], hills.array[:, 60:]) and np.allclose(made.array[:, :40], hills.array[:, :40] + 100)


def test_an_array_without_a_place_is_refused():
    with pytest.raises(sm.InvalidArgument, match="cell_m") as caught:
        sm.terrain.smooth(np.zeros((4, 4), np.float32))
    assert caught.value.field == "terrain"


@pytest.mark.parametrize("wrong", [np.zeros(4), np.zeros((2, 2, 2)), np.zeros((0, 3)), np.array([["a"]]),
                                   np.zeros((2, 2), complex)])
def test_what_is_no_raster_is_refused(wrong):
    with pytest.raises((ValueError, TypeError), match="array"):
        sm.Terrain(wrong, cell_m=1)


def test_labels_are_regions():
    for wrong in (np.full((2, 2), 5, np.uint8), np.full((2, 2), -1), np.full((2, 2), 0.5)):
        with pytest.raises(ValueError):
            sm.Labels(wrong, cell_m=1)


def test_masked_cells_have_no_value():
    array = np.ma.masked_equal(np.arange(12.0).reshape(3, 4), 5.0)
    assert np.isnan(sm.Terrain(array, cell_m=1).array[1, 1])


def test_unknown_cells_are_filled_and_that_is_said(caplog):
    array = np.full((20, 20), 50, np.float32)
    array[5:8, 5:8] = np.nan
    assert np.allclose(sm.terrain.smooth(sm.Terrain(array, cell_m=10)).array, 50)
    assert "9 of 400 cells have no value" in caplog.text
    assert np.isnan(array[6, 6])


@pytest.mark.parametrize("wrong, field", [((0, 4, 1), "width"), ((4, 70000, 1), "height"), ((4, 4, 0), "cell_m"),
                                          ((4, 4, float("nan")), "cell_m"), ((4, 4, 1, float("inf")), "west_m"),
                                          ((65536, 65536, 1), "width"), ((4, 4, 1, 0, 0, "EPSG:4326"), "crs"),
                                          ((4, 4, 1, 0, 0, "nowhere"), "crs")])
def test_frames_that_no_raster_has(wrong, field):
    with pytest.raises(sm.InvalidArgument) as caught:
        sm.Frame(*wrong)
    assert caught.value.field == field


@pytest.mark.parametrize("wrong", [("a", 4, 1), (4.5, 4, 1), (4, 4, "x"), (4, 4, 1, None, "y")])
def test_frames_are_numbers(wrong):
    with pytest.raises((TypeError, ValueError)):
        sm.Frame(*wrong)


def test_cells_of_places(frame):
    rows, columns = frame.index(frame.x[None, :] + 0 * frame.y[:, None], frame.y[:, None] + 0 * frame.x[None, :])
    assert np.array_equal(rows, np.indices(frame.shape)[0]) and np.array_equal(columns, np.indices(frame.shape)[1])
    assert [int(i) for i in frame.index(1e9, -1e9)] == [frame.height - 1, frame.width - 1]


def test_current_has_two_arrays(frame):
    current = sm.Current(np.ones(frame.shape, np.float32), np.zeros(frame.shape, np.float32), frame)
    assert current.east.shape == frame.shape and current.array.shape == (2, *frame.shape)
    assert current.east.flags.writeable and current.replace(current.array).frame == frame


@pytest.mark.parametrize("make", [
    lambda t: t, lambda t: sm.island.build(domain=t.frame, seed=2).labels, lambda t: sm.contour.extract(terrain=t),
    lambda t: sm.render.relief(t), lambda t: sm.hydrology.describe(t, sea=False).report])
def test_values_are_pickled(make, hills):
    value = make(hills)
    again = pickle.loads(pickle.dumps(value))
    assert type(again) is type(value)
    for look in ("array", "frame", "features", "document"):
        if hasattr(value, look):
            assert np.array_equal(getattr(again, look), getattr(value, look)) if look == "array" else getattr(
                again, look) == getattr(value, look)


def test_results_and_operators_are_pickled(frame):
    isle = sm.island.build(domain=frame)
    again = pickle.loads(pickle.dumps(isle))
    assert type(again) is type(isle) and np.array_equal(again.labels.array, isle.labels.array)
    assert pickle.loads(pickle.dumps(sm.terrain.import_)) is sm.terrain.import_
    assert pickle.loads(pickle.dumps(frame)) == frame


def test_damaged_pickles_are_refused(hills):
    state = bytearray(hills._held.dump())
    state[len(state) // 2] ^= 1
    with pytest.raises(sm.InvalidArgument):
        type(hills)._of(__import__("seamount._core")._core.load(bytes(state)))
