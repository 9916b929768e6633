#!/usr/bin/env python3
"""Checks that what the build and the scripts use comes from packages/*.txt: a machine that has more hides what is missing.

Asked are ninja (sources and CMake files), the linker (libraries), the scripts (programs, Python modules) and the sources
(files that they open). dpkg knows the
package of each file; it must be one of those listed for the purpose, one that they depend on, or part of every Debian.
Nothing is asked of a build folder that is not there. Elsewhere than on Debian the check is skipped.
"""

import ast
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
INFO = pathlib.Path("/var/lib/dpkg/info")
CLONING = ["git", "ca-certificates"]
SYSTEM = ("/usr/", "/lib", "/bin/", "/opt/")
PATH = "/usr/bin:/bin:/usr/sbin:/sbin"
# What is built, with which preset, for which purpose. `run` is part of each.
TARGETS = [("dev", "apps/seamount/seamount", "run"), ("dev", "seamount_python", "python"), ("dev", "all", "test"), ("sanitize", "all", "test")]
LINKED = [("dev", "apps/seamount/seamount", "run"), ("dev", "recipe_tests", "test"), ("dev", "bench/seamount_bench", "test"),
          ("sanitize", "tests/fuzz/recipe_fuzz", "test")]
SCRIPTS = {
    "run": ["run", "tools/setup.sh"],
    "python": ["apps/python/seamount/*.py", "apps/python/wheel/*.py"],
    "studio": ["tools/page.sh"],
    "test": ["test", ".ci/run", "tools/*.sh", "tools/*.py", "tests/*.py", "tests/cli/*", "tests/python/*.py", "examples/python/*.py", "README.md", "docs/guide/*.md"],
}
BEFORE = r"then|do|else|if|while|until|exec|command|sudo|env|xargs|nice"  # a command follows them
COMMAND = re.compile(rf"(?:^|[|;&({{])(?:\s*(?:!|{BEFORE}|-\w+(?: (?:\d+|\$\(\w+\)))?|\w+=\S*)\s)*"
                     r"\s*([a-z][\w.+-]*)(?![\w.+=/(-])")


def output(*command, **options):
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, **options).stdout


class Debian:
    """What dpkg knows of this machine."""

    def __init__(self):
        self.owners, self.depends, self.providers, base = {}, {}, {}, []
        for listing in INFO.glob("*.list"):
            package = listing.stem.split(":")[0]
            for line in listing.read_text().splitlines():
                self.owners.setdefault(line, set()).add(package)
        form = "${Package}\t${Provides}\t${Pre-Depends}, ${Depends}\t${Essential}\t${Priority}\n"
        for line in output("dpkg-query", "-W", "-f", form).splitlines():
            package, provides, depends, essential, priority = line.split("\t")
            self.depends[package] = [self.names(either, "|") for either in depends.split(",") if either.strip()]
            for name in [package, *self.names(provides, ",")]:
                self.providers.setdefault(name, []).append(package)
            if essential == "yes" or priority == "required":
                base.append(package)
        self.base = self.closure(base + CLONING)

    @staticmethod
    def names(text, separator):
        return [re.split(r"[ :(]", part.strip())[0] for part in text.split(separator) if part.strip()]

    def closure(self, packages):
        """The packages and all that they depend on; of alternatives the first that is installed."""
        known, waiting = set(), list(packages)
        while waiting:
            name = waiting.pop()
            for package in [name] if name in self.depends else self.providers.get(name, []):
                if package not in known:
                    known.add(package)
                    waiting += [next((n for n in either if n in self.providers), either[0])
                                for either in self.depends[package]]
        return known

    def owner(self, path):
        for name in (path, os.path.realpath(path)):
            for spelt in (name, name.removeprefix("/usr"), "/usr" + name):
                if spelt in self.owners:
                    return self.owners[spelt]
        return set()


def listed(purpose):
    lines = (ROOT / "packages" / f"{purpose}.txt").read_text().split("\n")
    return [line for line in lines if line and not line.startswith("#")]


def built_from(preset, target):
    """The files outside of the checkout that the target's objects and, for a test's, the CMake files were read from."""
    folder = ROOT / "build" / preset
    inputs = set(output("ninja", "-t", "inputs", target, cwd=folder).splitlines())
    wanted = False
    for line in output("ninja", "-t", "deps", cwd=folder).splitlines():
        if line and not line.startswith(" "):
            wanted = line.split(":")[0] in inputs
        elif wanted:
            yield os.path.normpath(folder / line.strip())
    if target == "all":
        yield from (line.strip(" |") for line in output("ninja", "-t", "query", "build.ninja", cwd=folder).splitlines())


