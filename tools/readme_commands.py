#!/usr/bin/env python3
"""Runs what the documents tell people to type, and checks that the files they name exist.

Each ```sh block of README.md and docs/guide/*.md is run by bash -e, in order, in a fresh folder that looks like a checkout
whose ./run is the built program. What should not run here (cloning, the studio, ./test) stands in a ```bash block.
After its commands every file that the document links or names in `code` (recipes/x.json, out/x.png) must exist.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
SKIPPED = 77
BLOCK = re.compile(r"^```sh\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\((?!\w+:|#)([^)#\s]+)")
NAMED = re.compile(r"`((?:\.ci|apps|bench|data|docs|examples|models|out|packages|recipes|src|studio|tests|tools)/[\w./-]*)`")


def checkout(folder, program):
    """Fills `folder` with links to all that is in the repository, but for what is built or made."""
    for entry in ROOT.iterdir():
        if entry.name not in ("build", "out", "run", "test", ".git"):
            (folder / entry.name).symlink_to(entry)
    run = folder / "run"
    bench = program.parent.parent.parent / "bench/seamount_bench"
    run.write_text(f"""#!/bin/bash
[[ $1 == bench ]] && exec {bench} "${{@:2}}"
(($#)) || set -- run recipes/kauai.json --out out/kauai
exec {program} "$@"
""")
    run.chmod(0o755)


def problems(document, program):
    text = document.read_text()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        checkout(folder, program)
        for block in BLOCK.finditer(text):
            line = text.count("\n", 0, block.start()) + 2
            done = subprocess.run(["bash", "-ec", block[1]], cwd=folder, stdin=subprocess.DEVNULL, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=900,
                                  env={"PATH": "/usr/bin:/bin", "HOME": temporary, "LC_ALL": "C.UTF-8"})
            if done.returncode:
                yield f"{line}: exit code {done.returncode} from\n{block[1]}{done.stdout}"
        here = folder / document.relative_to(ROOT).parent
        for name in LINK.findall(text):
            if not (here / name).exists():
                yield f"links {name}, which does not exist"
        for name in NAMED.findall(text):
            if not (folder / name).exists():
                yield f"names {name}, which does not exist"


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--seamount", type=pathlib.Path, default=ROOT / "build/dev/apps/seamount/seamount")
    program = options.parse_args().seamount.resolve()
    if not (ROOT / "README.md").exists():
        return SKIPPED
    failed = 0
    for document in [ROOT / "README.md", *sorted((ROOT / "docs/guide").glob("*.md"))]:
        for problem in problems(document, program):
            failed += 1
            print(f"{document.relative_to(ROOT)}: {problem}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
