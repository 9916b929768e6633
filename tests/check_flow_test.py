#!/usr/bin/env python3
"""tools/check_flow.py on worlds that were run in tiles: it finds them right, and what is made wrong in them."""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77
TOOL = pathlib.Path(__file__).resolve().parent.parent / "tools/check_flow.py"
# Islands and a plain between hills, which the sea reaches, and hollows in level ground, without a sea.
RECIPE = """{ "seamount": 1, "seed": 5, "domain": { "width_m": 12000, "height_m": 9300, "cell_m": 30 },
  "steps": [
    { "id": "rough", "op": "terrain.noise", "params": { "kind": "smooth", "wavelength_m": 3000, "base_m": 40 } },
    { "id": "level", "op": "terrain.noise", "params": { "height_m": 0, "base_m": 45 } },
    { "id": "plain", "op": "terrain.blend", "in": { "terrain": "rough", "with": "level" }, "params": { "mode": "%s" } },
    { "id": "flow", "op": "hydrology.flow", "params": { "sea": %s } } ],
  "outputs": [
    { "from": "flow.%s", "path": "water.tif" },
    { "from": "flow.direction", "path": "direction.tif" },
    { "from": "flow.terrain", "path": "surface.tif" } ] }"""


def check(folder, sea):
    command = [sys.executable, str(TOOL), "water.tif", "direction.tif", "surface.tif", "--block", "100"] + (["--sea", "0"] if sea else [])
    ran = subprocess.run(command, cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return ran.returncode, ran.stdout


def change(path, column, row, how):
    """A copy in which one cell is another one."""
    import rasterio
    with rasterio.open(path) as file:
        cells, profile = file.read(1), file.profile
    cells[row, column] = how(cells[row, column])
    with rasterio.open(path, "w", **profile) as file:
        file.write(cells, 1)


def run(seamount, folder, mode, sea, port):
    (folder / "world.json").write_text(RECIPE % (mode, "true" if sea else "false", port))
    environment = {**os.environ, "SEAMOUNT_CACHE": str(folder / "cache")}
    subprocess.run([seamount, "run", "world.json", "--tiles", "71", "--memory", "0.003", "--out", "right"], cwd=folder, env=environment, check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seamount", required=True)
    seamount = str(pathlib.Path(parser.parse_args().seamount).resolve())
    try:
        import rasterio  # noqa: F401
    except ImportError:
        print("python3-rasterio is missing")
        return SKIPPED
    with tempfile.TemporaryDirectory() as made:
        folder = pathlib.Path(made)
        for mode, sea, port in (("max", True, "cells"), ("min", False, "area")):
            run(seamount, folder, mode, sea, port)
            status, said = check(folder / "right", sea)
            assert status == 0 and "124000 cells, 124000 arrive" in said, said
            for name, how in (("water.tif", lambda z: z + 900), ("direction.tif", lambda b: (b + 135) % 360 if b >= 0 else 90),
                              ("surface.tif", lambda z: z - 30), ("direction.tif", lambda b: -1)):
                wrong = folder / "wrong"
                shutil.rmtree(wrong, ignore_errors=True)
                shutil.copytree(folder / "right", wrong)
                change(wrong / name, 200, 150, how)
                status, said = check(wrong, sea)
                assert status == 1 and "WRONG" in said, f"{name}: {said}"
    print("right where it is, wrong where it is not")
    return 0


if __name__ == "__main__":
    sys.exit(main())
