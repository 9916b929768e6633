"""A parameter sweep: how much land is left while an island sinks, for three heights of its peak. sweep.csv has the numbers,
sweep.png the maps side by side. Only what follows from a parameter is computed again.

    python3 sweep.py
"""

import csv

import numpy as np

import seamount as sm

PEAKS_M = (300, 700, 1200)
SUBSIDENCES = (0.0, 0.3, 0.6, 0.9)


def main():
    recipe = sm.Recipe({"seed": 8, "domain": {"width_m": 8000, "height_m": 7000, "cell_m": 40}}, cache=False)
    recipe.add("isle", "island.build")
    recipe.add("reef", "island.coral", {name: f"isle.{name}" for name in ("terrain", "labels", "coordinate")})
    rows, maps = [], []
    for peak in PEAKS_M:
        recipe.set_params("isle", peak_m=peak)
        for subsidence in SUBSIDENCES:
            recipe.set_params("reef", subsidence=subsidence)
            terrain, labels = recipe.values(["reef.terrain", "reef.labels"])
            land_km2 = (terrain.array > 0).sum() * terrain.frame.cell_m**2 / 1e6
            lagoon_km2 = (labels.array == sm.Labels.regions.index("lagoon")).sum() * terrain.frame.cell_m**2 / 1e6
            rows.append((peak, subsidence, round(land_km2, 2), round(lagoon_km2, 2)))
            maps.append(sm.render.texture(terrain, labels=labels, size_px=400).array)
    with open("sweep.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(("peak_m", "subsidence", "land_km2", "lagoon_km2"))
        writer.writerows(rows)
    count = len(SUBSIDENCES)
    sm.Image(np.vstack([np.hstack(maps[i:i + count]) for i in range(0, len(maps), count)])).save("sweep.png")
    for row in rows:
        print("peak {:4d} m  sunk {:.1f}: land {:5.2f} km2, lagoon {:5.2f} km2".format(*row))


if __name__ == "__main__":
    main()
