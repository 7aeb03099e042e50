"""Sensors, learning and following: the files of the command line, byte by byte."""

import json

import numpy as np
import pytest

import antinode as an
from conftest import write_wave

sensors_mm = [-61, 33, 70]
learnt_files = ["design.json", "device.json", "learnt.csv", "report.html", "summary.json", "voltages.wav"]
rate = 48000.0


@pytest.fixture
def points(tmp_path):
    file = tmp_path / "sensors.csv"
    file.write_text("x_mm,y_mm\n-61,0\n33,0\n70,0\n")
    return file


def drifted_beam():
    """The embedded beam with a modulus that is .2 % lower: its frequencies are .08 to .09 % lower."""
    return an.device("beam", material={"youngs_modulus_GPa": 69.86, "poisson_ratio": 0.33, "density_kg_m3": 2700})


def signals_of(device, voltages_V, sample_rate_Hz):
    """Velocities at the sensors: the response of each mode, by transforms of twice the length, with what rings longer
    folded back into silence. Docs/Theory.md, section 8.1."""
    modes = device.modes()
    samples = voltages_V.shape[1]
    length = 1 << (4 * samples).bit_length()
    omega = 2j * np.pi * np.fft.rfftfreq(length, 1 / sample_rate_Hz)
    forces = modes.participation @ np.fft.rfft(voltages_V, length)
    own, damping = modes.angular_frequencies_rad_s[:, None], modes.damping_ratios[:, None]
    velocities = omega / (own**2 + omega**2 + 2 * damping * own * omega) * forces
    shapes = np.array([modes.shapes_at(x) for x in sensors_mm])
    return np.fft.irfft(shapes @ velocities, length)[:, :samples]


def test_sensors_write_what_the_command_line_writes(program, same_files, tmp_path):
    program("sensors", "--count", 3, "--candidates", 200, "--out", tmp_path / "wanted", "--quiet")
    chosen = an.sensors(count=3, candidates=200)
    chosen.save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", ["candidates.csv", "report.html", "sensors.csv", "summary.json"])
    assert chosen.places_mm.shape == (3, 2) and list(chosen.bits) == sorted(chosen.bits)
    assert chosen.bits[-1] > chosen.random_bits and chosen.numbers["bits"] == chosen.bits[-1]
    assert chosen.candidates_mm.shape == (200, 2) and chosen.candidate_bits.max() < chosen.bits[-1]
    assert chosen.plot().axes[0].get_xlabel() == "x, mm" and chosen._repr_png_().startswith(b"\x89PNG")


def test_idle_ceramics_are_sensors_as_those_of_the_command_line(program, same_files, tmp_path, points):
    options = ["--device", "beam", "--idle-ceramic", 2]
    files = ["candidates.csv", "report.html", "sensors.csv", "summary.json"]
    program("sensors", *options, "--candidates", 100, "--out", tmp_path / "places", "--quiet")
    chosen = an.sensors(device="beam", idle_ceramics=[2], candidates=100)
    chosen.save(tmp_path / "chosen")
    same_files(tmp_path / "places", tmp_path / "chosen", files)
    assert len(chosen.idle_ceramics) == 2 and len(chosen.candidate_bits) == len(chosen.candidates_mm) + 1
    options += ["--rate", 48000, "--duration-ms", 100, "--sensors", points, "--passes", 1]
    program("learn", *options, "--simulate", "--out", tmp_path / "wanted", "--quiet")
    an.learn(
        device="beam", sensors_mm=sensors_mm, idle_ceramics=[2], simulate=True, passes=1, sample_rate_Hz=rate, duration_ms=100
    ).save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", learnt_files)


def test_learning_on_a_simulated_bench_writes_what_the_command_line_writes(program, same_files, tmp_path, points):
    options = ["--device", "beam", "--rate", 48000, "--duration-ms", 100, "--sensors", points]
    program("learn", "demonstrator", *options, "--simulate", "--passes", 2, "--out", tmp_path / "wanted", "--quiet")
    learnt = an.learn(
        device="beam", sensors_mm=sensors_mm, simulate=True, passes=2, sample_rate_Hz=rate, duration_ms=100
    )
    learnt.save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", learnt_files)
    first, last = (each["estimated_field_error_percent"] for each in learnt.passes)
    assert learnt.is_accepted and not learnt.refusal and not learnt.warning and last < first
    assert all(abs(each["distortion_percent"]) < 5 * each["distortion_deviation_percent"] for each in learnt.ceramics)
    assert learnt.plot().axes[0].get_xlabel() == "pass" and learnt._repr_png_().startswith(b"\x89PNG")


