"""What grows in an ecosystem, as a table: objects.csv with a row for each, and what there is of each class.

    python3 ecosystem_table.py [ITERATIONS]
"""

import csv
import sys

import numpy as np

import seamount as sm


def main():
    iterations = int(sys.argv[1]) if len(sys.argv) > 1 else 12
    hills = sm.terrain.noise(domain=sm.Frame(160, 160, 20), height_m=1100, base_m=1250, seed=2)
    catalogue = sm.SHARE / "data/catalogues/alpine_forest.json"
    grown = sm.ecosystem.grow(hills, catalogue, iterations=iterations, seed=3)
    table = grown.objects.table()
    table["height_m"] = hills.array[hills.frame.index(table["x"], table["y"])]
    with open("objects.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(table)
        writer.writerows(zip(*table.values()))
    for name in np.unique(table["class"]):
        of = table["class"] == name
        fitness, height = table["fitness"][of].mean(), table["height_m"][of].mean()
        print(f"{name:<16} {of.sum():5d}  fitness {fitness:.2f}  at {height:6.1f} m on average")


if __name__ == "__main__":
    main()
