"""Designs and renders: the files of the command line, byte by byte."""

import numpy as np
import pytest

import antinode as an

rendered = ["design.json", "field.csv", "probe.csv", "probe.wav", "report.html", "summary.json", "voltages.wav"]


@pytest.mark.parametrize(
    "focus, device, options, keywords",
    [
        (an.focus("demonstrator"), "staple", ["demonstrator"], {}),
        (
            an.focus(x_mm=-24, method="least_voltage"),
            "staple",
            ["--set", "focus.targets.0.x_mm=-24", "--set", "focus.allocation.method=least_voltage", "--rate", "96000"]
            + ["--probe", "-24", "--probe", "0,0", "--duration-ms", "60", "--repeat-hz", "20"],
            {"sample_rate_Hz": 96000, "probes_mm": [-24, (0, 0)], "duration_ms": 60, "repeat_Hz": 20},
        ),
    ],
)
def test_a_render_writes_what_the_command_line_writes(program, same_files, tmp_path, focus, device, options, keywords):
    program("render", *options, "--out", tmp_path / "wanted")
    an.render(focus, device, **keywords).save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", rendered)


def test_a_render_on_a_plate_writes_what_the_command_line_writes(program, same_files, tmp_path):
    names = [name for name in rendered if name not in ("report.html", "voltages.wav")]
    program(
        "render", "aluminium-centre", "--device", "aluminium-200x120", "--no-report", "--format", "csv", "--out", tmp_path / "wanted"
    )
    an.render("aluminium-centre", "aluminium-200x120").save(tmp_path / "made", report=False, format="csv")
    same_files(tmp_path / "wanted", tmp_path / "made", names + ["section.csv", "voltages.csv"])


def test_a_design_writes_what_the_command_line_writes(program, same_files, tmp_path):
    program("design", "staple-train", "--out", tmp_path / "wanted")
    an.design("staple-train").save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", ["design.json"])


def test_voltages_are_the_sum_of_the_oscillations():
    """Docs/Theory.md, section 4: U_i(t) = sum_l M_il psi_l(t); played samples are those up to the focus."""
    rendered = an.render()
    design = rendered.design
    times = rendered.times_s
    values = np.zeros((len(design.oscillations), len(times)))
    for row, drive in zip(values, design.oscillations):
        tau = times - drive["start_s"]
        plays = (tau >= 0) & (times < drive["end_s"])
        phase = drive["angular_frequency_rad_s"] * tau
        wave = drive["in_phase"] * np.sin(phase) + drive["quadrature"] * np.cos(phase)
        row[plays] = np.exp(drive["growth_per_s"] * tau[plays]) * wave[plays]
    voltages = design.allocation_V @ values
    # To the rounding of the recursion that plays them; what lies at the very ends of drives may be a sample later.
    assert np.abs(voltages - rendered.voltages_V).max() < 1e-9 * design.peak_voltage_V


def test_a_design_is_played_as_it_is():
    design = an.design(an.focus(x_mm=-24), sample_rate_Hz=96000)
    rendered = an.render(design)
    assert rendered.design is design and rendered.sample_rate_Hz == 96000
    again = an.render(an.focus(x_mm=-24), sample_rate_Hz=96000)
    assert np.array_equal(rendered.voltages_V, again.voltages_V)
    assert rendered.scores["v_score"] == again.scores["v_score"]


def test_the_predicted_field_is_reached():
    """The plate model knows only samples; the prediction is a closed form."""
    for focus in (an.focus(), an.focus(method="least_voltage")):
        design = an.design(focus)
        reached = an.render(design).reached_field_m_s
        assert np.abs(reached - design.predicted_field_m_s).max() < 1e-3 * np.abs(reached).max()


def test_arrays_of_a_render_are_views():
    rendered = an.render()
    for owner, names in (
        (rendered, ["voltages_V", "probe_velocities_m_s", "modal_velocities", "reached_field_m_s", "points_m"]),
        (rendered.design, ["allocation_V", "voltage_limits_V", "wanted_field_m_s", "represented_field_m_s"]),
    ):
        for name in names:
            first, second = getattr(owner, name), getattr(owner, name)
            assert first.__array_interface__["data"] == second.__array_interface__["data"]
            assert first.__array_interface__["data"][1], "read only"


def test_no_voltage_passes_its_limit():
    rendered = an.render(an.focus(voltage_limit_V=15, x_mm=-24))
    assert np.abs(rendered.voltages_V).max() <= 15


def test_what_a_limit_allows_is_in_the_error():
    with pytest.raises(an.LimitError) as caught:
        an.design(an.focus(voltage_limit_V=5))
    error = caught.value
    assert f"at least {error.minimum_peak_voltage_V:.4g} V" in str(error)
    # All is linear: the velocity that the error names can be reached, 1 % more cannot.
    reachable = error.reachable_velocity_m_s * 1e3
    an.design(an.focus(voltage_limit_V=5, peak_velocity_mm_s=0.999 * reachable))
    with pytest.raises(an.LimitError):
        an.design(an.focus(voltage_limit_V=5, peak_velocity_mm_s=1.01 * reachable))
