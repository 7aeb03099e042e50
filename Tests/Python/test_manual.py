"""The programs of the manual run as they stand there."""

import pathlib
import re

import pytest

pages = pathlib.Path(__file__).resolve().parents[2] / "Docs/Manual"


def blocks(page):
    """The blocks of Python in a page, in their order, with the imports of the first one."""
    return re.findall(r"^```python\n(.*?)^```", (pages / page).read_text(), re.M | re.S)


def test_the_programs_of_the_page_about_python_run(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    first, *others = blocks("python.md")
    assert len(first.strip().splitlines()) <= 10
    for block in (first, *others):
        exec(compile(block, "python.md", "exec"), {"an": __import__("antinode")})
    assert (tmp_path / "focus.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "focus-70-90" / "voltages.wav").exists() and (tmp_path / "my-beam.json").exists()
