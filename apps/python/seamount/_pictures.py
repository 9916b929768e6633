"""What values show of themselves in a notebook."""

import html

import numpy

from . import _core

LARGEST = 640
WIDTH = 960
_NAMED = {"mountain": (255, 255, 0), "beach": (0, 255, 0), "lagoon": (0, 255, 255), "reef": (0, 0, 255),
          "abyss": (255, 0, 0)}
_RAMP = numpy.array([(30, 20, 70), (60, 80, 140), (40, 140, 140), (120, 195, 95), (250, 230, 60)], float)
_UNKNOWN = (235, 235, 235)


def encode(colours):
    """A PNG of rows x columns x 3 of uint8."""
    colours = numpy.ascontiguousarray(colours, dtype=numpy.uint8)
    return _core.png(colours, colours.shape[1], colours.shape[0])


def _thinned(array):
    step = -(-max(array.shape) // LARGEST)
    return array[::step, ::step], step


def png_of(raster):
    if raster.kind == "terrain":
        return _terrain_png(raster)
    if raster.kind == "labels":
        cells, _ = _thinned(raster.array)
        return encode(numpy.array([_NAMED[name] for name in raster.regions], numpy.uint8)[cells])
    cells = numpy.hypot(raster.east, raster.north) if raster.kind == "current" else raster.array
    return encode(ramp(_thinned(cells)[0]))


def ramp(cells):
    """Colours from the lowest to the highest number, grey where there is none."""
    known = numpy.isfinite(cells)
    low, high = (cells[known].min(), cells[known].max()) if known.any() else (0.0, 1.0)
    share = numpy.where(known, cells - low, 0) / (high - low if high > low else 1.0)
    place = share * (len(_RAMP) - 1)
    below = numpy.minimum(place.astype(int), len(_RAMP) - 2)
    part = (place - below)[..., None]
    colours = (1 - part) * _RAMP[below] + part * _RAMP[below + 1]
    colours[~known] = _UNKNOWN
    return colours.round()


def _terrain_png(terrain):
    """A map of at most LARGEST cells a side."""
    frame = terrain.frame
    cells, step = _thinned(terrain.array)
    place = (cells.shape[1], cells.shape[0], frame.cell_m * step, frame.west_m, frame.north_m, "")
    held = _core.raster("terrain", place, [numpy.ascontiguousarray(cells)])
    (image,), _ = _core.operator("render.map").call({"terrain": held}, {"width_px": WIDTH}, None, 0, 0, None)
    return encode(numpy.asarray(image.bands()[0]))


def svg_of(features):
    """Shapes in black on white, 480 wide."""
    shapes = [feature["geometry"] for feature in features]
    points = [place for shape in shapes for line in _lines(shape) for place in line]
    if not points:
        return '<svg xmlns="http://www.w3.org/2000/svg" width="480" height="60"/>'
    x, y = zip(*points)
    side = max(max(x) - min(x), max(y) - min(y), 1e-9)
    scale, left, top = 460 / side, min(x), max(y)
    marks = []
    for shape in shapes:
        lines = [" ".join(f"{10 + (px - left) * scale:.1f},{10 + (top - py) * scale:.1f}" for px, py in line)
                 for line in _lines(shape)]
        if shape["type"] == "Point":
            cx, cy = lines[0].split(",")
            marks.append(f'<circle cx="{cx}" cy="{cy}" r="2.5" fill="#205080"/>')
        elif shape["type"] == "LineString":
            marks.append(f'<polyline points="{lines[0]}" fill="none" stroke="#205080"/>')
        else:
            path = " ".join(f"M{line.replace(' ', ' L')} Z" for line in lines)
            marks.append(f'<path d="{path}" fill="#205080" fill-opacity="0.15" fill-rule="evenodd" stroke="#205080"/>')
    height = 20 + (max(y) - min(y)) * scale
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="480" height="{height:.0f}">'
            f'<rect width="100%" height="100%" fill="white"/>{"".join(marks)}</svg>')


def _lines(shape):
    places = shape["coordinates"]
    return {"Point": lambda: [[places]], "LineString": lambda: [places], "Polygon": lambda: places,
            "MultiPolygon": lambda: [ring for part in places for ring in part]}[shape["type"]]()


def page_of(page):
    """A page of its own within a notebook's."""
    return f'<iframe style="width:100%;height:640px;border:0" srcdoc="{html.escape(page)}"></iframe>'
