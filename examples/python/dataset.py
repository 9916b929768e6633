"""A data set for a network as an iterator of arrays: label maps of random islands and their heights.

    python3 dataset.py [COUNT]
"""

import sys

import numpy as np

import seamount as sm


def pairs(count, side=128, cell_m=60, first_seed=0):
    """Yields (regions: 5 x side x side of 0 and 1, heights: side x side in kilometres), each pair of a seed of its own, made
    when it is asked for. Other processes make other seeds."""
    frame = sm.Frame(side, side, cell_m)
    for seed in range(first_seed, first_seed + count):
        random = np.random.default_rng(seed)
        isle = sm.island.build(domain=frame, seed=seed, peak_m=random.uniform(200, 1200),
                               irregularity=random.uniform(0.2, 0.6))
        reef = sm.island.coral(*isle, subsidence=random.uniform(0, 0.8))
        regions = np.eye(len(sm.Labels.regions), dtype=np.float32)[reef.labels.array].transpose(2, 0, 1)
        yield regions, reef.terrain.array / 1000


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 16
    regions, heights = map(np.stack, zip(*pairs(count)))
    np.savez_compressed("islands.npz", regions=regions, heights=heights)
    land = (heights > 0).mean(axis=(1, 2))
    print(f"{count} pairs of {regions.shape[1:]} and {heights.shape[1:]}; land {land.min():.0%} to {land.max():.0%}")


if __name__ == "__main__":
    main()
