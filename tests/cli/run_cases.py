#!/usr/bin/env python3
"""Runs command-line cases: text files of commands with what they are expected to say.

    # what this case shows
    <<< island.json
    { "seamount": 1 }
    >>>
    $ seamount run island.json
    the expected stdout; [..] stands for anything in a line, a line ... for any number of lines
    ! an expected stderr line
    ? 2

`?` is the exit code, 0 where absent. An expected line that starts with one of $ ! ? # < \\ gets a \\ before it. Every case
has a fresh folder of its own; `seamount` is in PATH and $ROOT is the repository. Those two folders are written $HERE and
$ROOT in what is compared. --update writes what the commands really said into the case; read the difference before you
commit it.
"""

import argparse
import difflib
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
MARKS = ("$ ", "! ", "!", "? ", "#", "<<< ", "\\")


class Text(str):
    """A comment or an empty line."""

    def render(self):
        return [self]


class File:
    """A file to create."""

    def __init__(self, name, lines):
        self.name, self.lines = name, lines

    def render(self):
        return [f"<<< {self.name}", *self.lines, ">>>"]


class Command:
    """A command and what it says."""

    def __init__(self, line, out=(), err=(), code=0):
        self.line, self.out, self.err, self.code = line, list(out), list(err), code

    def render(self):
        out = ["\\" + line if line.startswith(MARKS) else line for line in self.out]
        err = [f"! {line}".rstrip() for line in self.err]
        return [f"$ {self.line}", *out, *err, *([f"? {self.code}"] if self.code else [])]


def parse(text):
    blocks, command, lines = [], None, iter(text.splitlines())
    for line in lines:
        if line.startswith("<<< "):
            blocks.append(File(line[4:], list(iter(lambda: next(lines, ">>>"), ">>>"))))
            command = None
        elif line.startswith("$ "):
            command = Command(line[2:])
            blocks.append(command)
        elif command is None or line.startswith("#"):
            if line and not line.startswith("#"):
                raise SystemExit(f"'{line}' stands before any command")
            blocks.append(Text(line))
            command = None
        elif line == "!" or line.startswith("! "):
            command.err.append(line[2:])
        elif line.startswith("? "):
            command.code, command = int(line[2:]), None
        else:
            command.out.append(line.removeprefix("\\"))
    # Empty lines at the end of what a command says only part it from what follows.
    parted = []
    for block in blocks:
        gap = 0
        while isinstance(block, Command) and block.out and not block.out[-1] and not block.err:
            block.out.pop()
            gap += 1
        parted += [block, *[Text("")] * gap]
    return parted


def pattern(line):
    return r"(?:.*\n)*" if line == "..." else re.escape(line).replace(re.escape("[..]"), ".*") + r"\n"


def settle(actual, expected):
    """The lines of `actual`, written with the wildcards of `expected` where they fit: equal to `expected` if all do."""
    if re.fullmatch("".join(map(pattern, expected)), "".join(line + "\n" for line in actual)):
        return expected
    loose = [line for line in expected if "[..]" in line]
    return [next((e for e in loose if re.fullmatch(pattern(e), line + "\n")), line) for line in actual]


def run(command, folder, environment):
    done = subprocess.run(["bash", "-c", command.line], cwd=folder, env=environment, stdin=subprocess.DEVNULL,
                          capture_output=True, timeout=600)

    def lines(output):
        text = output.decode(errors="replace").replace(str(folder), "$HERE").replace(str(ROOT), "$ROOT")
        return [line.rstrip() for line in text.rstrip().splitlines()]

    return Command(command.line, settle(lines(done.stdout), command.out), settle(lines(done.stderr), command.err),
                   done.returncode)


def replay(text, programs):
    """The text of a case as it would be if it expected what its commands really say."""
    rendered = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary).resolve()
        environment = {"PATH": f"{programs}:{os.environ['PATH']}", "ROOT": str(ROOT), "HOME": str(folder),
                       "LC_ALL": "C.UTF-8", "TZ": "UTC"}
        environment |= {name: os.environ[name] for name in os.environ if name.endswith("SAN_OPTIONS")}
        for block in parse(text):
            if isinstance(block, File):
                (folder / block.name).parent.mkdir(parents=True, exist_ok=True)
                (folder / block.name).write_text("".join(line + "\n" for line in block.lines))
            rendered += (run(block, folder, environment) if isinstance(block, Command) else block).render()
    return "".join(line + "\n" for line in rendered)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--seamount", type=pathlib.Path, default=ROOT / "build/dev/apps/seamount/seamount")
    options.add_argument("--update", action="store_true", help="rewrite the expectations")
    options.add_argument("cases", nargs="*", type=pathlib.Path, help="default: all")
    given = options.parse_args()
    failed = 0
    for case in given.cases or sorted(pathlib.Path(__file__).parent.glob("*.test")):
        expected = case.read_text()
        actual = replay(expected, given.seamount.resolve().parent)
        if given.update and actual != expected:
            case.write_text(actual)
            print(f"updated {case}")
        elif actual != expected:
            failed += 1
            sys.stdout.writelines(difflib.unified_diff(expected.splitlines(True), actual.splitlines(True),
                                                       f"{case} expects", f"{case} happened"))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
