#!/usr/bin/env python3
"""Writes rasters and coasts that something is wrong with into the current folder, byte by byte: no library would."""

import json
import pathlib
import struct
import zlib


def tiff(name, width, height, data=b"", tags=()):
    """A grey float32 GeoTIFF of one strip; `tags`: (tag, type, values) of doubles beside the usual ones."""
    extra = [(33550, (10.0, 10.0, 0.0)), (33922, (0.0, 0.0, 0.0, 500000.0, 7000000.0, 0.0))] if not tags else tags
    entries = [(256, 4, 1, width), (257, 4, 1, height), (258, 3, 1, 32), (259, 3, 1, 1), (262, 3, 1, 1),
               (273, 4, 1, 0), (277, 3, 1, 1), (278, 4, 1, height), (279, 4, 1, len(data)), (339, 3, 1, 3)]
    at = 8 + 2 + 12 * (len(entries) + len(extra)) + 4
    blob = b""
    for tag, values in extra:
        entries.append((tag, 12, len(values), at + len(blob)))
        blob += struct.pack(f"<{len(values)}d", *values)
    entries[5] = (273, 4, 1, at + len(blob))
    table = b"".join(struct.pack("<HHII", *entry) for entry in sorted(entries))
    pathlib.Path(name).write_bytes(b"II*\0" + struct.pack("<IH", 8, len(entries)) + table + bytes(4) + blob + data)


def png(name, width, height, rgb):
    """A colour PNG of one colour."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = (b"\0" + bytes(rgb) * width) * height
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    pathlib.Path(name).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows))
                                   + chunk(b"IEND", b""))


def npy(name, shape, data):
    head = f"{{'descr': '<f4', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    pathlib.Path(name).write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode() + data)


def coast(name, *rings):
    shape = {"type": "Polygon", "coordinates": rings}
    pathlib.Path(name).write_text(json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {"name": "isle"}, "geometry": shape}]}))


heights = struct.pack("<64f", *[float(i) for i in range(64)])
tiff("good.tif", 8, 8, heights)
pathlib.Path("truncated.tif").write_bytes(pathlib.Path("good.tif").read_bytes()[:-100])
pathlib.Path("header.tif").write_bytes(pathlib.Path("good.tif").read_bytes()[:40])
tiff("huge.tif", 1000000, 1000000)
tiff("nan.tif", 8, 8, struct.pack("<64f", *[float("nan")] * 64))
tiff("void.tif", 8, 8, heights[:100] + struct.pack("<f", float("nan")) + heights[104:])
turn = (7.0, 7.0, 0, 500000.0, 7.0, -7.0, 0, 7000000.0, 0, 0, 0, 0, 0, 0, 0, 1.0)
tiff("rotated.tif", 8, 8, heights, [(34264, turn)])
npy("huge.npy", (1000000, 1000000), b"")
npy("short.npy", (8, 8), heights[:100])
npy("nan.npy", (8, 8), struct.pack("<64f", *[float("inf")] * 64))
pathlib.Path("odd.r16").write_bytes(bytes(7))
pathlib.Path("oblong.r16").write_bytes(bytes(2 * 7 * 11))
pathlib.Path("empty.tif").write_bytes(b"")
pathlib.Path("text.png").write_text("not a picture\n")
png("grey.png", 16, 16, (128, 128, 128))
png("red.png", 16, 16, (255, 0, 0))
square = [[-159.6, 22.0], [-159.5, 22.0], [-159.5, 22.1], [-159.6, 22.1], [-159.6, 22.0]]
coast("good.geojson", square)
coast("bowtie.geojson", [square[0], square[2], square[1], square[3], square[0]])
coast("flat.geojson", [[-159.6, 22.0], [-159.5, 22.0], [-159.6, 22.0], [-159.6, 22.0]])
coast("empty.geojson")
pathlib.Path("none.geojson").write_text('{"type": "FeatureCollection", "features": []}')
pathlib.Path("truncated.geojson").write_bytes(pathlib.Path("good.geojson").read_bytes()[:-60])
