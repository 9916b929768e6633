"""Recipes: documents that are edited and run."""

import json
import os
import pathlib
import threading
import typing

from . import _core
from ._frame import _frame
from ._notes import say
from ._values import wrap

SHARE = pathlib.Path(__file__).parent / "share"
"""Folder of what comes along: recipes, data (catalogues of ecosystems, coastlines), models."""
_FIRST_OUTPUT = {op["name"]: op["out"][0]["name"] for op in _core.schema()["operators"]}


class Step(typing.NamedTuple):
    """How a step stands."""

    id: str
    op: str
    standing: str
    """fresh: its result is known; stale: it is out of date; failed, blocked, incomplete: `message` says why; bypassed."""
    seconds: float
    cached: bool
    message: str
    notes: typing.List[str]


class Output(typing.NamedTuple):
    """What was written."""

    path: str
    format: str
    seconds: float
    files: typing.List[str]
    notes: typing.List[str]


class Run(typing.NamedTuple):
    """What a run did: its outputs, and the seconds of each step by its id."""

    outputs: typing.List[Output]
    seconds: typing.Dict[str, float]

    @property
    def files(self):
        return [file for output in self.outputs for file in output.files]


def examples():
    """Names of the recipes that come along, for Recipe.example()."""
    folder = SHARE / "recipes"
    return sorted(str(path.relative_to(folder).with_suffix("")) for path in folder.rglob("*.json"))


