#!/usr/bin/env bash
# Pictures and numbers of docs/guide/real_terrain.md, from elevation models that are not part of the repository:
#   SEAMOUNT_DEM_DIR=FOLDER tools/real_terrain.sh OUT [NAME...]
# For each FOLDER/NAME.tif: OUT/NAME/*.png, the reports of hydrology.describe, and the table of their distances.
set -euo pipefail
: "${SEAMOUNT_DEM_DIR:?names the folder of elevation models}"
dems=$(realpath "$SEAMOUNT_DEM_DIR")
out=$(realpath -m "${1:?the folder for the results}")
shift
(($#)) || set -- alps_n46e008_3arcsec
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for name in "$@"; do
  ./run run tools/real_terrain.json --set "steps.file.params.file=\"$dems/$name.tif\"" --out "$out/$name" --no-cache >/dev/null
  python3 - "$out/$name" <<'TABLE'
import json, pathlib, sys
folder = pathlib.Path(sys.argv[1])
ways = ["smooth", "interpolated", "stairs", "refined", "grown"]
reports = {way: json.loads((folder / f"{way}.json").read_text())["descriptors"] for way in ways}
print(f"\n{folder.name}: distance to the terrain\n")
print("| descriptor | " + " | ".join(ways) + " |\n|---|" + "---|" * len(ways))
for key, first in reports[ways[0]].items():
    own = [reports[way][key]["distance"] for way in ways]
    print(f"| {key} | " + " | ".join("-" if one is None else f"{one:.3f}" for one in own) + " |")
print("\nin numbers\n\n| measure | terrain | " + " | ".join(ways) + " |\n|---|---|" + "---|" * len(ways))
for key, measure in [("slope", "mean"), ("curvature", "deviation"), ("slope_area", "concavity"), ("strahler", "highest_order"), ("prominence", "peaks")]:
    both = [reports[way][key]["measures"][measure]["values"] for way in ways]
    print(f"| {key} {measure} | {both[0][1]:.4g} | " + " | ".join(f"{own:.4g}" for own, _ in both) + " |")
TABLE
done
