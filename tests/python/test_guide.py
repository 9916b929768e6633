"""What docs/guide/python.md shows is run, block after block, in a folder of its own."""

import re

import pytest

from conftest import ROOT

GUIDE = ROOT / "docs/guide/python.md"
BLOCK = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FOREIGN = ("xarray", "rasterio", "geopandas", "pandas")


def test_every_snippet(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text, names = GUIDE.read_text(), {"__name__": "guide"}
    blocks = list(BLOCK.finditer(text))
    assert len(blocks) >= 10
    for block in blocks:
        for name in FOREIGN:
            if f"import {name}" in block[1]:
                pytest.importorskip(name)
        line = text.count("\n", 0, block.start()) + 2
        code = compile("\n" * (line - 1) + block[1], str(GUIDE), "exec")
        exec(code, names)  # a failure names the guide's own line
