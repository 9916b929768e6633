#!/usr/bin/env python3
"""Installs the module from the checkout into a virtual environment by pip, without an index, and uses it there: no file of
the checkout is opened or mapped."""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import venv

ROOT = pathlib.Path(__file__).resolve().parents[2]
USE = """
import sys
opened = []
sys.addaudithook(lambda name, arguments: opened.append(str(arguments[0])) if name == "open" else None)
import seamount as sm
from seamount import _core
isle = sm.island.build(domain=sm.Frame(128, 128, 100), seed=1)
learned = sm.learned.island(isle.labels, domain=isle.terrain)
recipe = sm.Recipe.example("kauai", cache=False)
recipe.set("/domain/cell_m", 800)
terrain = recipe.value("reef")
assert terrain.array.max() > 100 and learned.array.max() > 0
places = [sm.__file__, _core.__file__, _core.model_file("island"), str(sm.SHARE), *opened]
mapped = [line.split()[-1] for line in open("/proc/self/maps") if "/" in line]
print("\\n".join(place for place in places + mapped if place.startswith(sys.argv[1] + "/")))
"""


def run(*command, **options):
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "SEAMOUNT_MODELS")}
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, env=environment, **options).stdout


def main():
    argparse.ArgumentParser(description=__doc__).parse_args()
    with tempfile.TemporaryDirectory() as folder:
        # NumPy is the system's: nothing is fetched.
        venv.create(folder, system_site_packages=True, symlinks=True)
        python = str(pathlib.Path(folder, "bin/python3"))
        run(sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--no-index", "--no-build-isolation",
            "--disable-pip-version-check", str(ROOT))
        strays = run(python, "-B", "-c", USE, str(ROOT), cwd=folder).strip()
        if strays:
            print("used of the checkout:\n" + strays)
            return 1
        run(sys.executable, "-m", "pip", "--python", python, "uninstall", "--quiet", "--yes", "seamount")
        left = list(pathlib.Path(folder).rglob("*seamount*"))
        if left:
            print(f"left behind: {left}")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