def test_learning_from_a_function_that_plays():
    truth = drifted_beam()
    played = []

    def play(voltages_V, number):
        assert not voltages_V.flags.writeable
        played.append(voltages_V)
        return signals_of(truth, voltages_V, rate)

    learnt = an.learn(
        device="beam", sensors_mm=sensors_mm, play=play, passes=2, snr_dB=60, sample_rate_Hz=rate, duration_ms=100
    )
    assert len(played) == 2 and learnt.is_accepted
    assert np.array_equal(played[0], an.learn(device="beam", sensors_mm=sensors_mm, sample_rate_Hz=rate, duration_ms=100).voltages_V)
    own, found = truth.modes().frequencies_Hz, learnt.device.modes().frequencies_Hz
    nominal = an.device("beam").modes().frequencies_Hz
    controlled = learnt.design.numbers["controlled_modes"]
    number = len(controlled)
    assert np.abs(found / own - 1)[:number].max() < 0.1 * np.abs(nominal / own - 1)[:number].max()
    assert learnt.frequency_deviations[:number].max() < 0.005
    # The device was solved with the truth and with what was learnt: the design that was learnt fits the truth better.
    assert an.render(learnt.design).scores["field_error_truncated"] < 0.02


def test_what_the_function_that_plays_raises_ends_the_work():
    def broken(voltages_V, number):
        raise OSError("the laser is off")

    with pytest.raises(OSError, match="the laser is off"):
        an.learn(device="beam", sensors_mm=sensors_mm, play=broken, sample_rate_Hz=rate)
    for wrong in (lambda voltages, number: None, lambda voltages, number: voltages[0], lambda v, n: np.full((3, 9), np.nan)):
        with pytest.raises(an.InputError, match="play"):
            an.learn(device="beam", sensors_mm=sensors_mm, play=wrong, sample_rate_Hz=rate)


def test_recorded_passes_are_learnt_from_as_the_command_does(program, same_files, tmp_path, points):
    first = an.learn(device="beam", sensors_mm=sensors_mm, sample_rate_Hz=rate, duration_ms=100)
    first.save(tmp_path / "pass1")
    signals = signals_of(drifted_beam(), first.voltages_V, rate)
    times = np.arange(signals.shape[1]) / rate
    table = "time_s,velocity_mm_s_1,velocity_mm_s_2,velocity_mm_s_3\n"
    table += "".join(",".join(map(repr, map(float, row))) + "\n" for row in np.vstack([times, 1000 * signals]).T)
    (tmp_path / "pass1" / "recorded.csv").write_text(table)
    options = ["--device", "beam", "--rate", 48000, "--duration-ms", 100, "--sensors", points]
    program("learn", *options, "--recorded", tmp_path / "pass1", "--out", tmp_path / "wanted", "--quiet")
    learnt = an.learn(
        device="beam", sensors_mm=sensors_mm, recorded=[tmp_path / "pass1"], sample_rate_Hz=rate, duration_ms=100
    )
    learnt.save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", learnt_files)


@pytest.fixture(scope="module")
def noise():
    """Silence over the first window, then noise up to 0.42 of the rate on all ceramics, as modes above 0.45 are not
    followed; and what the sensors hear of it on a drifted beam."""
    random = np.random.default_rng(1)
    voltages = random.normal(0, 5, (len(an.device("beam").modes().ceramics), 3 * int(rate)))
    spectrum = np.fft.rfft(voltages)
    spectrum[:, np.fft.rfftfreq(voltages.shape[1]) > 0.42] = 0
    voltages = np.fft.irfft(spectrum, voltages.shape[1])
    voltages[:, : int(1.35 * rate)] = 0
    signals = signals_of(drifted_beam(), voltages, rate)
    return voltages, signals + random.normal(0, 0.01 * signals.std(axis=1)[:, None], signals.shape)


