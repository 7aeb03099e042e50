"""Experiments on people: procedures, order, the table of trials that outlives a crash, and the psychometric function."""

import collections
import dataclasses
import json
import math
import os
import pathlib
import random
import re
import signal
import subprocess
import sys
import tracemalloc
import types

import numpy as np
import pytest

import antinode as an
from antinode import experiment as ex
from antinode._psychometric import weibull

PLACES = {"left": {"x_mm": -24}, "middle": {"x_mm": 0}, "right": {"x_mm": 24}}
# Of simulated observers; 100 for the numbers of Docs/Results.md.
OBSERVERS = int(os.environ.get("ANTINODE_OBSERVERS", 5))
# Of a day in simulated time; 28800 for those.
DAY = int(os.environ.get("ANTINODE_TRIALS", 800))


@pytest.fixture(autouse=True)
def synchronised(monkeypatch):
    """How often each file was to be brought to the disk; only programs that are killed wait for it."""
    times = collections.Counter()
    monkeypatch.setattr("os.fsync", lambda file: times.update([file]))
    return times


class Bench:
    """A player, and a clock that moves only where somebody waits."""

    def __init__(self, as_object=False, limit_dB=math.inf):
        self.now, self.prepared, self.played = 5000.0, None, []
        self.as_object, self.limit_dB = as_object, limit_dB

    def prepare(self, stimuli):
        self.prepared = stimuli

    def play(self, name, *, level_dB_SL):
        self.played.append((name, level_dB_SL))
        level = min(level_dB_SL, self.limit_dB)
        said = {"onset": self.now + 0.01, "duration": 0.1, "volts": 10 ** (level / 20), "limited": level < level_dB_SL}
        return types.SimpleNamespace(**said) if self.as_object else said

    def clock(self):
        return self.now

    def wait(self, seconds):
        self.now += seconds

    def run(self, task, folder, **keywords):
        return ex.run(self, task, folder, clock=self.clock, wait=self.wait, **keywords)


def table(folder):
    return list(ex.rows(folder))


def without_times(folder):
    return [{key: value for key, value in row.items() if key not in ("onset", "response_time")} for row in table(folder)]


def yes_no(procedure, **keywords):
    return ex.Detection(places={"left": {"x_mm": -24}}, procedure=procedure, **keywords)


# Procedures


def played_levels(procedure, answers):
    """The levels of the first track of a procedure that gets these answers."""
    (track, *_) = procedure.tracks(False, 0.01, random.Random(1))
    levels = []
    for is_positive in answers:
        levels.append(track.level())
        track.update(levels[-1], is_positive)
    return levels, track


def test_constant_stimuli_have_each_level_once_in_each_block():
    levels, track = played_levels(ex.ConstantStimuli([5, 10, 20], repeats=4), [True] * 12)
    assert track.is_finished and all(sorted(levels[i : i + 3]) == [5, 10, 20] for i in range(0, 12, 3))
    assert len({tuple(levels[i : i + 3]) for i in range(0, 12, 3)}) > 1


def test_a_staircase_steps_by_levitts_rule():
    """By hand: each answer counts until the first reversal, then two positive ones in a row; the step halves at reversals."""
    rule = ex.Staircase(20, steps_dB=(8, 4, 2), down=2, reversals=4, minimum_dB=0)
    answers = [True, True, False, True, True, False, True, True, False]
    levels, track = played_levels(rule, answers)
    assert levels == [20, 12, 4, 8, 8, 6, 8, 8, 6] and track.is_finished
    assert played_levels(rule, [True] * 5)[0] == [20, 12, 4, 0, 0]
    assert not played_levels(dataclasses.replace(rule, trials=10), answers)[1].is_finished


@pytest.mark.parametrize("up, down, share", [(1, 1, 0.5), (1, 2, math.sqrt(0.5)), (1, 3, 0.5 ** (1 / 3)), (2, 1, 1 - math.sqrt(0.5))])
def test_a_staircase_goes_to_levitts_share(up, down, share):
    """Levitt 1971, table 1. 4000 trials in steps of 1 dB; the mean over so many is within 0.03 in share."""
    (track,) = ex.Staircase(20, 1, up=up, down=down, reversals=1000000).tracks(False, 0.01, random.Random(1))
    numbers, levels = random.Random(2), []
    for _ in range(4000):
        levels.append(track.level())
        track.update(levels[-1], numbers.random() < weibull(levels[-1], 20, 2, 0, 0))
    assert weibull(np.mean(levels[100:]), 20, 2, 0, 0) == pytest.approx(share, abs=0.03)


