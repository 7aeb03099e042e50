"""Plays prepared places: on the standalone program, by OSC, or on the model of the surface."""

from __future__ import annotations

import json
import os
import queue
import shutil
import socket
import subprocess
import tempfile
import threading
import time
import weakref
from dataclasses import dataclass
from typing import Any, Mapping, Optional, Union

from . import _antinode
from ._documents import Device, Focus, Source, device_of, focus_of
from ._documents import focus as make_focus
from .errors import InputError


@dataclass(frozen=True)
class Prepared:
    """What a prepared place needs and gives.

    Attributes:
        volts: peak voltage at an amplitude of 1, V.
        captured: how much of the wanted field the controlled modes hold, 0 to 1.
        level_dB_SL: what a fingertip feels there at an amplitude of 1, dB above its threshold.
        focus_s: from the trigger to the focus, s.
        end_s: from the trigger to the end, s.
    """

    volts: float
    captured: float
    level_dB_SL: float
    focus_s: float
    end_s: float


@dataclass(frozen=True)
class Played:
    """What was played.

    Attributes:
        onset: when the first sample leaves the device, s, on the clock of ``time.monotonic``.
        focus: when the focus falls, s, on the same clock.
        onset_sample, focus_sample: the same in samples of the audio device, counted from the start of the program.
        volts: peak voltage of this stimulus, V.
        level_dB_SL: what a fingertip feels at the place.
        amplitude: of the prepared stimulus, 0 to 1.
        limited: whether the wanted level was above what was prepared, or a limiter held samples.
        stopped: whether it was stopped before its end.
        duration: s, from the onset to the end.
    """

    onset: float
    focus: float
    onset_sample: int
    focus_sample: int
    volts: float
    level_dB_SL: float
    amplitude: float
    limited: bool
    stopped: bool
    duration: float


