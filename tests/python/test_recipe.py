"""Recipes: edits, what is out of date, runs."""

import json
import os
import signal
import subprocess
import threading

import numpy as np
import pytest

import seamount as sm


@pytest.fixture
def recipe():
    made = sm.Recipe({"domain": {"width_m": 6400, "height_m": 6400, "cell_m": 50}, "seed": 3}, cache=False)
    made.add("isle", "island.build", peak_m=500)
    made.add("reef", "island.coral", {name: f"isle.{name}" for name in ("terrain", "labels", "coordinate")}, subsidence=0.2)
    return made


def test_only_what_follows_from_an_edit_is_out_of_date(recipe):
    assert recipe.out_of_date == ["isle", "reef"]
    first = recipe.value("reef.terrain")
    assert recipe.out_of_date == [] and {step.standing for step in recipe.steps} == {"fresh"}
    recipe.set_params("reef", subsidence=0.6)
    assert recipe.out_of_date == ["reef"]
    second = recipe.value("reef")
    assert not np.array_equal(first.array, second.array)
    assert recipe.undo() and recipe.out_of_date == [] and np.array_equal(recipe.value("reef").array, first.array)
    assert recipe.redo() and np.array_equal(recipe.value("reef").array, second.array)
    assert not recipe.redo()


def test_results_are_kept_by_the_recipe_and_cannot_be_written_to(recipe):
    array = recipe.value("isle").array
    assert not array.flags.writeable
    with pytest.raises(ValueError):
        array[0, 0] = 1
    del recipe
    assert np.isfinite(array).all()


def test_the_same_as_calling_the_operators(recipe):
    isle = sm.island.build(peak_m=500, domain=recipe.domain, seed=9)
    recipe.set("/steps/isle/seed", 9)
    recipe.set("/steps/reef/seed", 0)
    assert np.array_equal(recipe.value("isle.terrain").array, isle.terrain.array)
    reef = sm.island.coral(*isle, subsidence=0.2)
    assert np.array_equal(recipe.value("reef.labels").array, reef.labels.array)


def test_a_wrong_edit_changes_nothing(recipe):
    before = recipe.text
    with pytest.raises(sm.RecipeError) as caught:
        recipe.set_params("reef", subsidence=4)
    assert caught.value.field == "/steps/1/params/subsidence" and "outside [0, 1]" in caught.value.diagnostics[0]["message"]
    for wrong in (lambda: recipe.set_params("reef", subsidense=0.1), lambda: recipe.edit({"do": "explode"}),
                  lambda: recipe.add("third", "island.nothing"), lambda: recipe.connect("reef", "terrain", "nobody.terrain"),
                  lambda: recipe.set("/steps/nobody/params/x", 1)):
        with pytest.raises(sm.Error):
            wrong()
    assert recipe.text == before


def test_several_edits_are_one(recipe):
    revision = recipe.revision
    recipe.edit({"do": "set", "pointer": "/seed", "value": 5},
                {"do": "set", "pointer": "/steps/isle/params/peak_m", "value": 700})
    assert recipe.revision == revision + 1 and recipe.get("/seed") == 5
    recipe.undo()
    assert recipe.get("/seed") == 3 and recipe.get("/steps/isle/params/peak_m") == 500
    assert recipe.get("/steps/no/where") is None


def test_bypass_rename_remove(recipe):
    recipe.add("soft", "terrain.smooth", {"terrain": "reef.terrain"})
    recipe.bypass("soft")
    assert np.array_equal(recipe.value("soft").array, recipe.value("reef").array)
    recipe.bypass("soft", False)
    recipe.rename("soft", "softer")
    assert [step.id for step in recipe.steps] == ["isle", "reef", "softer"]
    recipe.remove("reef")
    assert recipe.get("/steps/softer/in/terrain") == "isle.terrain"


def test_open_inputs(recipe):
    recipe.connect("reef", "labels", None)
    assert recipe.missing and recipe.steps[1].standing == "incomplete"
    with pytest.raises(sm.InvalidArgument, match="cannot run yet"):
        recipe.value("reef")
    assert recipe.value("isle").shape == (128, 128)
    with pytest.raises(ValueError, match="known are: isle, reef"):
        recipe.value("nobody")
    with pytest.raises(sm.InvalidArgument, match="no result"):
        recipe.value("isle.nothing")


def test_a_step_that_fails_says_why(recipe):
    recipe.add("file", "terrain.import", file="nothing/there.tif")
    with pytest.raises(sm.Error, match="there.tif"):
        recipe.value("file")
    assert recipe.steps[2].standing == "failed"


