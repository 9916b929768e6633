"""Drawings in other programs."""

import struct
import zlib

from bench import needs


def ink(png):
    """The share of pixels of an 8-bit RGBA picture that are neither transparent nor white."""
    data, at, parts = png.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
        parts += body if kind == b"IDAT" else b""
        at += 12 + length
    assert (depth, colour) == (8, 6), "not RGBA of 8 bits"
    rows, stride, above, marked = zlib.decompress(parts), 4 * width, bytearray(4 * width), 0
    for y in range(height):
        kind, row = rows[y * (stride + 1)], bytearray(rows[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up = (row[i - 4] if i >= 4 else 0), above[i]
            corner = above[i - 4] if i >= 4 else 0
            near = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))[2]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, near)[kind]) & 255
        marked += sum(1 for i in range(0, stride, 4) if row[i + 3] > 60 and min(row[i:i + 3]) < 230)
        above = row
    return marked / (width * height)


@needs("rsvg-convert")
def check_svg_shows_its_lines(bench):
    terrain = bench.island(size=129)
    for name, words in {"contours": ("contour.extract", "--interval_m", 50), "rivers": ("hydrology.rivers",)}.items():
        bench.seamount(words[0], "--terrain", terrain, "--out", name, *words[1:])
        source = f"{name}/{name}." + ("gpkg" if name == "contours" else "geojson")
        bench.seamount("convert", source, f"{name}.svg")
        bench.run("rsvg-convert", "-w", 600, f"{name}.svg", "-o", f"{name}.png")
        share = ink(bench.path(f"{name}.png"))
        assert 0.001 < share < 0.5, f"{name}: {share:.2%} of the picture is marked"
