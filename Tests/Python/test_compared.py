"""Tolerance and trade-off of designs, and devices side by side: the files of the command line, byte by byte."""

import csv
import json

import numpy as np
import pytest

import antinode as an

tolerance_files = ["design.json", "tolerance.html", "tolerance.json"]
tradeoff_files = ["tradeoff.csv", "tradeoff.html", "tradeoff.json"]


def test_a_tolerance_writes_what_the_command_line_writes(program, same_files, tmp_path):
    options = ["--draws", 40, "--seed", 3, "--damping-percent", 12]
    program("design", "--tolerance", *options, "--out", tmp_path / "wanted", "--quiet")
    an.tolerance(draws=40, seed=3, damping_percent=12).save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", tolerance_files)


def test_the_tolerance_of_a_design_is_that_of_its_focus():
    focus = an.focus(x_mm=-24)
    design = an.design(focus)
    tolerance = an.tolerance(design, draws=20)
    assert tolerance.design is design
    assert np.array_equal(tolerance.field_errors, an.tolerance(focus, draws=20).field_errors)


def test_numbers_of_a_tolerance_are_those_of_its_draws():
    tolerance = an.tolerance(draws=50)
    reported = tolerance.numbers["designs"][-1]
    for name, scores in (("v_score", tolerance.v_scores), ("field_error", tolerance.field_errors)):
        assert [draw[name] for draw in reported["draws"]] == list(scores)
        assert np.allclose(np.percentile(scores, tolerance.numbers["percentiles"]), reported[name], rtol=1e-12)
    assert len(tolerance.peak_ratios) == 50 and not tolerance.peak_ratios.flags.writeable
    errors = [cause["field_error"] for cause in tolerance.causes]
    assert errors == sorted(errors, reverse=True) and errors[0] > 0
    assert "50 random devices" in str(tolerance)


def test_a_robust_focus_is_compared_with_what_it_would_be_without():
    focus = an.focus(changes={"allocation.robust.frequency_percent": 0.3})
    tolerance = an.tolerance(focus, draws=30)
    nominal, robust = tolerance.numbers["designs"]
    assert (nominal["design"], robust["design"]) == ("nominal", "robust")
    assert np.median(tolerance.field_errors) == pytest.approx(robust["field_error"][2])
    assert robust["field_error"][2] < nominal["field_error"][2]
    assert len(tolerance.plot().axes[0].lines) == 2


@pytest.fixture(scope="module")
def compared():
    return an.tradeoff(device="beam")


def test_a_tradeoff_writes_what_the_command_line_writes(program, compared, same_files, tmp_path):
    program("design", "--tradeoff", "--device", "beam", "--out", tmp_path / "wanted", "--quiet")
    compared.save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", tradeoff_files)


def test_no_point_of_the_front_is_beaten(compared):
    good = [point for point in compared.points if point.get("field_error_truncated", 1) < 0.05]
    assert compared.front
    for point in compared.front:
        assert not any(
            other["peak_voltage_V"] < point["peak_voltage_V"] and other["time_in_motion_ms"] < point["time_in_motion_ms"]
            for other in good
        )
    bound = compared.numbers["lower_bound_voltage_V"]
    assert all(point["peak_voltage_V"] > 0.999 * bound for point in good)
    assert "Lower bound" in str(compared)


def test_a_focus_with_felt_is_compared_by_its_weights(program, same_files, tmp_path):
    changes = {"allocation.times_bound": "limit", "felt.at": "everywhere"}
    felt = ["--set", "focus.allocation.method=least_voltage"]
    felt += [part for key, value in changes.items() for part in ("--set", f"focus.{key}={value}")]
    program("design", "--tradeoff", *felt, "--out", tmp_path / "wanted", "--quiet")
    tradeoff = an.tradeoff(an.focus(method="least_voltage", changes=changes))
    tradeoff.save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", tradeoff_files)
    weights = [point["weight"] for point in tradeoff.points]
    assert weights == sorted(weights) and tradeoff.front == []


def test_progress_of_a_tolerance_rises_to_all_of_it():
    heard = []
    an.tolerance(draws=500, progress=lambda what, share: heard.append((what, share)))
    shares = [share for _, share in heard]
    assert shares == sorted(shares) and shares[-1] == 1 and {what for what, _ in heard} == {"Drawing devices"}


@pytest.mark.parametrize(
    "options, call",
    [
        (["--tolerance", "--frequency-percent", "11"], lambda: an.tolerance(frequency_percent=11)),
        (["--tolerance", "--drift-percent", "nan"], lambda: an.tolerance(drift_percent=float("nan"))),
        (["--tradeoff", "--rate", "7999"], lambda: an.tradeoff(sample_rate_Hz=7999)),
        (["--tradeoff", "--set", "focus.targets.0.x_mm=200"], lambda: an.tradeoff(an.focus(x_mm=200))),
    ],
)
def test_the_sentence_is_that_of_the_command_line(program, tmp_path, options, call):
    printed = program("design", *options, "--out", tmp_path / "none", fails=True)
    with pytest.raises(an.InputError) as error:
        call()
    # The command line names an option, Python a keyword.
    assert printed.split(": ", 2)[2] == str(error.value).split(": ", 1)[1] + "\n"


def test_bad_input_is_refused():
    for wrong in ({"draws": 0}, {"draws": 10**7}, {"seed": -1}, {"damping_percent": -1}):
        with pytest.raises(an.InputError):
            an.tolerance(**wrong)
    with pytest.raises(an.InputError, match="device"):
        an.tolerance("demonstrator", an.focus())


def test_figures_are_those_of_the_report(compared):
    tolerance = an.tolerance(draws=20)
    for value in (tolerance, compared):
        assert value.png(figure=0) == value._repr_png_() != value.png(theme="dark")
        assert len(value.figures) >= 1 and value.plot().axes[0].get_xlabel()
    assert tolerance.png(figure=1) != tolerance.png(figure=0)
    with pytest.raises(an.InputError, match="figure: is 9"):
        tolerance.png(figure=9)
    assert json.dumps(tolerance.numbers)


def test_a_comparison_of_devices_is_that_of_the_command_line(program, same_files, tmp_path):
    options = ["--focus", "demonstrator", "--draws", 5, "--figures", "svg"]
    program("compare", "staple", "beam", *options, "--out", tmp_path / "wanted", "--quiet")
    compared = an.compare(["staple", an.device("beam")], focuses=["demonstrator"], draws=5, figures=["svg"])
    compared.save(tmp_path / "made")
    figures = [f"figure-what-each-device-needs-and-gives-{number}.svg" for number in range(1, 5)]
    for folder in ("wanted", "made"):
        with open(tmp_path / folder / "scores.csv", encoding="utf-8") as stream:
            rows = list(csv.DictReader(stream))
        for row in rows:
            row.pop("solver_time_ms")  # the one number that differs from run to run
        (tmp_path / folder / "scores.csv").write_text(json.dumps(rows))
    same_files(tmp_path / "wanted", tmp_path / "made", ["compare.pdf", "report.html", "scores.csv", *figures])
    staple, beam = compared.cases
    assert (staple["device"], beam["device"], staple["played"]) == ("staple", "beam", "demonstrator")
    assert staple["peak_voltage_V"] == pytest.approx(an.render("demonstrator", "staple").scores["peak_voltage_V"])
    assert staple["error"] == "" and len(compared.figures) == 4 and "19 of 20 devices" in str(compared)
    with pytest.raises(an.InputError, match="has nothing to compare"):
        an.compare(["beam"])
