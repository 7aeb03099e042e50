"""Waveforms at fingers: the files of the command line, byte by byte."""

import json

import numpy as np
import pytest

import antinode as an

files = ["finger-01.wav", "finger-02.wav", "scores.csv", "summary.json", "voltages.wav"]


def two_fingers(**changes):
    """A click at one finger of the aluminium plate, silence at another one."""
    return {
        "schema": "antinode.waveforms/1",
        "name": "two",
        "tracks": [{"x_mm": 40, "y_mm": 40, "level_um": 1, "signal": {"kind": "click"}, **changes}],
        "silent": [{"x_mm": 140, "y_mm": 80}],
    }


@pytest.fixture(scope="module")
def played():
    """Both, on the plate of the drawing."""
    return an.perform(two_fingers(), "aluminium-200x120")


def test_perform_writes_what_the_command_line_writes(program, same_files, tmp_path):
    waveforms = an.waveforms(two_fingers())
    waveforms.save(tmp_path / "two.json")
    program(
        "perform", tmp_path / "two.json", "--device", "aluminium-200x120", "--no-report", "--out", tmp_path / "wanted"
    )
    performed = an.perform(waveforms, "aluminium-200x120")
    performed.save(tmp_path / "made", report=False)
    same_files(tmp_path / "wanted", tmp_path / "made", files)
    assert len(performed.fingers) == 2
    assert np.abs(performed.voltages_V).max() == pytest.approx(performed.scores["peak_voltage_V"])


def test_the_track_is_reached_and_the_silent_finger_hardly_moves(played):
    wanted, reached = played.wanted_m[:, 0], played.displacements_m[:, played.trigger_sample :]
    count = min(len(wanted), reached.shape[1])
    assert np.abs(reached[0, :count] - wanted[:count]).max() < 0.05 * np.abs(wanted).max()
    assert np.abs(reached[1]).max() < 0.05 * np.abs(wanted).max()
    assert not played.displacements_m.flags.writeable


def test_haptic_content_is_played_at_a_place_with_its_level(program, same_files, tmp_path):
    transient = {"Event": {"Time": 0.01, "EventType": "HapticTransient"}}
    (tmp_path / "tap.ahap").write_text(json.dumps({"Version": 1.0, "Pattern": [transient]}))
    command = ("perform", tmp_path / "tap.ahap", "--device", "aluminium-200x120", "--no-report")
    program(*command, "--at", "40,40", "--level-db-sl", "20", "--out", tmp_path / "wanted")
    content = an.waveforms(tmp_path / "tap.ahap")
    performed = an.perform(content, "aluminium-200x120", at_mm=[(40, 40)], level_dB_SL=20)
    performed.save(tmp_path / "made", report=False)
    same_files(tmp_path / "wanted", tmp_path / "made", ["finger-01.wav", *files[2:]])
    # The default intensity of a transient is 0.75.
    assert performed.scores["fingers"][0]["level_dB_SL"] == pytest.approx(20 + 20 * np.log10(0.75), abs=0.1)
    # The document of the content is waveforms like others.
    document = content.to_dict()
    document["tracks"][0].update(x_mm=40, y_mm=40, level_dB_SL=20)
    assert np.array_equal(an.perform(document, "aluminium-200x120").voltages_V, performed.voltages_V)


def test_a_pass_that_was_recorded_late_is_corrected_like_one_in_time(program, tmp_path, played):
    played.save(tmp_path / "pass", report=False)
    an.waveforms(two_fingers()).save(tmp_path / "two.json")
    # The real plate gives a tenth less; all is recorded 337 samples late.
    recorded = 0.9e6 * played.displacements_m.T

    def errors(late, **settings):
        delayed = np.vstack([np.zeros((late, 2)), recorded])
        times = np.arange(len(delayed)) / played.sample_rate_Hz
        np.savetxt(
            tmp_path / "pass" / "recorded.csv",
            np.column_stack([times, delayed]),
            delimiter=",",
            header="time_s,displacement_um_1,displacement_um_2",
            comments="",
        )
        next_pass = an.perform(two_fingers(), "aluminium-200x120", passes=[tmp_path / "pass"], **settings)
        return next_pass, next_pass.scores["passes"]["errors_dB"][0]

    in_time, error_in_time = errors(0)
    _, error_late = errors(337)
    aligned, error_aligned = errors(337, longest_latency_ms=20)
    assert error_in_time == pytest.approx(-20, abs=0.2)
    assert error_late > -6
    assert aligned.scores["passes"]["latencies_ms"][0] == pytest.approx(1000 * 337 / 48000, abs=0.01)
    assert error_aligned == pytest.approx(error_in_time, abs=0.1)
    assert np.abs(aligned.voltages_V - in_time.voltages_V).max() < 1e-3 * np.abs(in_time.voltages_V).max()
    program(
        *("perform", tmp_path / "two.json", "--device", "aluminium-200x120", "--no-report", "--out", tmp_path / "next"),
        *("--correct", tmp_path / "pass", "--longest-latency-ms", "20"),
    )
    aligned.save(tmp_path / "made", report=False)
    assert (tmp_path / "next" / "voltages.wav").read_bytes() == (tmp_path / "made" / "voltages.wav").read_bytes()


