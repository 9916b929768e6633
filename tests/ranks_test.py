#!/usr/bin/env python3
"""Several processes run one recipe in tiles together, started by mpirun: the same bytes as one, also where some are killed."""

import argparse
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
RECIPE = """{ "seamount": 1, "seed": 5, "domain": { "width_m": %d, "height_m": %d, "cell_m": 30 },
  "steps": [
    { "id": "land", "op": "terrain.noise", "params": { "wavelength_m": 6000, "base_m": -300 } },
    { "id": "steep", "op": "terrain.mask", "params": { "criteria": [{ "tool": "slope", "low_deg": 20, "scale_m": 90 }] } },
    { "id": "worn", "op": "terrain.smooth", "in": { "terrain": "land", "mask": "steep" }, "params": { "radius_m": 60 } },
    { "id": "filled", "op": "hydrology.fill", "params": { "min_sea_m2": 1e6, "min_lake_m2": 5e4 } },
    { "id": "flow", "op": "hydrology.flow", "params": { "min_sea_m2": 1e6 } } ],
  "outputs": [
    { "from": "worn.terrain", "path": "height.tif" },
    { "from": "filled.terrain", "path": "filled.tif" },
    { "from": "filled.lakes", "path": "lakes.geojson" },
    { "from": "flow.catchments", "path": "catchments.geojson" },
    { "from": "flow.area", "path": "water.tif" } ] }"""
FILES = ["height.tif", "filled.tif", "lakes.geojson", "catchments.geojson", "water.tif"]


class World:
    """A recipe, and how it is run: what fits into memory is so little that water goes over the borders of tiles."""

    def __init__(self, options, folder):
        self.options, self.folder, self.cells = options, folder, options.cells
        (folder / "world.json").write_text(RECIPE % (30 * self.cells, 27 * self.cells))
        self.memory = str(20 * self.cells * self.cells / 1e9)

    def command(self, ranks, tile, out):
        run = [self.options.seamount, "run", "world.json", "--tiles", str(tile), "--out", out]
        if tile < self.cells:
            run += ["--memory", self.memory]
        if ranks == 1:
            return run
        return ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", str(ranks), *run]

    def start(self, ranks, tile, out):
        environment = {**os.environ, "SEAMOUNT_CACHE": str(self.folder / "cache")}
        return subprocess.Popen(self.command(ranks, tile, out), cwd=self.folder, env=environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)

    def run(self, ranks, tile, out):
        running = self.start(ranks, tile, out)
        said = running.communicate()[0]
        assert running.returncode == 0, said
        return said

    def check(self, out, expected):
        for name in FILES:
            assert (self.folder / out / name).read_bytes() == (self.folder / expected / name).read_bytes(), f"{out}/{name}"
        left = list((self.folder / "cache" / "tiles").iterdir())
        assert not left, f"{out}: a run that has ended leaves {left[0].name}"


def seamounts_below(parent):
    """Process numbers of the ranks that an mpirun has started."""
    found = []
    for status in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            name, rest = status.read_text().rsplit(")", 1)
        except OSError:
            continue
        if name.endswith("(seamount") and int(rest.split()[1]) == parent:
            found.append(int(status.parent.name))
    return sorted(found)


def kill_one(world, tile, out, seconds, victim):
    """Starts two ranks and kills one after a while. False: they had ended by then."""
    running = world.start(2, tile, out)
    time.sleep(seconds)
    ranks = seamounts_below(running.pid)
    if running.poll() is None and ranks:
        os.kill(ranks[victim % len(ranks)], signal.SIGKILL)
    said = running.communicate()[0]
    if running.returncode == 0:
        return False
    assert "mistake" not in said, said
    return True


def check_bytes(world):
    world.run(1, world.cells, "whole")
    for ranks, tile in [(1, world.options.tiles[0]), (2, world.options.tiles[0]), (2, world.options.tiles[1])]:
        out = f"{ranks}_{tile}"
        started = time.monotonic()
        world.run(ranks, tile, out)
        world.check(out, "whole")
        print(f"{ranks} ranks, tiles of {tile}: the same bytes, {time.monotonic() - started:.1f} s", flush=True)


def check_kills(world):
    """Killed again and again at growing times, the work goes on, and ends with the same bytes."""
    tile = world.options.tiles[0]
    started = time.monotonic()
    world.run(2, tile, "killed")
    whole = time.monotonic() - started
    for k in range(world.options.kills):
        shutil.rmtree(world.folder / "killed", ignore_errors=True)
        while not kill_one(world, tile, "killed", whole * (k + 1) / (world.options.kills + 1), k):
            world.check("killed", "whole")
            whole *= 0.8  # it was slower then, or goes on from what the last one has made
        if k % 2 == 0:  # else the next one goes on from what both have made
            world.run(1 if k % 4 == 0 else 2, tile, "killed")
            world.check("killed", "whole")
    world.run(2, tile, "killed")
    world.check("killed", "whole")
    print(f"{world.options.kills} times a rank was killed, lastly of a run of {whole:.1f} s: the same bytes", flush=True)


def check_two_runs(world):
    """Two runs that share their tiles at once."""
    tile = world.options.tiles[0]
    runs = [world.start(1, tile, out) for out in ("left", "right")]
    for running in runs:
        said = running.communicate()[0]
        assert running.returncode == 0, said
    for out in ("left", "right"):
        world.check(out, "whole")
    print("two runs at once: the same bytes", flush=True)


def check_errors(world):
    def says(arguments, text):
        command = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2", world.options.seamount, "run", *arguments]
        ran = subprocess.run(command, cwd=world.folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        assert ran.returncode == 2 and ran.stdout.count(text) == 1, ran.stdout

    says(["world.json"], "seamount: --tiles: is needed where several ranks run one recipe")
    says(["nothing.json", "--tiles", "512"], "seamount: nothing.json: no such file")
    region = RECIPE.replace('"tool": "slope", "low_deg": 20, "scale_m": 90', '"tool": "region"')
    (world.folder / "wrong.json").write_text(region % (30000, 30000))
    says(["wrong.json", "--tiles", "512", "--no-cache"], "of row 1 (columns ")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seamount", required=True)
    parser.add_argument("--cells", type=int, default=1100)
    parser.add_argument("--tiles", type=int, nargs=2, default=[512, 1000])
    parser.add_argument("--kills", type=int, default=3)
    options = parser.parse_args()
    options.seamount = str(pathlib.Path(options.seamount).resolve())
    if not shutil.which("mpirun") or not (pathlib.Path(options.seamount).parent / "seamount_ranks.so").exists():
        print("skipped: no mpirun here, or built without MPI")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        world = World(options, pathlib.Path(folder))
        check_bytes(world)
        check_errors(world)
        check_two_runs(world)
        check_kills(world)
    return 0


if __name__ == "__main__":
    sys.exit(main())