def test_weibulls_function_is_that_of_questplus():
    function = pytest.importorskip("questplus").psychometric_function.weibull
    levels = np.arange(1, 40.0)
    for scale in ("dB", "linear"):
        theirs = function(intensity=levels, threshold=20, slope=2, lower_asymptote=0.25, lapse_rate=0.03, scale=scale)
        assert np.allclose(weibull(levels, 20, 2, 0.25, 0.03, scale == "linear"), theirs.values.ravel(), atol=1e-12)


def quest_plus_errors(guess_rate, trials, slope):
    """Errors of the threshold of simulated observers at 20 dB SL, dB."""
    quest = ex.QuestPlus(trials, slopes=[slope], guess_rates=[guess_rate], lapse_rates=[0.0 if guess_rate > 0.1 else 0.001])
    errors = []
    for seed in range(OBSERVERS):
        numbers = random.Random(seed)
        (track,) = quest.tracks(False, guess_rate, numbers)
        while not track.is_finished:
            level = track.level()
            track.update(level, numbers.random() < weibull(level, 20, slope, guess_rate if guess_rate > 0.1 else 0, 0))
        errors.append(track.posterior_mean["threshold"] - 20)
    return np.array(errors)


@pytest.mark.parametrize("guess_rate, slope", [(0.01, 2), (0.5, 2)])
def test_quest_plus_finds_a_threshold_as_well_as_answers_allow(guess_rate, slope):
    """The bound of Cramer and Rao: u = 10 ** (slope (level - threshold) / 20), guess rate g, share p; an answer informs
    of the threshold by (dp/dt) ** 2 / (p (1 - p)), at the best level. At slope 2 and 40 trials, a standard deviation of
    0.85 dB of yes/no and 1.27 dB of 2AFC: 76 % and 57 % of observers within 1 dB are the most that can be had."""
    pytest.importorskip("questplus")
    u, g = np.linspace(0.01, 6, 1000), guess_rate if guess_rate > 0.1 else 0
    information = (slope * math.log(10) / 20) ** 2 * u**2 * (1 - g) * np.exp(-u) / (1 - (1 - g) * np.exp(-u))
    bound = 1 / math.sqrt(40 * information.max())
    errors = quest_plus_errors(guess_rate, 40, slope)
    print(f"within 1 dB: {np.mean(abs(errors) <= 1):.0%}, RMS {np.sqrt(np.mean(errors**2)):.2f} dB, bound {bound:.2f} dB")
    assert np.sqrt(np.mean(errors**2)) < 1.7 * bound  # As few observers scatter by a quarter, and the first trials search.


def test_without_questplus_a_sentence_says_what_is_missing(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "questplus", None)
    with pytest.raises(an.InputError, match="python3-questplus"):
        Bench().run(yes_no(ex.QuestPlus()), tmp_path / "out")
    assert not (tmp_path / "out").exists()


# Trials


def test_a_detection_writes_a_table_as_bids_has_it(tmp_path, synchronised):
    bench = Bench()
    task = yes_no(ex.ConstantStimuli([10, 30], repeats=10), catch=0.3, jitter_s=(0.5, 1.5), interval_s=0.8)
    count = bench.run(task, tmp_path, answer=ex.SimulatedObserver(20, 3))
    rows, sidecar = table(tmp_path), json.loads((tmp_path / "events.json").read_text())
    assert len(rows) == count and bench.prepared == task.places
    assert max(synchronised.values()) >= count
    assert list(rows[0])[:3] == ["onset", "duration", "trial_type"] and set(rows[0]) == set(sidecar) - {"Experiment"}
    assert {key: sidecar[key]["Units"] for key in ("onset", "level", "response_time", "volts")} == {
        "onset": "s", "level": "dB", "response_time": "s", "volts": "V"
    }
    real, catch = ([row for row in rows if (row["trial_type"] == "catch") == is_catch] for is_catch in (False, True))
    assert len(real) == 20 and len(bench.played) == 20 and 3 <= len(catch) <= 17  # 8.6 are expected
    assert [float(row["level"]) for row in real] == [level for _, level in bench.played]
    assert all(row["level"] == row["volts"] == row["limited"] == "n/a" for row in catch)
    assert all(float(row["volts"]) == pytest.approx(10 ** (float(row["level"]) / 20), rel=1e-3) for row in real)
    # Between begins there is the interval and the jitter; the player says 10 ms later.
    gaps = np.diff([float(row["onset"]) for row in rows])
    assert gaps.min() > 1.28 and gaps.max() < 2.32 and np.ptp(gaps) > 0.5 and 0.5 < float(rows[0]["onset"]) < 1.52
    assert all((row["response"] == "yes") == (row["correct"] == "1") for row in real)


