"""An elevation model is eroded and compared with what it was.

    python3 erode_dem.py [DEM.tif [YEARS]]

Without a file hills are made and written as one.
"""

import sys

import numpy as np

import seamount as sm


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else "hills.tif"
    years = float(sys.argv[2]) if len(sys.argv) > 2 else 100_000
    if len(sys.argv) < 2:
        sm.terrain.noise(domain=sm.Frame(200, 200, 50), height_m=900, base_m=50, seed=4).save(path)
    before = sm.Terrain.read(path)
    worn = sm.erosion.run(before, years=years, progress=lambda share: print(f"\r{share:4.0%}", end="", file=sys.stderr))
    print(file=sys.stderr)
    after = worn.terrain
    change = after.replace(after.array - before.array)
    print(f"{before!r}: {np.nanmean(-change.array):.1f} m lower on average, at most {-np.nanmin(change.array):.0f} m deeper, "
          f"{np.nanmax(change.array):.0f} m higher")
    report = sm.hydrology.describe(after, before).report
    for descriptor in report.document["descriptors"].values():
        if descriptor.get("distance") is not None:
            print(f"  {descriptor['title']:<40} {descriptor['distance']:.3f} away from before")
    after.save("worn.tif")
    report.save("compared.html")
    sm.render.map(after, width_px=600).save("worn.png")


if __name__ == "__main__":
    main()
