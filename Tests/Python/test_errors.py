"""Errors are the sentences of the command line."""

import math

import pytest

import antinode as an


@pytest.mark.parametrize(
    "options, call",
    [
        (["no-such-focus"], lambda: an.render("no-such-focus")),
        (["--device", "no-such-device"], lambda: an.render(device="no-such-device")),
        (["--rate", "7999"], lambda: an.render(sample_rate_Hz=7999)),
        (["--rate", "nan"], lambda: an.render(sample_rate_Hz=math.nan)),
        (["--probe", "200"], lambda: an.render(probes_mm=[200])),
        (["--duration-ms", "1"], lambda: an.render(duration_ms=1)),
        (["--set", "focus.targets.7.x_mm=1"], lambda: an.render(an.focus(changes={"targets.7.x_mm": 1}))),
        (["--set", "focus.voltage=1"], lambda: an.render(an.focus(voltage=1))),
        (["--set", "focus.allocation.voltage_limit_V=1"], lambda: an.render(an.focus(voltage_limit_V=1))),
        (["--threshold", "missing.csv"], lambda: an.render(threshold="missing.csv")),
    ],
)
def test_the_sentence_is_that_of_the_command_line(program, tmp_path, options, call):
    printed = program("render", *options, "--out", tmp_path / "none", fails=True)
    with pytest.raises(an.InputError) as error:
        call()
    assert printed == f"antinode: {error.value}\n"


def test_an_input_error_is_a_value_error():
    assert issubclass(an.LimitError, an.InputError) and issubclass(an.InputError, ValueError)


@pytest.mark.parametrize(
    "call",
    [
        lambda: an.design(reconstruction="held"),
        lambda: an.render(repeat_Hz=math.nan),
        lambda: an.render(repeat_Hz=-1),
        lambda: an.render(block_size=0),
        lambda: an.render(duration_ms=math.inf),
        lambda: an.render(duration_ms=1e9),
        lambda: an.render(probes_mm=[(math.nan, 0)]),
        lambda: an.render().save("unused", format="mp3"),
        lambda: an.render().save("unused", figures=["png"]),
        lambda: an.render().save("/dev/null"),
        lambda: an.device("beam").modes(0),
        lambda: an.device("beam").modes(-5),
        lambda: an.device("beam").modes().shapes_at(math.nan),
        lambda: an.device("beam").modes().shapes_at(1e9),
        lambda: an.device("beam").png(width=1),
        lambda: an.device("beam").png(scale=math.nan),
        lambda: an.device("beam").png(theme="blue"),
        lambda: an.set_theme("blue"),
        lambda: an.names("plate"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(call, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(an.InputError) as error:
        call()
    assert str(error.value) and "\n" not in str(error.value)
    assert not list(tmp_path.iterdir()), "nothing is half written"
