#!/usr/bin/env python3
"""Checks every #include of src/seamount against the layers (docs/adr/0004-layers.md); names file and line."""

import pathlib
import re
import sys

MAY_INCLUDE = {
    "base": "",
    "model": "base",
    "geom": "base model",
    "ops": "base model geom",
    "io": "base model",
    "recipe": "base model geom ops io",
    "train": "base model geom ops io",
    "server": "base model geom ops io recipe",
    "tiles": "base model geom ops io recipe",
}
# Libraries that only some folders may know, by the beginning of their headers' names.
ONLY_IN = {
    "tbb/": "base recipe",
    "thread>": "base server tiles/mpi",
    "mpi.h": "tiles/mpi",
    "httplib": "server",
    "nlohmann/": "io recipe server",
    "gdal": "io",
    "sqlite3": "io",
    "dnnl": "ops/learned",
    "oneapi/dnnl": "ops/learned",
    "torch/": "train",
}
# Folders with rooms: a room may use itself and those before it.
ROOMS = {
    "geom": "scalar grid polygon brush solve skeleton current tin mesh things contour water",
    "ops/contour": "move growth heights convert refine edit",
}
INCLUDE = re.compile(r'\s*#\s*include\s*([<"])([^>"]+[>"])')


def problem(file, quote, target):
    """Why `file` (a path below src/seamount) may not include `target`, or None."""
    module, family = file.parts[0], "/".join(file.parts[:2])
    if quote == "<":
        homes = next((homes for library, homes in ONLY_IN.items() if target.startswith(library)), None)
        return f"<{target} belongs to {homes}" if homes and not {module, family} & set(homes.split()) else None
    target = target[:-1]
    if not target.startswith("seamount/"):
        return f'"{target}": write the path from src/ on'
    other = pathlib.PurePath(target).relative_to("seamount")
    if other.parts[0] != module and other.parts[0] not in MAY_INCLUDE.get(module, "").split():
        return f"{module} may not include {other.parts[0]} ({target})"
    if file.stem.endswith("_test"):
        return None  # a test may take another family or room as its judge
    if module == other.parts[0] == "ops" and len(file.parts) > 2 and file.parts[1] != other.parts[1]:
        return f"{family} may not include another family ({target})"
    for house, rooms in ROOMS.items():
        depth, order = len(house.split("/")), rooms.split()
        if not all("/".join(path.parts[:depth]) == house and len(path.parts) > depth + 1 for path in (file, other)):
            continue
        here, there = file.parts[depth], other.parts[depth]
        unknown = [room for room in (here, there) if room not in order]
        if unknown:
            return f"{house}/{unknown[0]} is not a room of {house}: {rooms}"
        if order.index(there) > order.index(here):
            return f"{house}/{here} may not include {there}, which stands on it ({target})"
    return None


def own_header_problem(path, first):
    """Why the first include of a source is wrong, or None: its own header, which is thereby compiled alone."""
    header = path.with_suffix(".h")
    if path.suffix == ".cpp" and header.exists() and not first.endswith(f'/{header.name}"'):
        return f"include {header.name} first: so it is known to compile alone"
    return None


def main(root):
    source = pathlib.Path(root, "src/seamount")
    problems = 0
    for path in sorted(p for p in source.rglob("*") if p.suffix in (".h", ".cpp")):
        first = None
        for number, line in enumerate(path.read_text().splitlines(), 1):
            include = INCLUDE.match(line)
            if include and first is None:
                first = include[2]
                if why := own_header_problem(path, first):
                    print(f"{path.relative_to(root)}:{number}: {why}", file=sys.stderr)
                    problems += 1
            if include and (why := problem(path.relative_to(source), *include.groups())):
                print(f"{path.relative_to(root)}:{number}: {why}", file=sys.stderr)
                problems += 1
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent))
