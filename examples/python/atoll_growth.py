"""An atoll grows: an island sinks while its reef keeps up with the sea. atoll.png is an animation that browsers show.

    python3 atoll_growth.py [FRAMES]
"""

import struct
import sys
import zlib

import seamount as sm


def chunks(png):
    """(name, content) of the parts of a PNG."""
    place = 8
    while place < len(png):
        (length,) = struct.unpack(">I", png[place:place + 4])
        yield png[place + 4:place + 8], png[place + 8:place + 8 + length]
        place += length + 12


def animation(pngs, milliseconds):
    """Pictures of one size as an animated PNG."""

    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    (header,) = [content for name, content in chunks(pngs[0]) if name == b"IHDR"]
    parts, number = [chunk(b"IHDR", header), chunk(b"acTL", struct.pack(">II", len(pngs), 0))], 0
    for index, png in enumerate(pngs):
        shown = struct.pack(">IIHHBB", 0, 0, milliseconds, 1000, 0, 0)
        parts.append(chunk(b"fcTL", struct.pack(">I", number) + header[:8] + shown))
        number += 1
        pixels = b"".join(content for name, content in chunks(png) if name == b"IDAT")
        if index == 0:
            parts.append(chunk(b"IDAT", pixels))
        else:
            parts.append(chunk(b"fdAT", struct.pack(">I", number) + pixels))
            number += 1
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts) + chunk(b"IEND", b"")


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 12
    camera = {"x_m": -2600, "y_m": -7200, "height_m": 3300, "target_x_m": 0, "target_y_m": -300}  # the same for all
    isle = sm.island.build(domain=sm.Frame(400, 300, 40), seed=11, peak_m=800, relief=1.4)
    pictures = []
    for step in range(count):
        reef = sm.island.coral(*isle, subsidence=0.8 * step / (count - 1), swell_from_deg=120)
        picture = sm.render.perspective(reef.terrain, reef.labels, camera=camera, width_px=480, height_px=300)
        pictures.append(picture._repr_png_())
    with open("atoll.png", "wb") as file:
        file.write(animation(pictures, 400))
    print(f"atoll.png: {count} pictures")


if __name__ == "__main__":
    main()