def test_everything_follows_from_the_seed(tmp_path):
    task = ex.Detection(places=PLACES, procedure=ex.Staircase([10, 40], reversals=3), catch=0.2, method="2AFC")
    for name, seed in (("a", 1), ("b", 1), ("c", 2)):
        Bench(as_object=name == "b").run(task, tmp_path / name, seed=seed, answer=ex.SimulatedObserver())
    first, again, other = ((tmp_path / name / "events.tsv").read_bytes() for name in "abc")
    times = [[row["onset"] for row in table(tmp_path / name)] for name in "ab"]
    assert np.allclose(*(np.array(each, float) for each in times), atol=0.5)  # Both count from the clock of the computer.
    assert without_times(tmp_path / "a") == without_times(tmp_path / "b") and first != other


def test_staircases_of_all_places_are_interleaved(tmp_path):
    task = ex.Detection(places=PLACES, procedure=ex.Staircase([10, 40], reversals=4))
    Bench().run(task, tmp_path, answer=ex.SimulatedObserver())
    rows = table(tmp_path)
    passes = [tuple(row["track"] for row in rows[i : i + 6]) for i in range(0, 36, 6)]
    assert all(set(each) == set("012345") for each in passes) and len(set(passes)) > 3
    assert len({(row["track"], row["place"]) for row in rows}) == 6
    assert {row["level"] for row in rows[:6]} == {"10.0", "40.0"}


def test_two_intervals_have_the_stimulus_in_either_one_and_last_as_long(tmp_path):
    bench, cues = Bench(), []
    task = yes_no(ex.ConstantStimuli([60], repeats=40), method="2AFC", interval_s=0.7)
    bench.run(task, tmp_path, answer=ex.SimulatedObserver(20), cue=lambda trial, interval: cues.append((interval, bench.now)))
    rows = table(tmp_path)
    assert 8 <= sum(row["interval"] == "1" for row in rows) <= 32 and all(row["correct"] == "1" for row in rows)
    times = np.reshape([now for _, now in cues], (-1, 2))
    assert np.allclose(np.diff(times), 0.7) and [interval for interval, _ in cues] == [1, 2] * 40
    onsets = np.array([float(row["onset"]) for row in rows]) - float(rows[0]["onset"])
    expected = [times[i, int(row["interval"]) - 1] for i, row in enumerate(rows)]
    assert np.allclose(onsets, np.array(expected) - expected[0], atol=1e-3)


@pytest.mark.parametrize("method", ["2AFC", "yes/no"])
def test_a_discrimination_plays_the_reference_and_a_stronger_stimulus(tmp_path, method):
    bench = Bench()
    task = ex.Discrimination(
        places={"left": {}}, reference_dB_SL=25, method=method, procedure=ex.ConstantStimuli([1, 3, 6], repeats=60), catch=0.1
    )
    bench.run(task, tmp_path, answer=ex.SimulatedObserver(3, 1.5, seed=4))
    pairs = [sorted(level for _, level in bench.played[i : i + 2]) for i in range(0, len(bench.played), 2)]
    assert pairs == [[25.0, 25 + (0 if row["level"] == "n/a" else float(row["level"]))] for row in table(tmp_path)]
    found = ex.fit(tmp_path, resamples=50).numbers["functions"]["left"]["threshold_dB"]
    assert found["lower_95"] < 3 < found["upper_95"] and found["upper_95"] - found["lower_95"] < 3


