"""The notebook and the code in the manual run as they stand."""

import os
import re
from pathlib import Path

import nbformat
import pytest
from nbclient import NotebookClient

ROOT = Path(__file__).parents[2]


def test_the_notebook_goes_from_scan_to_scores(tmp_path):
    notebook = nbformat.read(ROOT / "python/examples/scan_to_scores.ipynb", as_version=4)
    nbformat.validate(notebook)
    assert not any(cell.get("outputs") for cell in notebook.cells)  # none of another machine
    os.environ["IPYTHONDIR"] = str(tmp_path)
    NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    printed = "".join(
        output.get("text", "") for cell in notebook.cells for output in cell.get("outputs", []))
    f = re.search(r"^f +([0-9.]+)", printed, re.MULTILINE)
    assert f and float(f[1]) > 0.7, printed


def blocks():
    text = (ROOT / "resources/manual/python.md").read_text(encoding="utf-8")
    return re.findall(r"^```python\n(.*?)^```", text, re.MULTILINE | re.DOTALL)


def test_the_code_in_the_manual_runs(plant, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "pine.xyz").write_text(plant.file.read_text())
    plant.truth.write("expert.mtg")
    names: dict = {}
    assert len(blocks()) > 5
    for block in blocks():
        try:
            exec(block, names)
        except Exception as problem:
            pytest.fail(f"{problem!r} in\n{block}")
    assert (tmp_path / "pine.mtg").read_text() == names["plant"].skeleton.mtg()
