"""Errors are the sentences of the command line."""

import copy
import math
import pickle

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
    # The command line names an option, Python a keyword.
    assert printed.split(": ", 2)[2] == str(error.value).split(": ", 1)[1] + "\n"


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


@pytest.mark.parametrize(
    "wrong, right", [({"x_m": 3}, "x_mm"), ({"width": 20}, "width_mm"), ({"focus_time_s": 0.03}, "focus_time_ms")]
)
def test_an_argument_that_is_misspelt_is_named(wrong, right):
    with pytest.raises(an.InputError, match=f"did you mean '{right}'"):
        an.focus(**wrong)


def test_a_limit_that_is_too_low_names_the_way_that_reaches_most():
    with pytest.raises(an.LimitError, match="'least_voltage' reaches"):
        an.render(an.focus(voltage_limit_V=1), "staple")


def test_every_value_shows_what_it_is():
    values = [getattr(an, name) for name in an.__all__ if isinstance(getattr(an, name), type)]
    shown = [value for value in values if not issubclass(value, Exception)]
    assert len(shown) > 15
    assert not [value for value in shown if value.__repr__ is object.__repr__]


@pytest.mark.parametrize(
    "call",
    [
        lambda: an.render(probes_mm="57"),
        lambda: an.render(probes_mm=["5"]),
        lambda: an.place(size_mm="10"),
        lambda: an.place(None),
        lambda: an.excite("beam", seed=3000000000),
        lambda: an.tolerance(seed=2**31),
        lambda: an.learn(simulate=True, sensors_mm=[13], seed=2**65),
    ],
)
def test_what_is_no_number_or_too_large_is_refused(call):
    with pytest.raises((an.InputError, TypeError)) as error:
        call()
    assert "is of type int" not in str(error.value)


def test_arguments_may_be_any_iterables_and_the_defaults_themselves():
    track = {"x_mm": 40, "y_mm": 40, "level_um": 1, "signal": {"kind": "click"}}
    click = {"schema": "antinode.waveforms/1", "name": "click", "tracks": [track]}
    assert an.perform(click, "aluminium-200x120", sample_rate_Hz=24000, sensitivity_mm_s_per_V=0.0).fingers
    excited = an.excite("beam", levels_V=(float(volts) for volts in range(1, 1 + len(an.device("beam").modes().ceramics))))
    assert list(excited.levels_V) == [float(volts) for volts in range(1, 1 + len(excited.ceramics))]


def test_functions_are_pickled_by_their_names_and_values_are_their_own_copies():
    assert pickle.loads(pickle.dumps(an.render)) is an.render
    made = an.design()
    assert copy.copy(made) is made and copy.deepcopy(made) is made
    made.note = "kept"
    assert made.note == "kept"