def test_a_localisation_asks_for_one_of_the_places(tmp_path):
    task = ex.Localisation(places=PLACES, procedure=ex.ConstantStimuli([0, 40], repeats=90))
    Bench().run(task, tmp_path, answer=ex.SimulatedObserver(20))
    rows = table(tmp_path)
    assert all({row["place"] for row in rows[i : i + 3]} == set(PLACES) for i in range(0, 180, 3))
    numbers = ex.fit(tmp_path, resamples=0).numbers
    function, confusions = numbers["functions"]["all"], numbers["confusions"]
    assert function["guess_rate"]["value"] == pytest.approx(1 / 3) and function["threshold_dB"]["lower_95"] is None
    assert sum(confusions["left"].values()) == 60 and confusions["left"]["left"] == sum(
        row["place"] == row["response"] == "left" for row in rows
    )
    assert function["positive"][1] > 85 and 20 <= function["positive"][0] <= 55  # Of 90; a third is guessed, a tenth felt.


def test_a_missed_trial_is_played_again_and_not_counted(tmp_path):
    def answer(trial):
        return None if trial.number in (2, 5) else "yes"

    bench = Bench()
    assert bench.run(yes_no(ex.ConstantStimuli([10, 20], repeats=3)), tmp_path, answer=answer) == 8
    rows = table(tmp_path)
    assert rows[1]["response"] == rows[1]["correct"] == "n/a" and rows[2]["level"] == rows[1]["level"]
    numbers = ex.fit(tmp_path, resamples=0).numbers
    assert numbers["missed"] == 2 and numbers["functions"]["left"]["trials"] == [3, 3]


def test_trials_that_a_limit_weakened_are_not_fitted(tmp_path):
    Bench(limit_dB=35).run(yes_no(ex.ConstantStimuli([10, 30, 40], repeats=5)), tmp_path, answer=ex.SimulatedObserver())
    assert [row["limited"] for row in table(tmp_path)].count("1") == 5
    numbers = ex.fit(tmp_path, resamples=0).numbers
    assert numbers["limited"] == 5 and numbers["functions"]["left"]["levels_dB"] == [10, 30]


def test_the_keyboard_takes_choices_their_beginnings_and_numbers(tmp_path, monkeypatch, capsys):
    typed = iter(["", "x", "l", "middle", "3", "4", "2"])
    monkeypatch.setattr("builtins.input", lambda question: next(typed))
    Bench().run(ex.Localisation(places=PLACES, procedure=ex.ConstantStimuli([40], repeats=4)), tmp_path)
    assert [row["response"] for row in table(tmp_path)] == ["left", "middle", "right", "middle"]
    assert "Trial 4" in capsys.readouterr().out


# Crashes


PROGRAM = """
import sys, time
from antinode import experiment as ex

class Player:
    def prepare(self, stimuli): pass
    def play(self, name, *, level_dB_SL):
        return {"onset": time.monotonic(), "volts": 1.0, "limited": False}

observer = ex.SimulatedObserver()

def answer(trial):
    print(trial.number, flush=True)
    time.sleep(float(sys.argv[2]))
    return observer(trial)

task = ex.Detection(
    places={"left": {}, "right": {}}, procedure=ex.PROCEDURE, method="2AFC", catch=0.2, jitter_s=(0, 0.001), interval_s=0)
ex.run(Player(), task, sys.argv[1], seed=7, answer=answer)
"""


@pytest.mark.parametrize("procedure", ["Staircase([10, 40], reversals=6)", "QuestPlus(trials=15, slopes=[2])"])
def test_a_killed_experiment_loses_no_trial_but_the_one_under_way(tmp_path, monkeypatch, procedure):
    if "Quest" in procedure:
        pytest.importorskip("questplus")
    text = PROGRAM.replace("PROCEDURE", procedure)

    def complete(folder):
        monkeypatch.setattr(sys, "argv", ["", folder, "0"])
        exec(compile(text, "program", "exec"), {"__name__": "program"})
        return without_times(folder)

    whole, begun = complete(tmp_path / "whole"), []
    program = [sys.executable, "-c", text]
    for after in (1, 9):
        with subprocess.Popen([*program, tmp_path / "killed", "0.002"], stdout=subprocess.PIPE, text=True) as running:
            for _ in range(after):
                begun.append(int(running.stdout.readline()))
            os.kill(running.pid, signal.SIGKILL)
            begun += [int(line) for line in running.stdout.read().split()]
        rows = without_times(tmp_path / "killed")
        assert begun[-1] - 1 <= len(rows) <= begun[-1] and rows == whole[: len(rows)]
    assert complete(tmp_path / "killed") == whole
    onsets = [float(row["onset"]) for row in table(tmp_path / "killed")]
    assert onsets == sorted(onsets)


