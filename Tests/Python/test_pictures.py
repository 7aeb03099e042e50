"""Values show themselves as pictures."""

import struct

import numpy as np
import pytest

import antinode as an


def size(png):
    """Width and height of a PNG file (ISO/IEC 15948, section 11.2.2)."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n" and png[12:16] == b"IHDR"
    return struct.unpack(">II", png[16:24])


@pytest.fixture(scope="module")
def values():
    beam = an.render()
    plate = an.design("glass-centre", "glass-148x210")
    return [an.device("staple"), an.device("glass-148x210"), an.device("beam").modes(), beam, beam.design, plate]


def test_each_value_shows_itself_in_a_notebook(values):
    for value in values:
        assert size(value._repr_png_())[0] == 760


def test_size_and_scale_are_as_asked(values):
    assert size(values[3].png(width=400, height=300, scale=2)) == (800, 600)
    assert size(values[3].voltages_png(width=500))[0] == 500


def test_themes_differ_and_one_is_kept(values):
    device = values[0]
    light = device.png()
    an.set_theme("dark")
    try:
        assert device._repr_png_() == device.png(theme="dark") != light
    finally:
        an.set_theme("light")
    assert device._repr_png_() == light


def test_figures_of_matplotlib_have_the_values(values):
    pytest.importorskip("matplotlib")
    rendered = values[3]
    lines = rendered.plot().axes[0].lines
    assert [line.get_label() for line in lines] == ["wanted", "represented", "reached"]
    assert np.array_equal(lines[2].get_ydata(), rendered.reached_field_m_s * 1e3)
    for value in values:
        assert value.plot().axes[0].get_xlabel() == "x, mm"
