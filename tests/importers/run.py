#!/usr/bin/env python3
"""Reads what Seamount writes with other people's programs: part of `./test deep`, and run by hand.

Each module check_*.py of this folder holds functions check_*(bench) that make files with `bench.seamount(...)`, read them with
other programs and `assert` what must hold. A function decorated with @needs("blender") is skipped, with a line that says so,
where that program is not installed. Another importer is another such function; nothing else has to know it.

  tests/importers/run.py --seamount build/dev/apps/seamount/seamount [PART_OF_A_NAME...]
"""

import argparse
import importlib
import inspect
import pathlib
import sys
import tempfile
import time
import traceback

from bench import Bench, Missing

FOLDER = pathlib.Path(__file__).resolve().parent


def checks():
    for path in sorted(FOLDER.glob("check_*.py")):
        module = importlib.import_module(path.stem)
        for name, function in inspect.getmembers(module, inspect.isfunction):
            if name.startswith("check_") and function.__module__ == path.stem:
                yield f"{path.stem.removeprefix('check_')}.{name.removeprefix('check_')}", function


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seamount", type=pathlib.Path, required=True, help="the program")
    parser.add_argument("parts", nargs="*", help="only checks whose names hold one of these")
    args = parser.parse_args()
    passed = failed = skipped = 0
    for name, check in checks():
        if args.parts and not any(part in name for part in args.parts):
            continue
        start = time.monotonic()
        with tempfile.TemporaryDirectory() as folder:
            try:
                check(Bench(args.seamount.resolve(), pathlib.Path(folder)))
            except Missing as missing:
                print(f"skipped {name}: {missing}", flush=True)
                skipped += 1
            except Exception:  # whatever went wrong, the others are still to be told of
                print(f"FAILED  {name}\n{traceback.format_exc()}", flush=True)
                failed += 1
            else:
                print(f"passed  {name} ({time.monotonic() - start:.1f} s)", flush=True)
                passed += 1
    print(f"{passed} passed, {failed} failed, {skipped} skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