def test_a_drift_is_followed_from_arrays(noise):
    voltages, signals = noise
    followed = an.follow("beam", voltages_V=voltages, signals=signals, sample_rate_Hz=rate, sensors_mm=sensors_mm)
    assert followed.states[0] == "silent" and followed.states[-1] == "following"
    own, nominal = drifted_beam().modes().frequencies_Hz, an.device("beam").modes().frequencies_Hz
    # Modes above 0.45 of the sample rate are not followed.
    modes = (nominal < 0.45 * rate).sum()
    assert followed.frequency_changes_ppm.shape == (len(followed.times_s), modes)
    wanted = 1e6 * np.log(own / nominal)[:modes]
    heard = followed.frequency_deviations_ppm[-1] < 20
    assert heard.sum() >= 3
    assert np.abs(followed.frequency_changes_ppm[-1] - wanted)[heard].max() < 60
    assert followed.common_ppm[-1] == pytest.approx(wanted[heard].mean(), abs=60)
    assert followed.numbers["common_ppm"] == followed.common_ppm[-1]
    assert followed.plot().axes[0].get_xlabel() == "time, s" and followed._repr_png_().startswith(b"\x89PNG")


def test_a_drift_writes_what_the_command_line_writes(program, same_files, tmp_path, points, noise):
    voltages, signals = noise
    folder = tmp_path / "tuesday"
    folder.mkdir()
    full_scale = an.device("beam").to_dict()["limits"].get("full_scale_V", 150)
    write_wave(folder / "voltages.wav", voltages / full_scale, int(rate))
    table = "time_s,velocity_mm_s_1,velocity_mm_s_2,velocity_mm_s_3\n"
    times = np.arange(signals.shape[1]) / rate
    table += "".join("%.9g,%.9g,%.9g,%.9g\n" % tuple(row) for row in np.vstack([times, 1000 * signals]).T)
    (folder / "recorded.csv").write_text(table)
    program("follow", "beam", "--recorded", folder, "--sensors", points, "--out", tmp_path / "wanted", "--quiet")
    followed = an.follow("beam", folder, sensors_mm=sensors_mm)
    followed.save(tmp_path / "made")
    same_files(tmp_path / "wanted", tmp_path / "made", ["device.json", "drift.csv", "report.html", "summary.json"])
    assert followed.device.to_dict() == json.loads((tmp_path / "wanted" / "device.json").read_text())


@pytest.mark.parametrize(
    "call",
    [
        lambda: an.sensors(count=0),
        lambda: an.sensors(count=20, candidates=10),
        lambda: an.sensors(frequency_percent=51),
        lambda: an.learn(sensors_mm=[]),
        lambda: an.learn(sensors_mm=[float("nan")]),
        lambda: an.learn(sensors_mm=[(1, 2, 3)]),
        lambda: an.learn(sensors_mm=[0], idle_ceramics=[99]),
        lambda: an.learn(sensors_mm=[0], idle_ceramics=[-1]),
        lambda: an.learn(sensors_mm=[0], simulate=True, passes=0),
        lambda: an.learn(sensors_mm=[0], simulate=True, recorded=["missing"]),
        lambda: an.learn(sensors_mm=[0], recorded=["missing"]),
        lambda: an.learn(sensors_mm=[0], sample_rate_Hz=1),
        lambda: an.follow("beam"),
        lambda: an.follow("beam", "missing", sensors_mm=[0]),
        lambda: an.follow("beam", "missing", sample_rate_Hz=48000),
        lambda: an.follow("beam", voltages_V=np.zeros((1, 9)), signals=np.zeros((1, 9)), sample_rate_Hz=48000),
        lambda: an.follow(
            "beam", voltages_V=np.zeros((1, 9)), signals=np.zeros((1, 9)), sample_rate_Hz=48000, sensors_mm=[0]
        ),
        lambda: an.follow("beam", "missing", sensors_mm=[0], window_s=61),
        lambda: an.learn(sensors_mm=[0], distortion_percent=51),
    ],
)
def test_bad_input_is_refused_in_one_sentence(call):
    with pytest.raises(an.InputError) as error:
        call()
    assert str(error.value) and "\n" not in str(error.value)