class Player:
    """Prepares places and plays them; use it in a ``with`` statement, which ends and silences it.

    >>> with an.Player("phone", "phone-thumb", audio="simulated") as player:
    ...     player.prepare({"left": {"x_mm": 38, "y_mm": 30}})
    ...     played = player.play("left", level_dB_SL=-10)

    Args:
        device: that vibrates, as :func:`antinode.device` takes it.
        focus: what places are made of; :meth:`prepare` changes its keys.
        audio: 'simulated': the model of the surface, without hardware and without a program; the type of an audio
            device ('JACK', 'ALSA'): starts the standalone program with it, armed; None: speaks to the program that
            runs, which plays its own device and is armed by its user.
        audio_device: a name from ``antinode-standalone --list-devices``; None: the first one.
        port: UDP port of the program.
        options: further options of the program, for example ``["--marker-output", "9"]``.
        timeout_s: how long to wait for an answer; for a design ten times as long.

    Raises:
        InputError: the device or the focus is not allowed, or the program does not start or answer.

    Source: Docs/Manual/remote.md.
    """

    def __init__(
        self,
        device: Union[Source, Device] = "staple",
        focus: Union[Source, Focus] = "demonstrator",
        *,
        audio: Optional[str] = None,
        audio_device: Optional[str] = None,
        port: int = 9000,
        options: Union[list[str], tuple[str, ...]] = (),
        timeout_s: float = 5,
    ) -> None:
        self._device, self._focus, self._timeout = device_of(device), focus_of(focus), timeout_s
        self._prepared: dict[str, Prepared] = {}
        self._out: Union[_Model, _Program] = (
            _Model(self._device) if audio == "simulated" else _Program(self._device, audio, audio_device, port, options, timeout_s)
        )

    def __enter__(self) -> Player:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<Player: {self._device.name}, prepared: {', '.join(self._prepared) or 'nothing'}>"

    def close(self) -> None:
        """Stops what plays, and ends the program that it has started."""
        self._out.close()

    @property
    def prepared(self) -> dict[str, Prepared]:
        """What was prepared, by name."""
        return dict(self._prepared)

    def prepare(self, stimuli: Mapping[str, Mapping[str, Any]]) -> dict[str, Prepared]:
        """Designs stimuli and waits for their designs.

        Args:
            stimuli: keys of a focus by name, as :func:`antinode.focus` takes them:
                ``{"left": {"x_mm": 38, "y_mm": 30}}``; or ``{"click": {"waveforms": "clicks.json"}}``, the file of
                waveforms for :func:`antinode.perform`.

        Returns:
            :class:`Prepared` by name.

        Raises:
            InputError: a key or value is not allowed, or there is no design.
        """
        made = {}
        for name, keys in stimuli.items():
            if "waveforms" in keys:
                made[name] = self._out.prepare_waveforms(name, os.fspath(keys["waveforms"]))
            else:
                made[name] = self._out.prepare(name, make_focus(self._focus, **keys))
        self._prepared.update(made)
        return made

    def play(
        self,
        name: str,
        *,
        level_dB_SL: Optional[float] = None,
        amplitude: Optional[float] = None,
        at: Optional[float] = None,
        wait: bool = True,
    ) -> Played:
        """Plays a prepared stimulus.

        Args:
            name: of the stimulus.
            level_dB_SL: what a fingertip is to feel; above the prepared level that one is played, and ``limited`` says so.
            amplitude: in its place, 0 to 1; neither: 1.
            at: when its first sample is to leave the device, s, on the clock of ``time.monotonic``; None: now.
            wait: for its end; else the limiter is not known of.

        Raises:
            InputError: no such stimulus, an amplitude beyond 0 to 1, outputs that are not armed.
        """
        if name not in self._prepared:
            raise InputError(f"'{name}': was not prepared; allowed: {', '.join(self._prepared) or 'nothing yet'}")
        if level_dB_SL is not None and amplitude is not None:
            raise InputError("amplitude: stands beside level_dB_SL; allowed: one of them")
        prepared = self._prepared[name]
        wanted = 1.0 if amplitude is None else amplitude
        if level_dB_SL is not None:
            wanted = 10 ** ((level_dB_SL - prepared.level_dB_SL) / 20)
        if level_dB_SL is None and not 0 <= wanted <= 1:
            raise InputError(f"amplitude: is {wanted:g}; allowed: 0 to 1")
        return self._out.play(name, prepared, min(wanted, 1.0), wanted > 1, at, wait)

    def stop(self) -> None:
        """Fades out what plays, and cancels what waits."""
        self._out.stop()

    def status(self) -> dict[str, Any]:
        """Device, focus, whether it is armed and muted, sample rate, a warning or ''."""
        return self._out.status()


def _level(prepared: Prepared, amplitude: float) -> float:
    from math import log10

    return prepared.level_dB_SL + 20 * log10(amplitude) if amplitude > 0 else float("-inf")


class _Model:
    """Plays on the model of the surface: what would be felt, at once."""

    rate = 48000

    def __init__(self, device: Device) -> None:
        self._device, self._begun = device, time.monotonic()

    def prepare(self, name: str, focus: Focus) -> Prepared:
        scores = _antinode.render(focus, self._device, sample_rate_Hz=self.rate).scores
        level, focus_s = scores["felt"]["targets"][0]["level_dB"], scores["focus_time_ms"] / 1000
        return Prepared(scores["peak_voltage_V"], scores["captured"], level, focus_s, focus_s)

    def prepare_waveforms(self, name: str, file: str) -> Prepared:
        scores = _antinode.perform(file, self._device, sample_rate_Hz=self.rate).scores
        level = scores["fingers"][0]["level_dB_SL"]
        return Prepared(scores["peak_voltage_V"], 1.0, level, 0.0, 0.0)

    def play(self, name: str, prepared: Prepared, amplitude: float, above: bool, at: Optional[float], wait: bool) -> Played:
        onset = time.monotonic() if at is None else at
        sample = round((onset - self._begun) * self.rate)
        return Played(
            onset, onset + prepared.focus_s, sample, sample + round(prepared.focus_s * self.rate),
            amplitude * prepared.volts, _level(prepared, amplitude), amplitude, above, False, prepared.end_s,
        )  # fmt: skip

    def stop(self) -> None:
        pass

    def status(self) -> dict[str, Any]:
        return {"device": self._device.name, "armed": True, "muted": False, "rate_Hz": float(self.rate), "warning": ""}

    def close(self) -> None:
        pass