def test_coarse_and_progress(recipe):
    recipe.set("/domain/cell_m", 10)
    seen = []
    assert recipe.value("isle", coarse=True, progress=seen.append).shape == (256, 256)
    assert recipe.value("isle", progress=seen.append).shape == (640, 640) and seen[-1] == 1


def test_runs_as_the_program_does(recipe, tmp_path):
    recipe.output("reef.terrain", "height.tif")
    recipe.output("reef.terrain", "map.png", "map", width_px=200)
    seen = []
    run = recipe.run(tmp_path / "python", progress=seen.append)
    assert [output.format for output in run.outputs] == ["raster", "map"] and {"isle", "reef"} <= set(run.seconds)
    assert seen == sorted(seen) and all(os.path.exists(file) for file in run.files)
    recipe.save(tmp_path / "recipe.json")
    assert json.loads(recipe.text) == json.loads((tmp_path / "recipe.json").read_text()) == recipe.document
    program = os.environ.get("SEAMOUNT_PROGRAM")
    if program:
        subprocess.run([program, "run", tmp_path / "recipe.json", "--out", tmp_path / "program", "--no-cache"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        assert (tmp_path / "program/map.png").read_bytes() == (tmp_path / "python/map.png").read_bytes()
        assert np.array_equal(sm.Terrain.read(tmp_path / "program/height.tif").array, recipe.value("reef").array)


@pytest.mark.parametrize("ask", [lambda recipe, folder: recipe.value("worn"), lambda recipe, folder: recipe.run(folder)])
def test_interrupted(recipe, ask, tmp_path):
    recipe.set("/domain/cell_m", 4)
    recipe.add("worn", "erosion.run", {"terrain": "isle.terrain"}, years=2_000_000)
    recipe.output("worn.terrain", "worn.tif")
    threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT)).start()
    with pytest.raises(KeyboardInterrupt):
        ask(recipe, tmp_path)
        threading.Event().wait(5)  # for a machine that is too fast
    assert not (tmp_path / "worn.tif").exists()
    recipe.remove("worn")
    recipe.set("/domain/cell_m", 100)
    assert recipe.value("isle").shape == (64, 64)


def test_all_defects_with_their_places(tmp_path):
    step = '{"id": "a", "op": "terrain.noise", "params": {"octaves": 99, "gian": 1}}'
    text = '{\n  "seamount": 1,\n  "steps": [\n    ' + step + "\n  ]\n}"
    (tmp_path / "wrong.json").write_text(text)
    with pytest.raises(sm.RecipeError) as caught:
        sm.Recipe.load(tmp_path / "wrong.json")
    assert len(caught.value.diagnostics) == 2 and {row["line"] for row in caught.value.diagnostics} == {4}
    with pytest.raises(sm.IoError):
        sm.Recipe.load(tmp_path / "missing.json")
    with pytest.raises(sm.RecipeError):
        sm.Recipe("{ no json")


def test_every_example_is_read():
    assert {"kauai", "island", "reef/platform"} & set(sm.examples())
    for name in sm.examples():
        assert isinstance(sm.Recipe.example(name, cache=False).document, dict)
    with pytest.raises(ValueError, match="known are"):
        sm.Recipe.example("atlantis")


def test_threads_may_share_a_recipe(recipe):
    made = {}

    def ask(index):
        made[index] = recipe.value("reef" if index % 2 else "isle").array

    threads = [threading.Thread(target=ask, args=(index,)) for index in range(6)]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        assert len(recipe.steps) == 2
    assert len(made) == 6 and np.array_equal(made[1], made[5]) and np.array_equal(made[0], made[4])


def test_saved_elsewhere_its_files_are_found(tmp_path):
    recipe = sm.Recipe.example("kauai", cache=False)
    recipe.set("/domain/cell_m", 800)
    (tmp_path / "deep/er").mkdir(parents=True)
    recipe.save(tmp_path / "deep/er/kauai.json")
    again = sm.Recipe.load(tmp_path / "deep/er/kauai.json", cache=False)
    assert np.array_equal(again.value("isle").array, recipe.value("isle").array)


def test_a_cache_folder_is_shared(tmp_path, recipe):
    text = recipe.text
    first = sm.Recipe(text, cache=tmp_path).value("reef")
    again = sm.Recipe(text, cache=tmp_path)
    assert np.array_equal(again.value("reef").array, first.array) and any(step.cached for step in again.steps)
