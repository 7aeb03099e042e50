"""A focus at every place: the files of the command line, byte by byte."""

import csv

import numpy as np
import pytest

import antinode as an

files = ["map.csv", "report.html", "summary.json"]


@pytest.fixture(scope="module")
def line():
    return an.map(places=40)


def test_a_map_writes_what_the_command_line_writes(program, line, same_files, tmp_path):
    program("map", "--places", 40, "--out", tmp_path / "wanted", "--quiet")
    line.save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", files)


def test_a_map_of_a_plate_is_that_of_the_command_line(program, same_files, tmp_path):
    options = ["--places", 60, "--no-felt", "--threads", 1]
    program("map", "aluminium-200x120", "aluminium-centre", *options, "--out", tmp_path / "wanted", "--quiet")
    mapped = an.map("aluminium-200x120", "aluminium-centre", places=60, felt=False, threads=2)
    mapped.save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", files)
    with open(tmp_path / "wanted" / "map.csv", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert mapped.v_score.shape == (len(mapped.y_mm), len(mapped.x_mm)) and mapped.v_score.size == len(rows)
    for row, score in zip(rows, mapped.v_score.ravel()):
        assert float(row["v_score"] or "nan") == pytest.approx(score, rel=1e-8, nan_ok=True)
    assert float(rows[1]["x_mm"]) == pytest.approx(mapped.x_mm[1]) and float(rows[-1]["y_mm"]) == pytest.approx(mapped.y_mm[-1])
    assert np.isnan(mapped.felt_contrast_dB).all()
    assert mapped.png(figure=2) != mapped.png() and mapped.plot("peak_voltage_V").axes[0].get_ylabel() == "y, mm"


def test_each_place_is_a_design_of_its_own(line):
    column = 10
    rendered = an.render(an.focus(x_mm=line.x_mm[column]))
    assert line.peak_voltage_V[0, column] == pytest.approx(rendered.scores["peak_voltage_V"], rel=1e-4)
    # The map's field is that of the closed form, the render's that of samples.
    assert line.v_score[0, column] == pytest.approx(rendered.scores["v_score"], abs=2e-3)


def test_places_without_a_design_say_why():
    one = an.focus().to_dict()["targets"][0]
    two = an.focus(changes={"targets": [one, {**one, "x_mm": one["x_mm"] + 50}]})
    mapped = an.map("beam", two, places=30, felt=False)
    assert mapped.errors and np.isfinite(mapped.peak_voltage_V).any()
    for (row, column), sentence in mapped.errors.items():
        assert np.isnan(mapped.peak_voltage_V[row, column])
        assert "outside the surface" in sentence and "\n" not in sentence


def test_progress_and_interruption():
    heard = []
    an.map(places=30, felt=False, progress=lambda what, share: heard.append(share))
    assert heard == sorted(heard) and heard[-1] == 1

    def stop(what, share):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        an.map(places=30, felt=False, progress=stop)


def test_bad_input_is_refused(line):
    for wrong in ({"places": 0}, {"places": 10**6}, {"threads": 0}, {"sample_rate_Hz": 1}, {"threshold": "missing.csv"}):
        with pytest.raises(an.InputError) as error:
            an.map(**wrong)
        assert "\n" not in str(error.value)
    with pytest.raises(an.InputError, match="number: is 'loudness'"):
        line.plot("loudness")
