#!/usr/bin/env python3
"""Runs clang-tidy-14 over the sources of the library, as build/sanitize compiles them.

A source that passed is not looked at again until it, a header of ours that it includes, or .clang-tidy changes.
"""

import argparse
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCE = ROOT / "src"
PASSED = ROOT / "build/tidy"
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def reached(path, known, source=SOURCE):
    """Adds to `known` the path and every header below `source` that it includes, directly or not."""
    if path not in known and path.exists():
        known.add(path)
        for name in INCLUDE.findall(path.read_text()):
            reached(source / name, known, source)
    return known


def stamp(path):
    digest = hashlib.sha256((ROOT / ".clang-tidy").read_bytes())
    for file in sorted(reached(path, set())):
        digest.update(str(file.relative_to(ROOT)).encode() + b"\0" + file.read_bytes())
    return PASSED / digest.hexdigest()


def git(*arguments):
    done = subprocess.run(["git", *arguments], cwd=ROOT, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return done.stdout.split() if done.returncode == 0 else []


def compiled():
    """Sources that build/sanitize compiles: not those that need libtorch."""
    return {pathlib.Path(entry["file"]) for entry in json.loads((ROOT / "build/sanitize/compile_commands.json").read_text())}


def changed():
    """Sources that the last commit changed, and what is not committed; a header stands for its source."""
    names = git("diff", "--name-only", "HEAD~1", "--", "src") + git("ls-files", "-o", "--exclude-standard", "--", "src")
    return {(ROOT / name).with_suffix(".cpp") for name in names}


def passes(path):
    done = subprocess.run(["clang-tidy-14", "--quiet", "-p", "build/sanitize", str(path)], cwd=ROOT, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    if done.returncode:
        print(done.stdout, end="", flush=True)
        return False
    stamp(path).touch()
    return True


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--changed", action="store_true", help="only sources that differ from the commit before the last")
    only_changed = options.parse_args().changed
    sources = {path for path in SOURCE.rglob("*.cpp") if not path.stem.endswith("_test")} & compiled()
    if only_changed:
        sources &= changed()
    PASSED.mkdir(parents=True, exist_ok=True)
    waiting = [path for path in sorted(sources) if not stamp(path).exists()]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        failed = list(pool.map(passes, waiting)).count(False)
    print(f"{len(waiting)} of {len(sources)} sources looked at, {failed} with complaints")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
