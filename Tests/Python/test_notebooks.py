"""The notebooks of Docs/Notebooks run from top to bottom, and show pictures."""

import os
import pathlib

import nbformat
import pytest
from nbclient import NotebookClient

folder = pathlib.Path(__file__).resolve().parents[2] / "Docs/Notebooks"
files = sorted(folder.glob("*.ipynb"))


def test_there_are_notebooks():
    assert len(files) >= 3


@pytest.mark.parametrize("file", files, ids=lambda file: file.stem)
def test_the_notebook_runs(file, tmp_path, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", f"{folder}{os.pathsep}{os.environ['PYTHONPATH']}")
    notebook = nbformat.read(file, as_version=4)
    nbformat.validate(notebook)
    assert all(not cell.get("outputs") for cell in notebook.cells), "is kept without its outputs"
    NotebookClient(notebook, timeout=300, resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    assert any(output.get("text") for output in outputs), "prints what it found"
    pictures = [output for output in outputs if "image/png" in output.get("data", {})]
    assert len(pictures) == {"first-focus": 4, "paper": 10}.get(file.stem, len(pictures))
