"""Modes as arrays: views of the memory of the model, the numbers of the command line."""

import gc
import json
import math

import numpy as np
import pytest

import antinode as an


@pytest.fixture(scope="module")
def glass():
    return an.device("glass-148x210").modes()


def test_arrays_of_300_modes_lie_on_the_memory_of_the_model(glass):
    addresses = glass._addresses()
    assert len(glass) == 300
    for name, address in addresses.items():
        array = getattr(glass, name)
        assert array.__array_interface__["data"][0] == address, name
        assert not array.flags.owndata


def test_arrays_cannot_be_written(glass):
    for name in (*glass._addresses(), "frequencies_Hz", "masses_kg"):
        array = getattr(glass, name)
        with pytest.raises(ValueError):
            array[0] = 0
        with pytest.raises(ValueError):
            array.flags.writeable = True


def test_an_array_keeps_the_model_alive():
    shapes = an.device("beam").modes(5).shapes
    kept = shapes.copy()
    gc.collect()
    # What lies where freed memory would be reused soon.
    others = [np.full(shapes.shape, math.nan) for _ in range(50)]
    assert np.array_equal(shapes, kept)
    del others


def test_modes_are_those_of_the_command_line(program):
    for name in ("staple", "glass-148x210"):
        listed = json.loads(program("modes", name, "--json"))["modes"]
        modes = an.device(name).modes()
        assert list(modes.frequencies_Hz) == [mode["frequency_Hz"] for mode in listed]
        assert list(modes.damping_ratios) == [mode["damping_ratio"] for mode in listed]
        assert modes.participation.tolist() == [mode["participation_per_V"] for mode in listed]


def test_tables_are_those_of_the_command_line(program, tmp_path):
    program("modes", "beam", "--csv", tmp_path / "wanted.csv", "--uff", tmp_path / "wanted.uff")
    modes = an.device("beam").modes()
    modes.to_csv(tmp_path / "made.csv")
    modes.to_universal_file(tmp_path / "made.uff")
    assert (tmp_path / "made.csv").read_bytes() == (tmp_path / "wanted.csv").read_bytes()
    assert (tmp_path / "made.uff").read_bytes() == (tmp_path / "wanted.uff").read_bytes()


def test_shapes_are_orthonormal_by_the_masses_of_the_points(glass):
    """Docs/Theory.md, section 1: the integral of m phi_k phi_l is 1 for k = l, else 0; all of the plate is its surface."""
    gram = glass.shapes[:, :50].T @ (glass.masses_kg[:, None] * glass.shapes[:, :50])
    assert np.abs(gram - np.eye(50)).max() < 1e-3


def test_shapes_at_a_point_are_those_of_the_point(glass):
    x, y = glass.points_m[1234] * 1e3
    assert np.allclose(glass.shapes_at(x, y), glass.shapes[1234], rtol=0, atol=1e-9 * np.abs(glass.shapes).max())


def test_complex_modes_have_imaginary_parts():
    mode = {"damping_ratio": 0.01, "participation_per_V": [1, 2], "participation_imaginary_per_V": [0.1, 0.2]}
    modes = an.device(
        {
            "schema": "antinode.device/1",
            "name": "measured",
            "kind": "modal",
            "points_mm": [[0, 0], [10, 0], [20, 0]],
            "weights_kg": [0.01, 0.01, 0.01],
            "covers_whole_body": False,
            "modes": [
                {"frequency_Hz": 100, "shape": [1, 2, 3], "shape_imaginary": [0.1, 0.2, 0.3], **mode},
                {"frequency_Hz": 200, "shape": [3, -1, 2], "shape_imaginary": [0.3, 0, -0.3], **mode},
            ],
            "limits": {"voltage_V": 100},
        }
    ).modes()
    assert modes.shapes.tolist() == [[1, 3], [2, -1], [3, 2]]
    assert modes.shapes_imaginary.tolist() == [[0.1, 0.3], [0.2, 0], [0.3, -0.3]]
    assert modes.participation.tolist() == [[1, 2], [1, 2]]
    assert modes.participation_imaginary.tolist() == [[0.1, 0.2], [0.1, 0.2]]
    assert not modes.shapes_imaginary.flags.writeable
    real = an.device("beam").modes(3)
    assert real.shapes_imaginary is None and real.participation_imaginary is None
