"""What a script that plays relies on: the model and the program answer alike, and nothing is silent."""

import gc
import math
import threading
import time

import antinode as an
import pytest
from antinode._player import _Listener


@pytest.fixture(scope="module")
def simulated():
    with an.Player("staple", "demonstrator", audio="simulated") as player:
        player.prepare({"left": {"x_mm": -24}, "weak": {"x_mm": 24, "peak_velocity_mm_s": 20}})
        yield player


def test_prepared_places_say_what_a_render_says(simulated):
    scores = an.render(an.focus("demonstrator", x_mm=-24), "staple", sample_rate_Hz=48000).scores
    left = simulated.prepared["left"]
    assert left.volts == scores["peak_voltage_V"]
    assert left.level_dB_SL == scores["felt"]["targets"][0]["level_dB"]
    assert left.focus_s == 0.025


def test_a_level_becomes_an_amplitude(simulated):
    left = simulated.prepared["left"]
    played = simulated.play("left", level_dB_SL=left.level_dB_SL - 20)
    assert math.isclose(played.amplitude, 0.1, rel_tol=1e-9)
    assert math.isclose(played.volts, 0.1 * left.volts, rel_tol=1e-9)
    assert not played.limited
    above = simulated.play("left", level_dB_SL=left.level_dB_SL + 6)
    assert above.limited and above.amplitude == 1 and above.level_dB_SL == left.level_dB_SL


def test_a_place_is_prepared_for_a_level(simulated):
    with an.Player("staple", "demonstrator", audio="simulated") as player:
        made = player.prepare({"felt": {"x_mm": -24, "peak_level_dB_SL": 20}})["felt"]
    assert abs(made.level_dB_SL - 20) < 0.05
    assert made.volts < simulated.prepared["left"].volts
    with pytest.raises(an.InputError, match="one of them"):
        an.focus(peak_velocity_mm_s=30, peak_level_dB_SL=20)


def test_half_the_velocity_is_6_dB_less(simulated):
    strong = an.Player("staple", "demonstrator", audio="simulated").prepare({"weak": {"x_mm": 24, "peak_velocity_mm_s": 40}})
    assert math.isclose(strong["weak"].level_dB_SL - simulated.prepared["weak"].level_dB_SL, 20 * math.log10(2), abs_tol=1e-6)


def test_times_are_those_of_the_monotonic_clock(simulated):
    at = time.monotonic() + 1
    played = simulated.play("left", at=at)
    assert played.onset == at
    assert math.isclose(played.focus - played.onset, 0.025)


@pytest.mark.parametrize(
    "call, sentence",
    [
        (lambda p: p.play("right"), "'right': was not prepared; allowed: left, weak"),
        (lambda p: p.play("left", amplitude=2), "amplitude: is 2; allowed: 0 to 1"),
        (lambda p: p.play("left", amplitude=1, level_dB_SL=3), "amplitude: stands beside level_dB_SL; allowed: one of them"),
        (lambda p: p.prepare({"far": {"x_mm": 1000}}), "outside the surface"),
    ],
)
def test_refusals(simulated, call, sentence):
    with pytest.raises(an.InputError) as refused:
        call(simulated)
    assert sentence in str(refused.value)


def test_nobody_who_answers_is_said():
    pytest.importorskip("liblo")
    with pytest.raises(an.InputError, match="no program answers"):
        an.Player("staple", port=9, timeout_s=0.2)


class Program:
    """Answers as the standalone program does."""

    def __init__(self, liblo, strays=0):
        self.heard, self.strays = [], strays
        self.listener = _Listener(liblo, self.take)
        self.server = self.listener.server

    def take(self, path, arguments, types, source):
        if not arguments:
            return None
        *rest, name = arguments
        self.heard.append((path, rest))
        say = lambda answer, *values: self.server.send(source, "/antinode/" + answer, name, *values)  # noqa: E731
        if path.endswith("status"):
            say("status", "device", "staple", "solving", False, "armed", True, "rate_Hz", ("d", 48000.0))
            for _ in range(self.strays):
                say("accepted", path)
        elif path.endswith("prepare"):
            say("accepted", path)
            say("designed", rest[0], ("d", 12.0), ("d", 0.99), ("d", 26.0), ("d", 0.025), ("d", 0.03))
        elif path.endswith("play"):
            if rest[0] == "held":
                return say("refused", "/antinode/play: the outputs are not armed")
            now = time.time()
            say("playing", rest[0], ("h", 480), ("h", 1680), ("d", now), ("d", now + 0.025))
            say("finished", rest[0], ("d", 6.0), ("h", 3), ("h", 0), "finished")
        else:
            say("accepted", path)
        return None


def test_the_program_is_spoken_to():
    liblo = pytest.importorskip("liblo")
    program = Program(liblo)
    try:
        with an.Player("staple", "demonstrator", port=program.server.port) as player:
            assert player.prepare({"left": {"x_mm": -24}, "held": {"x_mm": 24}})["left"].level_dB_SL == 26
            before = time.monotonic()
            played = player.play("left", level_dB_SL=20)
            assert before - 0.1 <= played.onset <= time.monotonic()
            assert (played.onset_sample, played.focus_sample) == (480, 1680)
            assert math.isclose(played.amplitude, 10 ** (-6 / 20))
            assert played.limited  # A limiter held 3 samples.
            assert not played.stopped and played.duration == 0.03
            with pytest.raises(an.InputError, match="not armed"):
                player.play("held")
            player.stop()
        paths = [path for path, _ in program.heard]
        assert paths.count("/antinode/prepare") == 2
        assert "/antinode/stop" in paths
    finally:
        program.listener.close()


def test_a_player_closes_while_messages_arrive():
    program = Program(pytest.importorskip("liblo"), strays=50)
    try:
        for _ in range(10):
            player = an.Player("staple", "demonstrator", port=program.server.port)
            player.close()
            player.close()  # Twice is once.
    finally:
        program.listener.close()


def test_a_player_that_nobody_closes_leaves_no_thread():
    program = Program(pytest.importorskip("liblo"))
    try:
        before = set(threading.enumerate())
        player = an.Player("staple", "demonstrator", port=program.server.port)
        (listening,) = set(threading.enumerate()) - before
        del player
        gc.collect()
        listening.join(60)
        assert not listening.is_alive()
    finally:
        program.listener.close()