def test_lags_of_amplifiers_are_undone_and_known_where_a_pass_is_corrected(program, tmp_path):
    program(
        *("calibrate", "--device", "aluminium-200x120", "--simulate", "--simulated-bandwidth-khz", "5"),
        *("--rate", "48000", "--resolution-hz", "50", "--out", tmp_path / "calibrated"),
    )
    calibrated = json.loads((tmp_path / "calibrated" / "device.json").read_text())
    plain = {**calibrated, "ceramics": [{k: v for k, v in each.items() if k != "lag"} for each in calibrated["ceramics"]]}

    def corrected(device):
        first = an.perform(two_fingers(), device)
        lag = first.scores.get("lag", {"late_samples": 0, "misfit_percent": 0, "limited_samples": []})
        assert lag["misfit_percent"] < 0.1 and not any(lag["limited_samples"])
        assert first.scores["trigger_sample"] == first.trigger_sample + lag["late_samples"]
        first.save(tmp_path / "pass", report=False)
        # The real plate gives a tenth less; it moves later by what filters and amplifiers take.
        recorded = np.vstack([np.zeros((lag["late_samples"], 2)), 0.9e6 * first.displacements_m.T])
        np.savetxt(
            tmp_path / "pass" / "recorded.csv",
            np.column_stack([np.arange(len(recorded)) / first.sample_rate_Hz, recorded]),
            delimiter=",",
            header="time_s,displacement_um_1,displacement_um_2",
            comments="",
        )
        next_pass = an.perform(two_fingers(), device, passes=[tmp_path / "pass"])
        assert next_pass.scores["passes"]["errors_dB"][0] == pytest.approx(-20, abs=0.2)
        return lag["late_samples"], next_pass.voltages_V

    late, with_lags = corrected(calibrated)
    none_late, without = corrected(plain)
    assert late > 20 and none_late == 0
    assert np.abs(with_lags - without).max() < 0.002 * np.abs(without).max()


def test_a_late_recording_of_another_pass_is_refused_with_its_number(tmp_path, played):
    played.save(tmp_path / "pass", report=False)

    def refusal(columns, device="aluminium-200x120"):
        times = np.arange(played.displacements_m.shape[1]) / played.sample_rate_Hz
        names = ",".join(f"displacement_um_{i + 1}" for i in range(columns.shape[1]))
        table = np.column_stack([times, columns[: len(times)]])
        np.savetxt(tmp_path / "pass" / "recorded.csv", table, delimiter=",", header="time_s," + names, comments="")
        with pytest.raises(an.InputError) as error:
            an.perform(two_fingers(), device, passes=[tmp_path / "pass"], longest_latency_ms=20)
        return str(error.value)

    recorded = 1e6 * played.displacements_m.T
    assert "recorded pass 1: has 1 channels; allowed: 2" in refusal(recorded[:, :1])
    assert "recorded pass 1: is silent" in refusal(0 * recorded)
    assert "recorded pass 1: was played on 8 ceramics, the device has 32" in refusal(recorded, "glass-148x210")


def test_levels_beyond_the_limits_say_what_share_is_within():
    with pytest.raises(an.LimitError) as error:
        an.perform(two_fingers(level_um=3000), "aluminium-200x120", sample_rate_Hz=24000)
    assert 0 < error.value.reachable_share < 1
    assert error.value.minimum_peak_voltage_V is None


def test_bad_settings_are_refused():
    for wrong in ({"sample_rate_Hz": 1}, {"latency_ms": 1000}, {"passes": ["missing"]}, {"threshold": "missing.csv"}, {"longest_latency_ms": 300}):
        with pytest.raises(an.InputError):
            an.perform(two_fingers(), "aluminium-200x120", **wrong)
