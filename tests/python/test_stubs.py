"""The types that editors read are those of the operators."""

import ast
import inspect

import pytest

import seamount as sm
from conftest import ROOT
from seamount import stubs

FOLDER = ROOT / "apps/python/seamount"


def test_fresh():
    for name, text in stubs.stubs().items():
        assert (FOLDER / name).exists() and (FOLDER / name).read_text() == text, (
            f"{name} is stale: PYTHONPATH=build/dev/apps/python python3 -m seamount.stubs apps/python/seamount")


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


def test_check_tells_what_is_stale(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("sys.argv", ["stubs", str(tmp_path)])
    assert stubs.main() == 0
    monkeypatch.setattr("sys.argv", ["stubs", str(tmp_path), "--check"])
    assert stubs.main() == 0
    (tmp_path / "reef.pyi").write_text("")
    (tmp_path / "gone.pyi").write_text("")
    assert stubs.main() == 1 and "gone.pyi" in capsys.readouterr().err
