"""The types that editors read are those of the operators."""

import ast
import inspect
import pathlib

import pytest

import seamount as sm
from seamount import stubs


def test_the_package_has_them():
    folder = pathlib.Path(sm.__file__).parent
    there = {path.name: path.read_text() for path in folder.glob("*.pyi") if path.name != "_core.pyi"}
    assert there == stubs.stubs()


@pytest.mark.parametrize("name", sorted(stubs.stubs()))
def test_stubs_are_python(name):
    ast.parse(stubs.stubs()[name])


def test_stubs_have_what_the_module_has():
    for name, text in stubs.stubs().items():
        if name == "__init__.pyi":
            continue
        family = getattr(sm, name.removesuffix(".pyi"))
        defined = {node.name: node for node in ast.parse(text).body if isinstance(node, ast.FunctionDef)}
        assert set(defined) == set(family.__all__)
        for function, node in defined.items():
            written = [arg.arg for arg in node.args.args + node.args.kwonlyargs]
            assert written == list(inspect.signature(getattr(family, function)).parameters)


def test_written_anew(tmp_path, monkeypatch):
    (tmp_path / "reef.pyi").write_text("")
    (tmp_path / "gone.pyi").write_text("")
    (tmp_path / "_core.pyi").write_text("by hand")
    monkeypatch.setattr("sys.argv", ["stubs", str(tmp_path)])
    assert stubs.main() == 0
    assert {path.name for path in tmp_path.iterdir()} == {*stubs.stubs(), "_core.pyi"}
    assert (tmp_path / "reef.pyi").read_text() == stubs.stubs()["reef.pyi"]
