"""The programs of the manual run as they stand there."""

import os
import pathlib
import re
import subprocess
import sys

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


def test_a_tolerance_figure_takes_ten_lines(tmp_path, monkeypatch, capsys):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    figure, indices = blocks("tolerance-figure.md")
    assert len([line for line in figure.splitlines() if line]) <= 10
    exec(compile(figure, "tolerance-figure.md", "exec"), {})
    assert (tmp_path / "tolerance.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "tolerance" / "results.csv").read_text().count("\n") == 10001
    exec(compile(indices, "tolerance-figure.md", "exec"), {})
    assert capsys.readouterr().out.count("lower_95") == 6


def test_the_programs_of_the_page_about_clusters_run(tmp_path):
    """As printed: the plan of the page about sweeps, its shards by a shell, then Dask, to the same bytes."""
    pytest.importorskip("distributed")
    page = (pages / "clusters.md").read_text()
    plan = re.search(r"^```json\n(.*?)^```", (pages / "sweeps.md").read_text(), re.M | re.S)[1]
    shards = next(block for block in re.findall(r"^```sh\n(.*?)^```", page, re.M | re.S) if "--shard 1/2" in block)
    by_shards, by_dask = tmp_path / "shards", tmp_path / "dask"
    for folder in (by_shards, by_dask):
        folder.mkdir()
        (folder / "tolerance.json").write_text(plan)
    environment = {**os.environ, "PATH": f"{pathlib.Path(os.environ['ANTINODE_PROGRAM']).parent}:{os.environ['PATH']}"}
    subprocess.run(["sh", "-e", "-c", shards], cwd=by_shards, env=environment, check=True)
    (block,) = blocks("clusters.md")
    script = by_dask / "cluster.py"
    script.write_text(block)
    said = subprocess.run([sys.executable, str(script)], cwd=by_dask, env=environment, check=True, capture_output=True, text=True)
    assert "v_score_truncated" in said.stdout
    for name in ("results.csv", "results.mat", "summary.json", "report.html"):
        assert (by_dask / "tolerance" / name).read_bytes() == (by_shards / "tolerance" / name).read_bytes()
