"""Measuring on a simulated bench, identifying and placing: the files of the command line, byte by byte."""

import json

import numpy as np
import pytest

import antinode as an

points = [-61, 33, 70]
short = {
    "sample_rate_Hz": 24000,
    "highest_frequency_Hz": 8000,
    "resolution_Hz": 4,
    "periods": 2,
    "settling_periods": 2,
    "snr_dB": 60,
}


@pytest.fixture(scope="module")
def measured(tmp_path_factory):
    folder = tmp_path_factory.mktemp("measured")
    return folder, an.measure("beam", points, folder, **short)


def test_measure_writes_what_the_command_line_writes(program, measured, same_files, tmp_path):
    folder, _ = measured
    (tmp_path / "points.csv").write_text("x_mm,y_mm\n-61,0\n33,0\n70,0\n")
    options = ["--rate", 24000, "--highest-hz", 8000, "--resolution-hz", 4, "--periods", 2, "--settling", 2]
    options += ["--snr-db", 60, "--points", tmp_path / "points.csv", "--out", tmp_path / "wanted"]
    program("measure", "--device", "beam", "--simulate", *options)
    names = ["excitation.json", "points.csv", "report.html", "responses.uff", "signal.wav"]
    same_files(tmp_path / "wanted", folder, names + [f"point-{number:04}.uff" for number in (1, 2, 3)])


def test_responses_are_those_of_the_modes(measured):
    """H = sum_k phi_k alpha_k i omega / (omega_k^2 - omega^2 + 2 i xi_k omega_k omega): Docs/Theory.md, section 8.1."""
    _, measurement = measured
    modes = an.device("beam").modes()
    omega = 2j * np.pi * measurement.frequencies_Hz[:, None]
    own = modes.angular_frequencies_rad_s
    gain = omega / (own**2 + omega**2 + 2 * modes.damping_ratios * own * omega)
    for p, x in enumerate(points):
        wanted = gain @ (modes.shapes_at(x) * modes.participation[:, 2])
        error = np.linalg.norm(measurement.responses(2)[:, p] - wanted) / np.linalg.norm(wanted)
        assert error < 3e-3


def test_identify_finds_the_modes_and_writes_what_the_command_line_writes(program, measured, tmp_path):
    folder, _ = measured
    responses = folder / "responses.uff"
    program("identify", responses, "--band", "100:7000", "--name", "mine", "--out", tmp_path / "wanted.json")
    found = an.identify(responses, bands_Hz=[(100.0, 7000.0)], name="mine")
    found.save(tmp_path / "made.json")
    assert (tmp_path / "made.json").read_bytes() == (tmp_path / "wanted.json").read_bytes()
    own = an.device("beam").modes().frequencies_Hz
    own = own[(own > 100) & (own < 7000)]
    assert np.allclose(found.frequencies_Hz, own, rtol=1e-4)
    assert found.device.kind == "modal" and np.array_equal(found.device.modes().frequencies_Hz, found.frequencies_Hz)


def test_identified_modes_are_compared_with_a_device_of_any_kind(program, measured, tmp_path):
    responses = measured[0] / "responses.uff"
    computed = an.device("beam", thickness_mm=2.01)
    computed.save(tmp_path / "computed")
    options = ["--band", "100:7000", "--against", f"{tmp_path}/computed"]
    names = ["device.json", "report.html", "report-diagram.html", "transferred.json"]
    wanted, made = tmp_path / "wanted", tmp_path / "made"
    wanted.mkdir()
    program("identify", responses, *options, "--out", wanted / names[0], "--report", wanted / names[1], "--transfer", wanted / names[3])
    for against in (computed, tmp_path / "computed", computed.to_dict()):
        made.mkdir(exist_ok=True)
        found = an.identify(responses, bands_Hz=[(100.0, 7000.0)], against=against)
        found.save(made / names[0], report=made / names[1], transferred=made / names[3])
        for name in names:
            assert (made / name).read_bytes() == (wanted / name).read_bytes(), name
    with pytest.raises(an.InputError, match="against"):
        an.identify(responses).save(made / "other.json", transferred=made / "none.json")


def test_place_finds_what_the_command_line_finds(program, tmp_path):
    options = ["--count", 3, "--modes", 6, "--size-mm", "12x10", "--keep-out-mm", "80,40,120,80"]
    program("place", "aluminium-200x120", *options, "--out", tmp_path / "wanted.json")
    placed = an.place("aluminium-200x120", count=3, modes=6, size_mm=(12, 10), keep_out_mm=[(80, 40, 120, 80)])
    assert placed.device.to_dict() == json.loads((tmp_path / "wanted.json").read_text())
    assert len(placed.device.modes().ceramics) == 3 and placed.controllability > 0


@pytest.mark.parametrize(
    "call",
    [
        lambda folder: an.measure("beam", [], folder),
        lambda folder: an.measure("beam", [float("nan")], folder),
        lambda folder: an.measure("beam", [1000], folder),
        lambda folder: an.measure("beam", [0], folder, simulate=False),
        lambda folder: an.measure("beam", [0], folder, signal="square"),
        lambda folder: an.measure("beam", [0], folder, snr_dB=1e9),
        lambda folder: an.measure("beam", [0], folder, levels_V=[1, 2]),
        lambda folder: an.identify(),
        lambda folder: an.identify("missing.uff"),
        lambda folder: an.identify("missing.uff", kind="imaginary"),
        lambda folder: an.identify("missing.uff", orders=(0, 3)),
        lambda folder: an.place(count=0),
        lambda folder: an.place(size_mm=-1),
        lambda folder: an.place(keep_out_mm=[(1, 2, 3)]),
        lambda folder: an.place(keep_out_mm=[(0, 0, 1000, 1000)]),
        lambda folder: an.place("aluminium-200x120", step_mm=0),
    ],
)
def test_bad_input_is_refused_in_one_sentence(call, tmp_path):
    with pytest.raises(an.InputError) as error:
        call(tmp_path / "out")
    assert "\n" not in str(error.value)
    assert not (tmp_path / "out" / "responses.uff").exists()