class Recipe:
    """A recipe: steps that form a graph, and outputs. Only what follows from a change is computed again, and only when it
    is asked for. Members may be called from any thread."""

    def __init__(self, document=None, *, folder=".", file="recipe", threads=0, cache=True, memory_bytes=1 << 30,
                 coarse_cells=256):
        """`document`: text of a recipe, or a mapping as recipes are, in which steps and outputs may be left out; absent: one
        with neither. Relative names in it start at `folder`. `cache`: True for the folder that the command line uses, False for
        none, or a folder. Raises RecipeError with all defects."""
        bare = {"seamount": 1, "steps": [], "outputs": []}
        text = document if isinstance(document, str) else json.dumps({**bare, **(document or {})})
        cache = None if cache is True else "" if not cache else os.fsencode(cache)
        self._asking = threading.Lock()
        self._engine = _core.Recipe(text, file, os.fsencode(folder), threads, cache, memory_bytes, coarse_cells)

    @classmethod
    def load(cls, path, **options):
        """Of a file."""
        path = pathlib.Path(path)
        try:
            text = path.read_text(encoding="utf-8")
        except (OSError, UnicodeDecodeError) as problem:
            error = _core.IoError(f"{path}: cannot be read: {problem}")
            error.path = str(path)
            raise error from problem
        return cls(text, folder=path.parent, file=str(path), **options)

    @classmethod
    def example(cls, name, **options):
        """One of examples()."""
        if name not in examples():
            raise ValueError(f"there is no example '{name}', known are: {', '.join(examples())}")
        return cls.load(SHARE / "recipes" / (name + ".json"), **options)

    # The document.

    @property
    def document(self):
        """All of it as dicts and lists: a copy."""
        return self._engine.json()

    @property
    def text(self):
        """The document as `seamount run` reads it."""
        return self._engine.text()

    @property
    def domain(self):
        return _frame(self._engine.domain())

    def save(self, path):
        """Writes the document to a file, whole or not at all. In another folder names of files lead from there."""
        self._engine.save(os.fsencode(os.path.abspath(path)))

    def get(self, place):
        """What stands at a place of the document: "/steps/reef/params/subsidence". None: nothing, such as a default."""
        found = self.document
        for part in place.strip("/").split("/"):
            if isinstance(found, list):
                ids = [item.get("id") if isinstance(item, dict) else None for item in found]
                index = ids.index(part) if part in ids else int(part) if part.isdigit() else len(found)
                found = found[index] if index < len(found) else None
            else:
                found = found.get(part) if found is not None else None
        return found

    # Edits. Each is refused with all that would be wrong after it, and then nothing has changed.

    def edit(self, *edits, gesture="", label=""):
        """Edits as the studio has them: {"do": "set", "pointer": ..., "value": ...}, insert, remove, move, rename,
        remove_step; all of them or none. Those of one `gesture` are undone as one. True: something has changed."""
        return self._engine.edit(list(edits), gesture, label)

    def set(self, place, value):
        """Gives a place a value: "/steps/reef/params/subsidence", "/seed", "/domain/cell_m"."""
        return self.edit({"do": "set", "pointer": place, "value": value})

    def unset(self, place):
        """Takes a member out, so that it has its default again."""
        return self.edit({"do": "set", "pointer": place})

    def set_params(self, step, **params):
        """Parameters of a step, as one edit."""
        return self.edit(*({"do": "set", "pointer": f"/steps/{step}/params/{name}", "value": value}
                           for name, value in params.items()))

    def add(self, step, op, in_=None, at=None, **params):
        """A step more: its id, its operator, where its inputs come from ({"terrain": "isle.terrain"}, {"terrain":
        {"file": ...}})."""
        item = {"id": step, "op": op, "in": in_ or {}, "params": params}
        return self.edit({"do": "insert", "list": "/steps", "value": item, **({} if at is None else {"index": at})})

    def connect(self, step, port, source):
        """An input of a step to "step.port" or {"file": name}; None leaves it open."""
        place = f"/steps/{step}/in/{port}"
        return self.unset(place) if source is None else self.set(place, source)

    def output(self, source, path, as_=None, **params):
        """An output more."""
        item = {"from": source, "path": path, **({} if as_ is None else {"as": as_}), **params}
        return self.edit({"do": "insert", "list": "/outputs", "value": item})

    def bypass(self, step, on=True):
        return self.set(f"/steps/{step}/bypass", True) if on else self.unset(f"/steps/{step}/bypass")

    def rename(self, step, name):
        return self.edit({"do": "rename", "id": step, "new_id": name})

    def remove(self, step):
        """Takes a step out; what was connected to it is connected to what it would have passed on."""
        return self.edit({"do": "remove_step", "id": step})

    def undo(self):
        """Takes the newest gesture back. False: there is none."""
        return self._engine.undo()

    def redo(self):
        return self._engine.redo()

    @property
    def revision(self):
        """Raised by every edit."""
        return self._engine.revision()

    # Results.

    @property
    def steps(self):
        """How each step stands, in the document's order."""
        return [Step(**row) for row in self._engine.steps()]

    @property
    def out_of_date(self):
        """Ids of the steps whose results are not known."""
        return [step.id for step in self.steps if step.standing not in ("fresh", "bypassed")]

    @property
    def missing(self):
        """What has to be connected before it can be run."""
        return self._engine.missing()

    def refresh(self):
        """Looks again at the files that steps read, and tries failed steps once more."""
        self._engine.refresh()

    def value(self, source, *, coarse=False, progress=None):
        """The result of "step.port", or of a step's first output; computed if it is out of date. `coarse`: on few cells."""
        return self.values([source], coarse=coarse, progress=progress)[0]

    def values(self, sources, *, coarse=False, progress=None):
        """The same of several."""
        wanted = [self._source(source) for source in sources]
        with self._asking:  # the engine knows one thing that is wanted at a time
            made, notes = self._engine.values(wanted, coarse, progress)
        say(notes)
        return [wrap(held) for held in made]

    def _source(self, source):
        step, dot, port = source.partition(".")
        if dot:
            return step, port
        op = self.get(f"/steps/{step}/op")
        if op is None:
            known = ", ".join(item["id"] for item in self.document["steps"])
            raise ValueError(f"there is no step '{step}', known are: {known}")
        return step, _FIRST_OUTPUT[op]

    def run(self, folder="out", *, progress=None):
        """Writes the outputs, all of them or none: the same bytes as `seamount run`."""
        outputs, steps, notes = self._engine.run(os.fsencode(folder), progress)
        say(notes)
        return Run([Output(**row) for row in outputs], {row["id"]: row["seconds"] for row in steps})

    def __repr__(self):
        return f"<seamount.Recipe {', '.join(step['id'] for step in self.document.get('steps', []))}>"
