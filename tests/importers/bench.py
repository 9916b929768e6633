"""What the checks of this folder share: a folder to work in, the program, and others that may be missing."""

import functools
import json
import os
import shutil
import subprocess


class Missing(Exception):
    """A program that a check needs is not installed."""


def needs(*programs):
    """Skips a check where one of the programs is not on the PATH."""

    def wrap(check):
        @functools.wraps(check)
        def checked(bench):
            for program in programs:
                if shutil.which(program) is None:
                    raise Missing(f"{program} is not installed")
            check(bench)

        checked.__module__ = check.__module__
        return checked

    return wrap


class Bench:
    """A folder for one check."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def path(self, name):
        return self.folder / name

    def run(self, *command, env=None, timeout=600):
        """What a program prints; it must succeed."""
        done = subprocess.run([str(word) for word in command], cwd=self.folder, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=timeout, env={**os.environ, "PWD": str(self.folder), **(env or {})}, check=False)
        assert done.returncode == 0, f"{' '.join(map(str, command))}: exit {done.returncode}\n{done.stdout[-4000:]}"
        return done.stdout

    def seamount(self, *words):
        return self.run(self.program, *words)

    def island(self, size=257, seed=7):
        """The file of a random island with its sea."""
        self.seamount("island.build", "--out", "island", "--size", size, "--seed", seed)
        return "island/terrain.tif"

    def blender(self, script, *words):
        """Runs Python in Blender without a window; what the script prints after 'RESULT ' as JSON is returned."""
        old_names = "import numpy\nif 'bool' not in vars(numpy): numpy.bool = bool  # Blender 3.4's glTF importer needs it\n"
        self.path("script.py").write_text(old_names + script)
        # A Python that this script runs in, of pyenv say, must not become Blender's.
        env = {"PATH": os.pathsep.join(p for p in os.environ["PATH"].split(os.pathsep) if "pyenv" not in p)}
        finds_numpy = "import importlib.util as u; print('RESULT' * bool(u.find_spec('numpy')))"
        if "RESULT" not in self.run("blender", "-b", "--python-expr", finds_numpy, env=env):
            raise Missing("numpy is not installed for Blender's Python")
        said = self.run("blender", "-b", "--factory-startup", "--python-exit-code", "1", "--python", "script.py", "--", *words,
                        env=env)
        return json.loads(next(line for line in said.splitlines() if line.startswith("RESULT "))[7:])

    def node_module(self, name):
        """An environment in which node finds a module, global or on NODE_PATH."""
        if shutil.which("node") is None:
            raise Missing("node is not installed")
        roots = [os.environ.get("NODE_PATH", "")]
        if shutil.which("npm") is not None:
            roots.append(self.run("npm", "root", "-g").strip())
        env = {"NODE_PATH": os.pathsep.join(root for root in roots if root)}
        found = subprocess.run(["node", "-e", f"require('{name}')"], env={**os.environ, **env}, capture_output=True, check=False)
        if found.returncode != 0:
            raise Missing(f"the node module {name} is not installed (npm install -g {name})")
        return env