def _end(process: "subprocess.Popen[bytes]") -> None:
    """Ends a program that was started, also where nobody closes the player."""
    if process.poll() is None:
        process.terminate()
        try:
            process.wait(10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


class _Listener:
    """An OSC server on its own thread.

    Not liblo.ServerThread: its stop() waits for the thread without releasing the interpreter, which a message that has just
    arrived needs, so that both wait for ever.
    """

    def __init__(self, liblo: Any, take: Any) -> None:
        self.server = liblo.Server()
        self.server.add_method(None, None, take)
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._listen, daemon=True)
        self._thread.start()

    def _listen(self) -> None:
        while not self._closing.is_set():
            self.server.recv(50)
        self.server.free()

    def closed(self) -> bool:
        return self._closing.is_set()

    def end(self) -> None:
        """Does not wait: garbage may be collected on the listening thread itself."""
        self._closing.set()

    def close(self) -> None:
        self.end()
        self._thread.join()


class _Program:
    """Speaks OSC to the standalone program, which it may have started."""

    def __init__(
        self,
        device: Device,
        audio: Optional[str],
        audio_device: Optional[str],
        port: int,
        options: Union[list[str], tuple[str, ...]],
        timeout_s: float,
    ) -> None:
        try:
            import liblo  # type: ignore[import]
        except ImportError:
            raise InputError("Player: needs liblo; install Debian's python3-liblo, or use audio='simulated'") from None

        self._timeout, self._number = timeout_s, 0
        self._answers: dict[str, "queue.Queue[tuple[str, list[Any]]]"] = {}
        self._process: Optional["subprocess.Popen[bytes]"] = None
        self._folder: Optional["tempfile.TemporaryDirectory[str]"] = None
        self._address = liblo.Address("127.0.0.1", port)
        self._listener = _Listener(liblo, self._take)
        weakref.finalize(self, self._listener.end)  # Also where nobody closes the player.
        try:
            if audio is not None:
                self._start(device, audio, audio_device, port, options)
            self._await_program()
        except BaseException:
            self.close()
            raise

    def _start(
        self, device: Device, audio: str, audio_device: Optional[str], port: int, options: Union[list[str], tuple[str, ...]]
    ) -> None:
        program = os.environ.get("ANTINODE_STANDALONE") or shutil.which("antinode-standalone")
        if program is None:
            raise InputError("Player: antinode-standalone is not on the PATH; set ANTINODE_STANDALONE to its file")
        self._folder = tempfile.TemporaryDirectory()
        file = os.path.join(self._folder.name, "device.json")
        with open(file, "w", encoding="utf-8") as out:
            json.dump(device.to_dict(), out)
        command = [program, "--headless", "--arm", "--no-settings", "--type", audio, "--instrument", file,
                   "--osc-port", str(port), "--tuio-port", "0"]  # fmt: skip
        self._errors = open(os.path.join(self._folder.name, "errors"), "w+b")
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
            try:
                free.bind(("127.0.0.1", port))
            except OSError:
                raise InputError(f"Player: port {port} is in use; end that program, or give another port") from None
        self._process = subprocess.Popen(
            command + (["--device", audio_device] if audio_device else []) + list(options),
            stdout=subprocess.DEVNULL,
            stderr=self._errors,
        )
        self._end = weakref.finalize(self, _end, self._process)

    def _await_program(self) -> None:
        """A program that was started first opens its device and solves it."""
        end = time.monotonic() + (60 if self._process else self._timeout)
        while True:
            try:
                status = self._status(0.5)
                if self._process is None or (status["armed"] and not status["solving"] and status["rate_Hz"] > 0):
                    return
            except InputError:
                pass
            if self._process is not None and self._process.poll() is not None:
                self._errors.seek(0)
                raise InputError(f"Player: {self._errors.read().decode('utf-8', 'replace').strip() or 'the program has ended'}")
            if time.monotonic() > end:
                raise InputError("Player: no program answers; start antinode-standalone, or give audio='JACK' or 'simulated'")
            time.sleep(0.05)

    def _take(self, path: str, arguments: list[Any]) -> None:
        answers = self._answers.get(arguments[0]) if arguments else None
        if answers is not None:
            answers.put((path.rpartition("/")[2], arguments[1:]))

    def _say(self, command: str, *arguments: Any) -> str:
        self._number += 1
        name = f"#python{self._number}"
        self._answers[name] = queue.Queue()
        self._listener.server.send(self._address, f"/antinode/{command}", *arguments, name)
        return name

    def _hear(self, name: str, wanted: str, seconds: float) -> list[Any]:
        """The arguments of the answer that is waited for."""
        end = time.monotonic() + seconds
        while True:
            try:
                kind, arguments = self._answers[name].get(timeout=max(0.0, end - time.monotonic()))
            except queue.Empty:
                self._answers.pop(name, None)
                raise InputError(f"Player: no answer within {seconds:g} s") from None
            if kind == wanted:
                return arguments
            if kind in ("refused", "finished"):
                self._answers.pop(name, None)
                raise InputError(arguments[0] if kind == "refused" else f"'{arguments[0]}': was stopped before it began")

    def prepare(self, name: str, focus: Focus) -> Prepared:
        return self._designed(self._say("prepare", name, json.dumps(focus.to_dict())))

    def prepare_waveforms(self, name: str, file: str) -> Prepared:
        return self._designed(self._say("waveforms", name, os.path.abspath(file)))

    def _designed(self, waiting: str) -> Prepared:
        _, *made = self._hear(waiting, "designed", 10 * self._timeout)
        self._answers.pop(waiting, None)
        return Prepared(*made)

    def play(self, name: str, prepared: Prepared, amplitude: float, above: bool, at: Optional[float], wait: bool) -> Played:
        to_system = time.time() - time.monotonic()
        when = [("d", at + to_system)] if at is not None else []
        waiting = self._say("play", name, ("d", amplitude), *when)
        ahead = max(0.0, at - time.monotonic()) if at is not None else 0.0
        _, onset_sample, focus_sample, onset, focus = self._hear(waiting, "playing", self._timeout + ahead)
        limited, stopped = above, False
        if wait:
            _, _, held, clamped, outcome = self._hear(waiting, "finished", self._timeout + prepared.end_s)
            limited, stopped = above or held > 0 or clamped > 0, outcome == "stopped"
        self._answers.pop(waiting, None)
        return Played(
            onset - to_system, focus - to_system, onset_sample, focus_sample,
            amplitude * prepared.volts, _level(prepared, amplitude), amplitude, limited, stopped, prepared.end_s,
        )  # fmt: skip

    def stop(self) -> None:
        waiting = self._say("stop")
        self._hear(waiting, "accepted", self._timeout)
        self._answers.pop(waiting, None)

    def _status(self, seconds: float) -> dict[str, Any]:
        waiting = self._say("status")
        try:
            listed = self._hear(waiting, "status", seconds)
        finally:
            self._answers.pop(waiting, None)
        return dict(zip(listed[::2], listed[1::2]))

    def status(self) -> dict[str, Any]:
        return self._status(self._timeout)

    def close(self) -> None:
        if self._listener.closed():
            return
        if self._process is not None:
            self._end()
        else:
            self._listener.server.send(self._address, "/antinode/stop")
        self._listener.close()
        if self._folder is not None:
            self._errors.close()
            self._folder.cleanup()