def test_a_line_that_a_crash_has_cut_is_played_again(tmp_path):
    task = yes_no(ex.Staircase(30, reversals=3), catch=0.2)
    Bench().run(task, tmp_path / "a", answer=ex.SimulatedObserver())
    Bench().run(task, tmp_path / "b", answer=ex.SimulatedObserver())
    file = tmp_path / "b" / "events.tsv"
    whole = file.read_bytes()
    for length in (len(whole) - 1, len(whole) // 2, 20, 0):
        file.write_bytes(whole[:length])
        Bench().run(task, tmp_path / "b", answer=ex.SimulatedObserver())
        assert without_times(tmp_path / "b") == without_times(tmp_path / "a")


def test_a_finished_experiment_plays_nothing_more(tmp_path):
    task = yes_no(ex.ConstantStimuli([10, 20], repeats=2))
    Bench().run(task, tmp_path, answer=ex.SimulatedObserver())
    before, bench = (tmp_path / "events.tsv").read_bytes(), Bench()
    assert bench.run(task, tmp_path, answer=ex.SimulatedObserver()) == 4
    assert bench.played == [] and (tmp_path / "events.tsv").read_bytes() == before


def test_an_exception_of_the_answer_ends_the_run_and_the_trials_before_it_stay(tmp_path):
    def answer(trial):
        if trial.number == 3:
            raise KeyboardInterrupt
        return "yes"

    task = yes_no(ex.ConstantStimuli([10, 20], repeats=2))
    with pytest.raises(KeyboardInterrupt):
        Bench().run(task, tmp_path, answer=answer)
    assert len(table(tmp_path)) == 2


def test_memory_does_not_grow_with_trials(tmp_path):
    """A day scaled down. A trial that is kept has 1000 bytes or more, a pointer 8; 5 are noise of caches and the allocator."""
    kept = []

    def answer(trial):
        if trial.number in (DAY // 4, DAY):
            kept.append((tracemalloc.get_traced_memory()[0], bench.now))
        return observer(trial)

    observer, bench = ex.SimulatedObserver(), Bench()
    bench.played = collections.deque(maxlen=1)
    task = ex.Detection(places=PLACES, procedure=ex.Staircase([10, 40], trials=DAY // 6), catch=0.1, method="2AFC")
    tracemalloc.start()
    try:
        bench.run(task, tmp_path, answer=answer)
    finally:
        tracemalloc.stop()
    (first, _), (last, end) = kept
    print(f"{(last - first) / (0.75 * DAY):.2f} bytes per trial in {(end - 5000) / 3600:.1f} h")
    assert abs(last - first) / (0.75 * DAY) < 5


def test_quest_plus_keeps_no_history():
    pytest.importorskip("questplus")
    _, track = played_levels(ex.QuestPlus(trials=3, slopes=[2]), [True, False, True])
    assert track.is_finished and track._quest.stim_history == track._quest.resp_history == []


# The psychometric function


def test_a_fit_finds_the_observer_with_the_interval_that_answers_allow(tmp_path):
    """The standard deviation of the threshold by Fisher's information at these levels, where all else is known; unknown
    slope, lapse and guess rates widen it somewhat."""
    levels = np.arange(5, 40, 5.0)
    task = yes_no(ex.ConstantStimuli(levels, repeats=80), catch=0.2)
    Bench().run(task, tmp_path, answer=ex.SimulatedObserver(20, 2, false_alarm_rate=0.05, lapse_rate=0.02, seed=3))
    fitted = ex.fit(tmp_path, resamples=150)
    found = fitted.numbers["functions"]["left"]
    p, step = weibull(levels, 20, 2, 0.05, 0.02), 1e-4
    derivative = (weibull(levels, 20 + step, 2, 0.05, 0.02) - p) / step
    deviation = 1 / math.sqrt(80 * np.sum(derivative**2 / (p * (1 - p))))
    threshold = found["threshold_dB"]
    assert threshold["value"] == pytest.approx(20, abs=3 * deviation)
    assert 0.9 < (threshold["upper_95"] - threshold["lower_95"]) / (2 * 1.96 * deviation) < 2
    for key, true in (("slope", 2), ("guess_rate", 0.05), ("lapse_rate", 0.02)):
        assert found[key]["lower_95"] <= true <= found[key]["upper_95"], key
    assert fitted.numbers == ex.fit(tmp_path, resamples=150).numbers


def test_a_fit_has_the_largest_likelihood_by_search(tmp_path):
    Bench().run(yes_no(ex.ConstantStimuli([10, 15, 20, 25, 30], repeats=30), method="2AFC"), tmp_path, answer=ex.SimulatedObserver())
    found = ex.fit(tmp_path, resamples=0).numbers["functions"]["left"]

    def loss(*parameters):
        p = np.clip(weibull(np.array(found["levels_dB"]), *parameters), 1e-9, 1 - 1e-9)
        yes, trials = np.array(found["positive"]), np.array(found["trials"])
        return -(yes @ np.log(p) + (trials - yes) @ np.log(1 - p))

    searched = min(
        loss(t, s, 0.5, lapse) for t in np.arange(10, 30, 0.2) for s in np.arange(0.5, 10, 0.1) for lapse in (0, 0.03, 0.06)
    )
    assert loss(*(found[key]["value"] for key in ("threshold_dB", "slope", "guess_rate", "lapse_rate"))) <= searched


def test_a_fit_is_saved_as_json_and_as_a_picture(tmp_path):
    pytest.importorskip("matplotlib"), pytest.importorskip("questplus")
    task = ex.Detection(places=PLACES, procedure=ex.QuestPlus(trials=12, slopes=[2]))
    Bench().run(task, tmp_path, answer=ex.SimulatedObserver({"left": 10, "middle": 20, "right": 30}))
    fitted = ex.fit(tmp_path, resamples=20)
    fitted.save(tmp_path)
    assert json.loads((tmp_path / "psychometric.json").read_text()) == fitted.numbers
    assert (tmp_path / "psychometric.png").read_bytes().startswith(b"\x89PNG")
    assert fitted.plot().axes[0].get_xlabel() == "level, dB SL" and str(fitted).count("threshold") == 3
    means = [fitted.numbers["functions"][place]["quest_plus"]["threshold"] for place in PLACES]
    assert means == sorted(means)


# What is refused


@pytest.mark.parametrize(
    "make, part",
    [
        (lambda: ex.Detection(places={}, procedure=ex.QuestPlus()), "places: is empty"),
        (lambda: ex.Detection(places={"a\tb": {}}, procedure=ex.QuestPlus()), "places: has the name"),
        (lambda: ex.Localisation(places={"left": {}}, procedure=ex.QuestPlus()), "places: is 1"),
        (lambda: yes_no(ex.QuestPlus(), method="3AFC"), "method: is '3AFC'"),
        (lambda: yes_no(ex.QuestPlus(), catch=1), "catch: is 1"),
        (lambda: yes_no(ex.QuestPlus(), jitter_s=(2, 1)), "jitter_s: is 2"),
        (lambda: ex.ConstantStimuli([]), "levels_dB: is empty"),
        (lambda: ex.ConstantStimuli("loud"), "levels_dB: is 'loud'"),
        (lambda: ex.Staircase(20, down=0), "down: is 0"),
        (lambda: ex.QuestPlus(0), "trials: is 0"),
    ],
)
def test_what_cannot_be_run_is_refused_in_a_sentence(make, part):
    with pytest.raises(an.InputError, match="allowed") as refused:
        make()
    assert part in str(refused.value)


def test_what_does_not_fit_the_folder_is_refused(tmp_path):
    task = yes_no(ex.ConstantStimuli([10, 20], repeats=2))
    with pytest.raises(an.InputError, match="allowed: one of run"):
        ex.fit(tmp_path)
    with pytest.raises(an.InputError, match="answer: is 'perhaps'; allowed: yes, no"):
        Bench().run(task, tmp_path, answer=lambda trial: "perhaps")
    with pytest.raises(an.InputError, match="has no answers"):
        ex.fit(tmp_path)
    for other, seed in ((task, 2), (dataclasses.replace(task, catch=0.5), 1)):
        with pytest.raises(an.InputError, match="has another (seed|task)"):
            Bench().run(other, tmp_path, seed=seed, answer=ex.SimulatedObserver())
    Bench().run(yes_no(ex.ConstantStimuli([10], repeats=2)), tmp_path / "one", answer=ex.SimulatedObserver())
    with pytest.raises(an.InputError, match="answers at 1 level"):
        ex.fit(tmp_path / "one")
    difference = ex.Discrimination(places={"left": {}}, reference_dB_SL=20, procedure=ex.QuestPlus())
    pytest.importorskip("questplus")
    with pytest.raises(an.InputError, match="allowed of a discrimination: above 0 dB"):
        Bench().run(difference, tmp_path / "difference")


def test_everything_public_is_described():
    for name in ex.__all__:
        assert getattr(ex, name).__doc__, name


# PsychoPy


class PsychoPy:
    """A stand-in for PsychoPy, which Debian does not have: its functions with the arguments that they have there, and keys."""

    def __init__(self, keys):
        self.keys, self.shown, self.drawn, self.waited, self.closed = keys, [], [], 0.0, False

    def modules(self):
        outer = self

        class Window:
            def __init__(self, size=(800, 600), color=(0, 0, 0), fullscr=None, units=None):
                assert units in ("height", "norm", "pix", "cm", "deg")

            def flip(self):
                outer.shown.append(outer.drawn)
                outer.drawn = []

            def close(self):
                outer.closed = True

        class Drawn:
            def draw(self):
                outer.drawn.append(self)

        class TextStim(Drawn):
            def __init__(self, win, text="Hello World", font="Arial", pos=(0.0, 0.0), color=(1.0, 1.0, 1.0), height=None):
                self.win, self.text, self.pos = win, text, pos

        class Circle(Drawn):
            def __init__(self, win, radius=0.5, edges="circle", pos=(0, 0), lineColor=None, fillColor=None):
                self.win, self.radius, self.pos = win, radius, pos

        def wait_keys(maxWait=math.inf, keyList=None, modifiers=False, timeStamped=False, clearEvents=True):
            key = next(outer.keys)
            assert key in keyList
            return [key]

        def wait(secs, hogCPUperiod=0.2):
            outer.waited += secs

        parts = {
            "visual": types.SimpleNamespace(Window=Window, TextStim=TextStim, Circle=Circle),
            "event": types.SimpleNamespace(waitKeys=wait_keys),
            "core": types.SimpleNamespace(wait=wait),
        }
        return types.SimpleNamespace(**parts)


def test_the_script_for_psychopy_shows_the_places_and_takes_keys(tmp_path, monkeypatch, capsys):
    pytest.importorskip("questplus"), pytest.importorskip("matplotlib")
    keys = iter(["1", "2", "escape", *random.Random(1).choices("1234", k=20)])
    shown = PsychoPy(keys)
    monkeypatch.setitem(sys.modules, "psychopy", shown.modules())
    file = pathlib.Path(__file__).parents[2] / "Docs/Notebooks/psychopy_localisation.py"
    script = {"__name__": "psychopy_localisation"}
    exec(compile(file.read_text(), str(file), "exec"), script)
    with pytest.raises(KeyboardInterrupt):
        script["main"](Bench(), tmp_path, 12)
    assert shown.closed and [row["response"] for row in table(tmp_path)] == ["1", "2"]
    cue, question = shown.shown[:2]
    assert [each.text for each in cue] == ["+"] and question[0].text == "Where was it?"
    assert [each.text for each in question[2::2]] == ["1", "2", "3", "4"] and shown.waited > 2
    assert all(abs(part) < 0.5 - 0.05 for each in question[1:] for part in each.pos)
    bench = Bench()
    script["main"](bench, tmp_path, 12)
    assert 12 <= len(table(tmp_path)) < 20 and set(bench.prepared) == set("1234")
    assert (tmp_path / "psychometric.png").exists() and "threshold" in capsys.readouterr().out


def test_the_programs_of_the_page_run(tmp_path, monkeypatch, capsys):
    pytest.importorskip("questplus"), pytest.importorskip("matplotlib")
    page = (pathlib.Path(__file__).parents[2] / "Docs/Manual/trials.md").read_text()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(ex.run.__kwdefaults__, "wait", lambda seconds: None)
    answers = iter(["yes", "no"] * 50)
    monkeypatch.setattr("builtins.input", lambda question: next(answers))
    names = {"player": Bench()}
    for block in re.findall(r"^```python\n(.*?)^```", page, re.M | re.S):
        short = block.replace("trials=40", "trials=6, slopes=[2]").replace('fit("subject01")', 'fit("subject01", resamples=9)')
        exec(compile(short, "trials.md", "exec"), names)
    assert (tmp_path / "subject01/psychometric.json").exists() and (tmp_path / "rehearsal/events.tsv").exists()
    assert capsys.readouterr().out.count("threshold") == 2
