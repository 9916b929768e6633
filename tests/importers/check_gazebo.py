"""Worlds for Gazebo, read by a reader of its own: XML, the picture's codes and the mesh's vertices give the terrain's heights."""

import json
import math
import pathlib
import random
import struct
import xml.etree.ElementTree as xml
import zlib

from bench import needs


def grey_png(data):
    """Rows of codes of a grey PNG of 8 or 16 bits, and the highest possible one."""
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height, bits, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            assert colour == 0 and not interlaced
        if kind == b"IDAT":
            packed += body
        at += 12 + size
    raw, step = zlib.decompress(packed), bits // 8
    stride, before, rows = width * step, bytes(width * step), []
    for y in range(height):
        filtered, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (line[i - step], before[i], before[i - step]) if i >= step else (0, before[i], 0)
            guess = left + up - corner
            nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            line[i] = (line[i] + (0, left, up, (left + up) // 2, nearest)[filtered]) & 255
        before = bytes(line)
        rows.append(struct.unpack(f">{width}{'H' if bits == 16 else 'B'}", before))
    return rows, 2**bits - 1


def between_samples(rows, column, row):
    x, y = min(max(int(column), 0), len(rows[0]) - 2), min(max(int(row), 0), len(rows) - 2)
    fx, fy = min(max(column - x, 0), 1), min(max(row - y, 0), 1)
    upper = rows[y][x] * (1 - fx) + rows[y][x + 1] * fx
    lower = rows[y + 1][x] * (1 - fx) + rows[y + 1][x + 1] * fx
    return upper * (1 - fy) + lower * fy


def terrain(bench, columns, rows, cell):
    cells = [
        [500 * math.exp(-((x - 0.4 * columns) ** 2 + (y - 0.3 * rows) ** 2) / (0.03 * columns * rows)) - 300 + 0.5 * x - 0.3 * y
         for x in range(columns)] for y in range(rows)
    ]  # fmt: skip
    bench.path("in.r32").write_bytes(struct.pack(f"<{columns * rows}f", *(z for row in cells for z in row)))
    bench.path("in.r32.json").write_text(json.dumps({"width": columns, "height": rows, "cell_m": cell}))
    return cells


def numbers(element, path):
    return [float(word) for word in element.find(path).text.split()]


def check_height_maps_hold_the_terrain(bench):
    for columns, rows, cell, size, bits in [(129, 129, 7.5, 129, 16), (129, 129, 7.5, 129, 8), (200, 140, 20, 129, 16)]:
        cells = terrain(bench, columns, rows, cell)
        bench.seamount("convert", "in.r32", "reef.sdf", "--set", f"size={size}", "--set", f"bits={bits}", "--set", "texture_px=64")
        world = xml.parse(bench.path("reef.sdf")).getroot().find("world")
        for shape in ("visual", "collision"):
            ground = world.find(f".//{shape}")
            size_m, pos = numbers(ground, ".//size"), numbers(ground, ".//pos")
            low = pos[2] + (numbers(ground, "pose")[2] if ground.find("pose") is not None else 0)
            codes, highest = grey_png(bench.path(ground.find(".//uri").text).read_bytes())
            assert len(codes) == len(codes[0]) == size and pos[:2] == [0, 0]
            shorter = (min(columns, rows) - 1) * cell
            assert abs(size_m[0] - shorter) < 0.001 and size_m[0] == size_m[1]
            # Interpolating a smooth surface between other samples is off by its curvature.
            most = size_m[2] / highest / 2 + (0.002 if size == columns else 2.0)
            chance = random.Random(size)
            for _ in range(2000):
                x, y = chance.uniform(-shorter / 2, shorter / 2), chance.uniform(-shorter / 2, shorter / 2)
                column, row = (x / size_m[0] + 0.5) * (size - 1), (0.5 - y / size_m[1]) * (size - 1)
                z = low + size_m[2] * between_samples(codes, column, row) / highest
                truth = between_samples(cells, x / cell + (columns - 1) / 2, (rows - 1) / 2 - y / cell)
                assert abs(z - truth) <= most, f"{shape} at {x}, {y}: {z} m, not {truth} m"


def check_meshes_hold_the_terrain(bench):
    cells = terrain(bench, 60, 40, 10)
    mesh = ["--set", "ground=mesh", "--set", "max_triangles=0", "--set", "texture_px=64"]
    bench.seamount("convert", "in.r32", "reef.world", *mesh)
    ground = xml.parse(bench.path("reef.world")).getroot().find(".//visual")
    roll = numbers(ground, "pose")[3]
    vertices = 0
    for line in bench.path(ground.find(".//uri").text).read_text().splitlines():
        if not line.startswith("v "):
            continue
        x, up, south = map(float, line.split()[1:4])
        y, z = up * math.cos(roll) - south * math.sin(roll), up * math.sin(roll) + south * math.cos(roll)
        assert abs(z - between_samples(cells, x / 10 + 29.5, 19.5 - y / 10)) < 0.01, (x, y, z)
        vertices += 1
    assert vertices >= 60 * 40


@needs("gz")
def check_gazebo_finds_no_fault(bench):
    terrain(bench, 65, 65, 10)
    bench.seamount("convert", "in.r32", "reef.sdf", "--set", "buoyancy=true", "--set", "texture_px=64")
    for name in ("reef.sdf", pathlib.Path("reef/model.sdf")):
        said = bench.run("gz", "sdf", "--check", bench.path(name))
        assert "Valid" in said and "rror" not in said, said
