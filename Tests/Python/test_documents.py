"""Devices and focuses from names, files and dicts."""

import json
import pickle

import numpy as np
import pytest

import antinode as an


def test_a_device_is_the_same_from_a_name_a_file_and_a_dict(tmp_path):
    named = an.device("staple")
    named.save(tmp_path / "mine.json")
    for other in (an.device(tmp_path / "mine.json"), an.device(named.to_dict()), an.device(named)):
        assert other.to_dict() == named.to_dict()
        assert np.array_equal(other.modes().frequencies_Hz, named.modes().frequencies_Hz)


def test_keys_and_changes_are_those_of_set(program, tmp_path):
    changed = an.device("staple", thickness_mm=1.5, changes={"limits.voltage_V": 20})
    assert changed.to_dict()["thickness_mm"] == 1.5
    assert changed.to_dict()["limits"]["voltage_V"] == 20
    table = json.loads(program("modes", "staple", "--set", "device.thickness_mm=1.5", "--json"))
    assert list(changed.modes().frequencies_Hz) == [mode["frequency_Hz"] for mode in table["modes"]]


def test_a_path_without_ending_is_a_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    an.device("beam").save(tmp_path / "without-ending")
    import pathlib

    assert an.device(pathlib.Path("without-ending")).name == an.device("beam").name


def test_numbers_of_numpy_are_numbers():
    assert an.focus(x_mm=np.float64(-24)).to_dict()["targets"][0]["x_mm"] == -24
    assert an.focus(probes_mm=np.zeros((2, 2))).to_dict()["probes_mm"] == [[0, 0], [0, 0]]


def test_arguments_of_a_focus_are_keys_of_its_file():
    focus = an.focus(
        x_mm=10,
        width_mm=20,
        peak_velocity_mm_s=30,
        shape="gaussian",
        focus_time_ms=15,
        method="least_voltage",
        voltage_limit_V=40,
        brake_duration_ms=20,
    ).to_dict()
    target = focus["targets"][0]
    assert (target["x_mm"], target["width_mm"], target["peak_velocity_mm_s"], target["shape"]) == (10, 20, 30, "gaussian")
    assert focus["focus_time_ms"] == 15
    assert focus["allocation"]["method"] == "least_voltage" and focus["allocation"]["voltage_limit_V"] == 40
    assert focus["transients"]["brake_duration_ms"] == 20


@pytest.mark.parametrize("make", [an.device, an.focus, an.waveforms])
def test_what_is_no_document_is_refused_in_a_sentence(make):
    for wrong in ("no-such-name", "missing.json", {}, {"schema": "other/1"}, {"a": {1}}, 3, None, b"staple"):
        with pytest.raises(an.InputError) as error:
            make(wrong)
        assert "\n" not in str(error.value)


def test_a_document_travels_to_another_process_with_its_name(tmp_path):
    unnamed = {key: value for key, value in an.focus().to_dict().items() if key != "name"}
    (tmp_path / "at-24.json").write_text(json.dumps(unnamed))
    focus = an.focus(tmp_path / "at-24.json")
    for value in (focus, an.device("beam"), an.waveforms()):
        other = pickle.loads(pickle.dumps(value))
        assert type(other) is type(value) and other.name == value.name
        assert {**value.to_dict(), "name": value.name} == other.to_dict()
    assert focus.name == an.focus(focus, x_mm=0).name == "at-24"


def test_a_focus_is_designed_for_the_device_that_it_names(tmp_path):
    """As `--device` leaves it open; the name of a file begins at the folder of the focus, wherever it is kept later."""
    assert an.design("glass-centre").device == an.device("glass-148x210").name
    (tmp_path / "mine").mkdir()
    an.device("staple", name="my staple").save(tmp_path / "mine" / "device.json")
    an.focus(device="./device.json").save(tmp_path / "mine" / "focus.json")
    focus = an.focus(tmp_path / "mine" / "focus.json")
    focus.save(tmp_path / "kept.json")
    for each in (focus, an.focus(focus, x_mm=-24), pickle.loads(pickle.dumps(focus)), an.focus(tmp_path / "kept.json")):
        assert an.design(each).device == "my staple"
    assert an.design(focus, "beam").device == an.device("beam").name


def test_names_are_the_embedded_ones():
    assert "staple" in an.names() and "demonstrator" in an.names("focus") and "three-fingers" in an.names("waveforms")
