"""What all values have in common."""

import os

from . import _core
from ._frame import as_tuple
from ._notes import say


class Value:
    """Base of all values. They are made by operators, read from files, and can be pickled."""

    __slots__ = ("_held", "__weakref__")
    kind = ""

    @classmethod
    def _of(cls, held):
        value = object.__new__(cls)
        value._held = held
        return value

    @classmethod
    def read(cls, path, *, frame=None):
        """Of a file; what says nothing of its place is laid over `frame`. Raises IoError."""
        held, notes = _core.read(cls.kind, os.fsencode(path), None if frame is None else as_tuple(frame))
        say(notes)
        return cls._of(held)

    def save(self, path, as_=None, *, with_=None, progress=None, **params):
        """Writes the value as an output of a recipe: the format by the file's ending, or by its name `as_` ("map", "unreal",
        "mesh", ...) with its parameters. `with_`: values that belong to it, by name ("labels", "rivers"). Returns the files.
        Raises WriteError, InvalidArgument."""
        companions = {name: value._held for name, value in (with_ or {}).items()}
        files, notes = _core.save(self._held, os.fsencode(path), as_, params, companions, progress)
        say(notes)
        return files

    def __reduce__(self):
        return _restore, (self._held.dump(),)

    def __repr__(self):
        return f"<seamount.{type(self).__name__}>"


def _restore(state):
    from ._values import wrap
    return wrap(_core.load(state))


def invalid(field, problem):
    """An InvalidArgument, to be raised."""
    error = _core.InvalidArgument(f"{field}: {problem}")
    error.field, error.diagnostics = field, []
    return error
