"""Excitations, recordings of them, retuned and imported devices: the files of the command line, byte by byte."""

import json
import pathlib

import numpy as np
import pytest

import antinode as an
from conftest import write_wave

data = pathlib.Path(__file__).resolve().parents[1] / "Data" / "FiniteElements"
points = [-61, 33, 70]
short = {
    "sample_rate_Hz": 24000,
    "highest_frequency_Hz": 8000,
    "resolution_Hz": 4,
    "periods": 2,
    "settling_periods": 2,
}
short_options = ["--rate", 24000, "--highest-hz", 8000, "--resolution-hz", 4, "--periods", 2, "--settling", 2]


@pytest.fixture(scope="module")
def excitation():
    return an.excite("beam", **short)


@pytest.fixture(scope="module")
def recording(excitation, tmp_path_factory):
    """What sensors at three places of the beam record of it, and the sync channel: by the modes, in the frequency
    domain."""
    modes = an.device("beam").modes()
    voltages = excitation.played[:-1] * excitation.full_scale_V
    length = 1 << (2 * voltages.shape[1]).bit_length()
    omega = 2j * np.pi * np.fft.rfftfreq(length, 1 / excitation.sample_rate_Hz)
    forces = modes.participation @ np.fft.rfft(voltages, length)
    own, damping = modes.angular_frequencies_rad_s[:, None], modes.damping_ratios[:, None]
    gains = omega / (own**2 + omega**2 + 2 * damping * own * omega)
    shapes = np.array([modes.shapes_at(x) for x in points])
    signals = np.fft.irfft(shapes @ (gains * forces), length)[:, : voltages.shape[1]]
    folder = tmp_path_factory.mktemp("recording")
    write_wave(folder / "recording.wav", np.vstack([signals, excitation.played[-1]]), 24000)
    (folder / "points.csv").write_text("x_mm,y_mm\n-61,0\n33,0\n70,0\n")
    return folder


def test_an_excitation_writes_what_the_command_line_writes(program, excitation, same_files, tmp_path):
    program("excite", "--device", "beam", *short_options, "--out", tmp_path / "wanted")
    excitation.save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", ["excitation.json", "excitation.wav", "signal.wav"])
    assert excitation.numbers == json.loads((tmp_path / "wanted" / "excitation.json").read_text())


def test_what_is_played_keeps_the_levels(excitation):
    peaks = np.abs(excitation.played[:-1]).max(axis=1) * excitation.full_scale_V
    assert (peaks <= excitation.levels_V * (1 + 1e-12)).all() and (peaks > 0.95 * excitation.levels_V).all()
    assert len(excitation.played) == len(excitation.ceramics) + 1 and not excitation.signal.flags.writeable


def test_responses_are_what_the_command_line_writes(program, excitation, recording, tmp_path):
    excitation.save(tmp_path / "sheet")
    files = [tmp_path / "sheet" / "excitation.json", recording / "recording.wav"]
    options = ["--points", recording / "points.csv", "--sensitivity-mm-s-per-v", 1000]
    wanted, report = tmp_path / "wanted.uff", tmp_path / "wanted"
    program("frf", *files, *options, "--out", wanted, "--report", report)
    for sheet in (excitation, files[0]):
        found = an.frf(files[1], sheet=sheet, points=recording / "points.csv", sensitivity_mm_s_per_V=1000)
        found.save(tmp_path / "made.uff", report=tmp_path / "made")
        assert (tmp_path / "made.uff").read_bytes() == wanted.read_bytes()
        assert (tmp_path / "made" / "report.html").read_bytes() == (report / "report.html").read_bytes()
    assert found.references == excitation.ceramics and found._repr_png_().startswith(b"\x89PNG")
    assert found.plot(2).axes[0].get_xlabel() == "frequency, Hz"


def test_responses_are_those_of_the_modes(excitation, recording):
    """Docs/Theory.md, section 8.1."""
    found = an.frf(
        recording / "recording.wav", sheet=excitation, points=recording / "points.csv", sensitivity_mm_s_per_V=1000
    )
    modes = an.device("beam").modes()
    omega = 2j * np.pi * found.frequencies_Hz[:, None]
    own = modes.angular_frequencies_rad_s
    gain = omega / (own**2 + omega**2 + 2 * modes.damping_ratios * own * omega)
    for p, x in enumerate(points):
        wanted = gain @ (modes.shapes_at(x) * modes.participation[:, 1])
        error = np.linalg.norm(found.responses(1)[:, p] - wanted) / np.linalg.norm(wanted)
        assert error < 3e-3
    assert np.nanmean(found.coherence(1)) > 0.999 and found.hits == 0


