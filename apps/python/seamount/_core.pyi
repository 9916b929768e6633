# The compiled part: what the package shows of it. The rest is the package's own business.
from typing import Any, Dict, List

version: str

class Error(Exception): ...

class InvalidArgument(Error, ValueError):
    field: str
    diagnostics: List[Dict[str, Any]]

class IncompatibleInputs(Error, ValueError): ...

class IoError(Error, OSError):
    path: str

class WriteError(IoError): ...
class Cancelled(Error): ...

class RecipeError(Error, ValueError):
    field: str
    diagnostics: List[Dict[str, Any]]

def __getattr__(name: str) -> Any: ...
