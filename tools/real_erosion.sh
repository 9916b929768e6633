#!/usr/bin/env bash
# Pictures and numbers of docs/guide/real_erosion.md, from elevation models that are not part of the repository:
#   SEAMOUNT_DEM_DIR=FOLDER tools/real_erosion.sh OUT
# For each terrain below and 24 noises: OUT/NAME/SEED/*.png and reports; and the table of their distances.
set -euo pipefail
: "${SEAMOUNT_DEM_DIR:?names the folder of elevation models}"
dems=$(realpath "$SEAMOUNT_DEM_DIR")
out=$(realpath -m "${1:?the folder for the results}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
compare() { # NAME, the noise of the pictures, then the parameters that are its own
  local name=$1 pictured=$2
  shift 2
  for seed in {1..24}; do
    ./run run tools/real_erosion.json --set "steps.file.params.file=\"$dems/$name.tif\"" "$@" --seed "$seed" \
      --out "$out/$name/$seed" --no-cache >/dev/null 2>&1
  done
  python3 - "$out/$name" "$pictured" <<'TABLE'
import json, pathlib, sys
folder = pathlib.Path(sys.argv[1])
runs = sorted((path for path in folder.iterdir() if path.is_dir()), key=lambda path: int(path.name))
def distances(run, what):
    return {key: d["distance"] for key, d in json.loads((run / what).read_text())["descriptors"].items()}
noise, worn = ([distances(run, what) for run in runs] for what in ("noise.json", "eroded.json"))
pictured = int(sys.argv[2]) - 1
print(f"\n{folder.name}\n\n| descriptor | noise {sys.argv[2]} | eroded | mean of {len(runs)} noises | eroded | nearer in |\n|---|---|---|---|---|---|")
for key in noise[0]:
    pairs = [(a[key], b[key]) for a, b in zip(noise, worn)]
    means = [sum(pair[i] for pair in pairs) / len(pairs) for i in (0, 1)]
    print(f"| {key} | {pairs[pictured][0]:.3f} | {pairs[pictured][1]:.3f} | {means[0]:.3f} | {means[1]:.3f} | {sum(b < a for a, b in pairs)} |")
TABLE
}
compare sangabriel_bigtujunga_30m 1
compare himalaya_n27e086_1arcsec 2 --set steps.noise.params.height_m=2428 --set steps.noise.params.base_m=2418 \
  --set steps.worn.params.years=5000000 --set steps.worn.params.uplift_mm_yr=1.4 --set steps.worn.params.erodibility=1.7e-6 \
  --set steps.worn.params.hardness_variation=0.5 --set steps.worn.params.slopes.creep_m2_yr=0.4 \
  --set steps.worn.params.slopes.bedrock_angle_deg=36.5 --set steps.worn.params.rivers.fan_m=100