def test_a_drifted_device_is_retuned_as_the_command_does(program, recording, excitation, tmp_path):
    found = an.frf(
        recording / "recording.wav", sheet=excitation, points=recording / "points.csv", sensitivity_mm_s_per_V=1000
    )
    found.save(tmp_path / "now.uff")
    before = an.device("beam", material={"youngs_modulus_GPa": 69.86, "poisson_ratio": 0.33, "density_kg_m3": 2700})
    before.save(tmp_path / "before.json")
    program("retune", tmp_path / "before.json", tmp_path / "now.uff", "--out", tmp_path / "wanted.json")
    retuned = an.retune(tmp_path / "before.json", tmp_path / "now.uff")
    retuned.save(tmp_path / "made.json")
    assert (tmp_path / "made.json").read_bytes() == (tmp_path / "wanted.json").read_bytes()
    own = an.device("beam").modes().frequencies_Hz
    seen = np.array(retuned.found) & (own < 7000)
    assert seen.sum() >= 5
    assert np.abs(retuned.device.modes().frequencies_Hz / own - 1)[seen].max() < 1e-4
    assert np.abs(retuned.frequency_changes[seen]).min() > 5e-4


def test_hits_of_a_hammer_are_what_the_command_line_makes_of_them(program, tmp_path):
    """A single mode of 200 Hz that is hit twice; the second hit bounces."""
    rate, samples = 8192, 4 * 8192
    force = np.zeros(samples)
    pulse = np.sin(np.pi * np.arange(9) / 8) ** 2
    for start in (400, 2 * 8192, 2 * 8192 + 160):
        force[start : start + 9] += 40 * pulse
    time = np.arange(samples) / rate
    own, damping = 2 * np.pi * 200, 0.02
    ring = np.exp(-damping * own * time) * np.cos(own * time)
    motion = np.convolve(force, ring)[:samples] / rate * 0.8
    write_wave(tmp_path / "hits.wav", [force / 100, motion / 10], rate)
    options = ["--channels", "force:1,1", "--force-scale", 100, "--response-scale", 10, "--quantity", "velocity"]
    options += ["--lowest-hz", 50, "--highest-hz", 1000, "--block-s", 1]
    program("frf", tmp_path / "hits.wav", *options, "--out", tmp_path / "wanted.uff")
    found = an.frf(
        tmp_path / "hits.wav",
        channels=["force:1", "1"],
        force_scale=100,
        response_scale=10,
        quantity="velocity",
        lowest_frequency_Hz=50,
        highest_frequency_Hz=1000,
        block_s=1,
    )
    found.save(tmp_path / "made.uff")
    assert (tmp_path / "made.uff").read_bytes() == (tmp_path / "wanted.uff").read_bytes()
    assert (found.hits, found.hits_left_out) == (1, 1) and found._repr_png_() == found.png(figure=0)
    peak = found.frequencies_Hz[np.abs(found.responses(0)[:, 0]).argmax()]
    assert peak == pytest.approx(200, abs=1.5)
    found.save(tmp_path / "other.uff", report=tmp_path / "report")
    assert "left out: double hit" in (tmp_path / "report/report.html").read_text()


def test_finite_elements_are_imported_as_the_command_does(program, tmp_path):
    files = [data / "plate_patch.frd", data / "plate_patch.dat"]
    program("import", *files, "--units", "mm", "--name", "mine", "--out", tmp_path / "wanted.json")
    imported = an.import_device(*files, units="mm", name="mine")
    imported.save(tmp_path / "made.json")
    assert (tmp_path / "made.json").read_bytes() == (tmp_path / "wanted.json").read_bytes()
    assert imported.device.name == "mine" and imported.device.kind == "modal"
    assert imported.mass_kg > 0 and imported.surface_nodes > 3


@pytest.mark.parametrize(
    "call",
    [
        lambda: an.excite("no-such-device"),
        lambda: an.excite("beam", signal="square"),
        lambda: an.excite("beam", levels_V=[1, 2]),
        lambda: an.excite("beam", levels_V=[1e6]),
        lambda: an.excite("beam", sample_rate_Hz=float("nan")),
        lambda: an.excite("beam", seed=-1),
        lambda: an.frf(),
        lambda: an.frf("missing.wav"),
        lambda: an.frf("missing.wav", sheet="missing.json"),
        lambda: an.frf("missing.wav", sheet=an.excite("beam", **short)),
        lambda: an.frf("missing.wav", sheet=an.excite("beam", **short), sensitivity_mm_s_per_V=1),
        lambda: an.frf("missing.wav", estimator="h3"),
        lambda: an.frf("missing.wav", trigger_percent=0),
        lambda: an.retune("beam"),
        lambda: an.retune("beam", "missing.uff"),
        lambda: an.retune("beam", "missing.uff", drift_percent=0),
        lambda: an.import_device(),
        lambda: an.import_device("missing.frd"),
        lambda: an.import_device(data / "plate_patch.frd", units="inch"),
        lambda: an.import_device(data / "plate_patch.frd", points=2),
        lambda: an.import_device(data / "plate_patch.frd", damping_ratio=0),
    ],
)
def test_bad_input_is_refused_in_one_sentence(call):
    with pytest.raises(an.InputError) as error:
        call()
    assert str(error.value) and "\n" not in str(error.value)
