"""Height maps for Blender, and tiles: Blender displaces a grid by the steps of the guide, GDAL puts tiles together again."""

import json
import math
import pathlib
import re
import struct

from bench import needs

GUIDE = pathlib.Path(__file__).resolve().parent.parent.parent / "docs/guide/engines.md"
MOST_M = 0.06

# Runs inside Blender after the guide's script.
TELL = """
shape = ground.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
print("RESULT " + json.dumps([tuple(vertex.co) for vertex in shape.vertices]))
"""


def floats(rows):
    return struct.pack(f"<{len(rows) * len(rows[0])}f", *(z for row in rows for z in row))


def terrain(bench, name, columns, rows, cell):
    """Hills, basins below the sea and a slope: a file, and its rows from the north."""

    def height(x, y):
        hill = 900 * math.exp(-((x - 0.37 * columns) ** 2 + (y - 0.6 * rows) ** 2) / (0.02 * columns * rows))
        return hill - 500 + 40 * math.sin(0.5 * x + rows) * math.cos(0.37 * y) + 0.02 * cell * (x - y)

    cells = [[height(x, y) for x in range(columns)] for y in range(rows)]
    bench.path(name).write_bytes(floats(cells))
    bench.path(name + ".json").write_text(json.dumps({"width": columns, "height": rows, "cell_m": cell}))
    return cells


def between_samples(rows, column, row):
    column, row = min(max(column, 0), len(rows[0]) - 1), min(max(row, 0), len(rows) - 1)
    x, y = min(int(column), len(rows[0]) - 2), min(int(row), len(rows) - 2)
    fx, fy = column - x, row - y
    upper = rows[y][x] * (1 - fx) + rows[y][x + 1] * fx
    lower = rows[y + 1][x] * (1 - fx) + rows[y + 1][x + 1] * fx
    return upper * (1 - fy) + lower * fy


def blender(bench, script, *words):
    """What a script prints after RESULT when Blender runs it without a window."""
    bench.path("plane.py").write_text(script)
    how = ["-b", "--factory-startup", "--python-exit-code", "1", "--python", bench.path("plane.py")]
    said = bench.run("blender", *how, "--", *words)
    return json.loads(next(line for line in said.splitlines() if line.startswith("RESULT "))[7:])


@needs("blender")
def check_blender_displaces_by_the_steps_of_the_guide(bench):
    script = re.search(r"```python\n(.*?)```", GUIDE.read_text(), re.S).group(1) + TELL
    for columns, rows, cell in [(64, 64, 10), (150, 70, 30), (41, 97, 2.5)]:
        cells = terrain(bench, "in.r32", columns, rows, cell)
        bench.seamount("convert", "in.r32", "land.exr", "--as", "blender")
        vertices = blender(bench, script, bench.path("land.exr"))
        assert len(vertices) == (columns + 1) * (rows + 1)
        typed = json.loads(bench.path("land.exr.json").read_text())["import"]
        assert abs(max(x for x, _, _ in vertices) - float(typed["plane size X"]) / 2) < 0.001 * cell
        error = max(
            abs(z - between_samples(cells, x / cell + columns / 2 - 0.5, rows / 2 - y / cell - 0.5)) for x, y, z in vertices
        )
        assert error <= MOST_M, f"{columns} x {rows} of {cell} m: {error} m"


@needs("gdalbuildvrt", "gdal_translate")
def check_gdal_puts_tiles_together(bench):
    for columns, rows, size in [(140, 90, 33), (97, 65, 33), (50, 131, 64)]:
        cells = terrain(bench, "in.r32", columns, rows, 10)
        bench.seamount("convert", "in.r32", "t/tile.tif", "--as", "tiles", "--set", f"tile_size={size}")
        tiles = [f"t/{tile['file']}" for tile in json.loads(bench.path("t/tile_tiles.json").read_text())["tiles"]]
        bench.run("gdalbuildvrt", "-overwrite", "whole.vrt", *tiles)
        bench.run("gdal_translate", "-q", "-of", "ENVI", "whole.vrt", "whole.bin")
        assert bench.path("whole.bin").read_bytes() == floats(cells), f"{columns} x {rows} in {size}"