def linked_from(preset, target):
    """The libraries that the linker reads for a target, and the programs that make it."""
    folder = ROOT / "build" / preset
    link = output("ninja", "-t", "commands", "-s", target, cwd=folder).splitlines()[-1]
    command = re.search(r"&& (\S+ .*? -o )\S+( .*?) &&", link)
    yield shutil.which(command[1].split()[0], path=PATH)
    traced = subprocess.run(command[1] + "/dev/null" + command[2] + " -Wl,--trace", shell=True, cwd=folder, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout
    yield from (os.path.normpath(line.strip()) for line in traced.splitlines() if os.path.isabs(line) and os.path.exists(line))


def commands_of(text):
    """The words of a shell script that stand where a command's name does."""
    text = re.sub(r"(^|\s)#.*", r"\1", text, flags=re.MULTILINE).replace("\\\n", " ")
    text = re.sub(r"'[^']*'", "''", text)
    text = re.sub(r'"((?:[^"$\\]|\\.|\$(?!\()|\$\([^)]*\))*)"', lambda m: " ".join(re.findall(r"\$\([^)]*\)", m[1])) or '""',
                  text)
    return {word for line in text.splitlines() for word in COMMAND.findall(line)}


def shell_of(path):
    """The shell text in a script, a test of the command line or a document."""
    text = path.read_text()
    if path.suffix == ".test":
        return "\n".join(line[2:] for line in text.splitlines() if line.startswith("$ "))
    if path.suffix == ".md":
        return "\n".join(re.findall(r"^```sh\n(.*?)^```$", text, re.MULTILINE | re.DOTALL))
    return text


def python_of(text):
    """The programs that a Python script starts, and the files of the modules that it imports."""
    for program in re.findall(r"(?:run|check_output|Popen|output)\(\s*\[?\"([\w.+-]+)\"", text):
        yield shutil.which(program, path=PATH)
    for node in ast.walk(ast.parse(text)):
        names = [a.name for a in node.names] if isinstance(node, ast.Import) else (
            [node.module] if isinstance(node, ast.ImportFrom) and node.module else [])
        for name in names:
            found = importlib.util.find_spec(name.split(".")[0])
            yield found and found.origin


def scripts_use(patterns):
    for path in sorted({path for pattern in patterns for path in ROOT.glob(pattern) if path.is_file()}):
        if path.suffix == ".py":
            files = python_of(path.read_text())
        else:
            files = (shutil.which(word, path=PATH) for word in commands_of(shell_of(path)))
        yield from ((file, path.name) for file in files if file)


def named_in_sources():
    """Files of the system that the program opens by name: fonts."""
    for path in sorted((ROOT / "src").rglob("*.cpp")):
        if not path.stem.endswith("_test"):
            yield from ((file, path.name) for file in re.findall(r'"(/usr/[^"]+)"', path.read_text()))


def used():
    """(file, what uses it, purpose) for all that is used."""
    yield from ((file, by, "run") for file, by in named_in_sources())
    for preset, target, purpose in TARGETS:
        if (ROOT / "build" / preset / ".ninja_deps").exists():
            yield from ((file, f"{preset}: {target}", purpose) for file in built_from(preset, target))
    for preset, target, purpose in LINKED:
        if (ROOT / "build" / preset / target).exists():
            yield from ((file, f"{preset}: linking {target}", purpose) for file in linked_from(preset, target))
    for purpose, patterns in SCRIPTS.items():
        yield from ((file, by, purpose) for file, by in scripts_use(patterns))


def main():
    if not shutil.which("dpkg-query"):
        print("skipped: not Debian")
        return 0
    debian = Debian()
    allowed = {"run": debian.base | debian.closure(listed("run"))}
    allowed["python"] = allowed["run"] | debian.closure(listed("python"))
    allowed["studio"] = allowed["run"] | debian.closure(listed("studio"))
    allowed["test"] = allowed["python"] | allowed["studio"] | debian.closure(listed("test"))
    problems, seen = set(), set()
    for file, by, purpose in used():
        if not file.startswith(SYSTEM) or file.startswith("/usr/local/"):
            continue
        seen.add(file)
        owners = debian.owner(file)
        if not owners & allowed[purpose]:
            problems.add(f"packages/{purpose}.txt lacks {' or '.join(sorted(owners)) or 'the package'} of {file} ({by})")
    print("\n".join(sorted(problems)) or f"{len(seen)} files, each of a package that is listed or follows from one")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
