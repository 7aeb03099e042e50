"""What sensors tell: where to listen, a focus that is learnt from its plays, a drift that is followed."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Callable, Iterable, Optional, Union

from . import _antinode
from ._checks import within
from ._designs import Design, Folder
from ._documents import Device, Focus, Source, device as _make_device, device_for, device_of, focus_of
from ._pictures import Pictured, Reported, Style
from ._places import Probe, place_pairs
from ._progress import Progress, shown
from .errors import InputError

if TYPE_CHECKING:
    from ._antinode import Floats


class Sensors(Reported):
    """Places where N sensors tell most. Made by :func:`antinode.sensors`."""

    def __init__(self, core: _antinode.Sensors) -> None:
        self._core: _antinode.Sensors = core

    def __repr__(self) -> str:
        return f"<antinode.Sensors: {len(self.bits)} places, {self.bits[-1]:.1f} bits>"

    @property
    def places_mm(self) -> Floats:
        """N x 2: x and y, mm, the most telling place first: ``sensors_mm`` of :func:`antinode.learn`. Of an idle ceramic its
        middle."""
        return self._core.places_mm

    @property
    def idle_ceramics(self) -> list[int]:
        """N: which ceramic each sensor is, counted from 1; 0: it is a place."""
        return [sensor.get("idle_ceramic", 0) for sensor in self.numbers["sensors"]]

    @property
    def bits(self) -> Floats:
        """N: what the first one, two... of them tell together, bits."""
        return self._core.bits

    @property
    def random_bits(self) -> float:
        """What as many sensors at random places tell, bits: the median."""
        return self._core.random_bits

    @property
    def candidates_mm(self) -> Floats:
        """N_c x 2: x and y of the places that were compared, mm."""
        return self._core.candidates_mm

    @property
    def candidate_bits(self) -> Floats:
        """N_c and more: what one sensor alone tells there, then what each idle ceramic tells, bits. A view."""
        return self._core.candidate_bits

    @property
    def numbers(self) -> dict[str, Any]:
        """All of ``summary.json``."""
        numbers: dict[str, Any] = json.loads(self._core.numbers)
        return numbers

    def save(self, folder: Folder) -> None:
        """Writes the folder of ``antinode sensors``: ``sensors.csv``, ``candidates.csv``, ``summary.json``, ``report.html``.

        Raises:
            InputError: the folder cannot be written.
        """
        self._core.save(os.fspath(folder))

    def plot(self) -> Any:
        """What one sensor tells by its place, with the chosen places, as a Matplotlib figure."""
        from ._plots import plot_sensors

        return plot_sensors(self)


def sensors(
    focus: Union[Source, Focus] = "demonstrator",
    device: Union[None, Source, Device] = None,
    *,
    count: int = 2,
    idle_ceramics: Iterable[int] = (),
    candidates: int = 1000,
    frequency_percent: float = 0.5,
    damping_percent: float = 10.0,
    participation_percent: float = 5.0,
    snr_dB: float = 40.0,
    sample_rate_Hz: float = 96000.0,
    duration_ms: float = 250.0,
    cache: bool = True,
    progress: Progress = None,
) -> Sensors:
    """Chooses where sensors tell most of the modes that a focus plays, as ``antinode sensors``.

    Args:
        focus: :func:`antinode.focus`, or what that takes.
        device: :func:`antinode.device`, or what that takes; None: the one that the focus names, else ``staple``.
        count: how many sensors, 1 to 100.
        idle_ceramics: ceramics that are not driven and may be among the sensors, counted from 1 as the channels are.
        candidates: about how many places are compared, in square cells, 1 to 100000.
        frequency_percent, damping_percent, participation_percent: how far each mode may be off the device: standard
            deviations, 0 to 50 %.
        snr_dB: signal-to-noise ratio at an average place, -20 to 300 dB.
        sample_rate_Hz: 8000 to 2000000 Hz.
        duration_ms: of the play, 1 to 10000 ms.
        cache: False: the device is solved without the user's cache.
        progress: a function of what is being done and its share, 0 to 1; True: a bar of tqdm where it is installed.

    Returns:
        :class:`Sensors`: ``places_mm``, ``bits``, ``save(folder)``.

    Raises: as :func:`antinode.design`.

    Source: Docs/Theory.md, section 7.8.
    """
    within("count", count, 1, 100)
    within("candidates", candidates, 1, 100000)
    _check_deviations(frequency_percent, damping_percent, participation_percent)
    within("snr_dB", snr_dB, -20, 300)
    within("duration_ms", duration_ms, 1, 10000)
    request = _antinode.SensorRequest()
    request.count = count
    request.idle_ceramics = list(idle_ceramics)
    request.candidates = candidates
    request.frequency_percent = frequency_percent
    request.damping_percent = damping_percent
    request.participation_percent = participation_percent
    request.snr_dB = snr_dB
    request.sample_rate_Hz = sample_rate_Hz
    request.duration_ms = duration_ms
    request.cache = cache
    wanted = focus_of(focus)
    with shown(progress) as show:
        return Sensors(_antinode.Sensors.make(wanted._core, device_for(wanted, device)._core, request, show))


def _check_deviations(
    frequency: Optional[float], damping: Optional[float], participation: Optional[float]
) -> None:
    within("frequency_percent", frequency, 0, 50)
    within("damping_percent", damping, 0, 50)
    within("participation_percent", participation, 0, 50)


class Learnt(Pictured):
    """A focus that was improved by recordings of its plays: N_m modes. Made by :func:`antinode.learn`."""

    def __init__(self, core: _antinode.Learnt) -> None:
        self._core = core
        self._numbers: Optional[dict[str, Any]] = None

    def __repr__(self) -> str:
        errors = ", ".join(f"{each['estimated_field_error_percent']:.2g}" for each in self.passes)
        return f"<antinode.Learnt '{self.design.focus}': field errors {errors or 'none'} %>"

    @property
    def design(self) -> Design:
        """What to play from now on; :func:`antinode.render` plays it on the device as it was learnt."""
        return Design(self._core.design)

    @property
    def device(self) -> Device:
        """The device as it was learnt; a drawn one stays one."""
        return _make_device(json.loads(self._core.device))

    @property
    def voltages_V(self) -> Floats:
        """N_b x N_s: what to play next, V."""
        return self._core.voltages_V()

    @property
    def passes(self) -> list[dict[str, float]]:
        """The plays in their order: estimated_field_error_percent; surprise_of_noise, what the model of then did not
        predict; surprise_of_noise_nominal, what the device that was given does not; latency_ms, as it was given or found."""
        passes: list[dict[str, float]] = self.numbers["passes"]
        return passes

    @property
    def ceramics(self) -> list[dict[str, Any]]:
        """What was learnt of each ceramic, empty before the first play: name; distortion_percent, its cubic distortion at
        its largest voltage of the last play, above 0 where it moves more than in proportion;
        distortion_deviation_percent, the standard deviation that is left of it."""
        ceramics: list[dict[str, Any]] = self.numbers["ceramics"]
        return ceramics

    @property
    def is_accepted(self) -> bool:
        """Whether what was learnt is used; else ``design`` is one that was played, and ``refusal`` says why."""
        return bool(self.numbers["is_accepted"])

    @property
    def refusal(self) -> str:
        """Why what was learnt is not used, a sentence; empty where it is."""
        return str(self.numbers["refusal"])

    @property
    def warning(self) -> str:
        """Why what is used may still be wrong, a sentence; empty where nothing is known against it."""
        return str(self.numbers["warning"])

    @property
    def frequency_deviations(self) -> Floats:
        """N_m: relative standard deviations of the frequencies that are left. A view; empty before the first play."""
        return self._core.frequency_deviations

    @property
    def damping_deviations(self) -> Floats:
        """N_m: relative standard deviations of the damping ratios that are left. A view; empty before the first play."""
        return self._core.damping_deviations

    @property
    def numbers(self) -> dict[str, Any]:
        """All of ``summary.json``."""
        if self._numbers is None:
            self._numbers = json.loads(self._core.numbers)
        return self._numbers

    def save(self, folder: Folder) -> None:
        """Writes the folder of ``antinode learn``: ``voltages.wav``, ``design.json``, ``device.json``, ``learnt.csv``,
        ``summary.json``, ``report.html``.

        Raises:
            InputError: the folder cannot be written.
        """
        self._core.save(os.fspath(folder))

    def _draw(self, style: Style) -> bytes:
        return self._core.design.png(style)

    def plot(self) -> Any:
        """The estimated field error by pass as a Matplotlib figure."""
        from ._plots import plot_passes

        return plot_passes(self)


Play = Callable[["Floats", int], Any]


def learn(
    focus: Union[Source, Focus] = "demonstrator",
    device: Union[None, Source, Device] = None,
    *,
    sensors_mm: Iterable[Probe] = (),
    play: Optional[Play] = None,
    recorded: Iterable[Folder] = (),
    simulate: bool = False,
    passes: int = 6,
    enough_percent: float = 0.1,
    seed: int = 1,
    simulated_delay_ms: float = 1.234567,
    simulated_cubic_percent: float = 0.0,
    idle_ceramics: Iterable[int] = (),
    latency_ms: Optional[float] = None,
    longest_latency_ms: float = 30.0,
    snr_dB: float = 40.0,
    sensitivity_mm_s_per_V: float = 0.0,
    input_full_scale_V: float = 1.0,
    frequency_percent: Optional[float] = None,
    damping_percent: Optional[float] = None,
    participation_percent: Optional[float] = None,
    place_mm: float = 2.0,
    distortion_percent: float = 2.0,
    sample_rate_Hz: float = 96000.0,
    duration_ms: float = 250.0,
    cache: bool = True,
    progress: Progress = None,
) -> Learnt:
    """Improves a focus from recordings of its plays, as ``antinode learn``: learns the modes, designs it again.

    Give one of ``play``, ``recorded`` and ``simulate``; with none of them the design is made that is to be played first.

    Args:
        focus: :func:`antinode.focus`, or what that takes.
        device: :func:`antinode.device`, or what that takes; None: the one that the focus names, else ``staple``.
        sensors_mm: places of the velocity sensors, ``[24, (24, 10)]``.
        play: a function that plays ``voltages_V`` (N_b x N_s, V, not to be written into) and records meanwhile. It gets
            the number of the pass (from 0) too, and gives an array, N x samples: velocities at the sensors, m/s, then
            the currents of idle ceramics, A.
        recorded: folders of earlier passes with ``recorded.csv`` or ``recorded.wav`` in them, in their order.
        simulate: plays on a simulated bench whose device is off as the deviations below say.
        passes: how often ``play`` or the simulated bench plays at most, 1 to 20.
        enough_percent: estimated field error of a play after which no more is played, 0 to 100 %.
        seed, simulated_delay_ms, simulated_cubic_percent: of the simulated bench: its device and noise, its latency,
            the cubic distortion of its ceramics.
        idle_ceramics: ceramics that are not driven and whose currents are heard, counted from 1 as the channels are.
        latency_ms: of recordings and of ``play``, 0 to 200 ms; None: it is looked for.
        longest_latency_ms: the longest that is looked for, 0 to 200 ms.
        snr_dB: signal-to-noise ratio of the sensors, -20 to 300 dB.
        sensitivity_mm_s_per_V, input_full_scale_V: the scale of ``recorded.wav``.
        frequency_percent, damping_percent, participation_percent: how far each mode may be off the device: standard
            deviations, 0 to 50 %; None: by where the modes come from.
        place_mm: how far each sensor may be beside its place along x and y: a standard deviation, 0 to 50 mm.
        distortion_percent: how far the cubic distortion of each ceramic at its largest voltage may be off 0: a standard
            deviation, 0 to 50 %; 0: ceramics are linear.
        sample_rate_Hz: of voltages and signals, 8000 to 2000000 Hz.
        duration_ms: of each play, 1 to 10000 ms.
        cache: False: the device is solved without the user's cache.
        progress: a function of what is being done and its share, 0 to 1; True: a bar of tqdm where it is installed.

    Returns:
        :class:`Learnt`: ``design``, ``device``, ``passes``, ``voltages_V``, ``save(folder)``.

    Raises: as :func:`antinode.design`; what ``play`` raises.

    Source: Docs/Theory.md, section 7.6.
    """
    folders = [os.fspath(folder) for folder in recorded]
    if sum((play is not None, bool(folders), simulate)) > 1:
        raise InputError("play: is given with recorded or simulate; allowed: one of them")
    within("passes", passes, 1, 20)
    within("seed", seed, 0, 2**63 - 1)
    within("simulated_delay_ms", simulated_delay_ms, 0, 200)
    within("simulated_cubic_percent", simulated_cubic_percent, -20, 20)
    within("enough_percent", enough_percent, 0, 100)
    within("latency_ms", latency_ms, 0, 200)
    within("longest_latency_ms", longest_latency_ms, 0, 200)
    within("snr_dB", snr_dB, -20, 300)
    _check_deviations(frequency_percent, damping_percent, participation_percent)
    within("place_mm", place_mm, 0, 50)
    within("distortion_percent", distortion_percent, 0, 50)
    within("duration_ms", duration_ms, 1, 10000)
    places = place_pairs("sensors_mm", sensors_mm)
    idle = list(idle_ceramics)
    if not places and not idle:
        raise InputError("sensors_mm: are none; allowed: places, idle_ceramics or both")
    options = _antinode.LearnOptions()
    options.recorded = folders
    options.simulate = simulate
    options.passes = passes
    options.enough_percent = enough_percent
    options.seed = seed
    options.simulated_delay_ms = simulated_delay_ms
    options.simulated_cubic_percent = simulated_cubic_percent
    options.idle_ceramics = idle
    options.latency_ms = latency_ms
    options.longest_latency_ms = longest_latency_ms
    options.snr_dB = snr_dB
    options.sensor = _antinode.SensorScale(sensitivity_mm_s_per_V, input_full_scale_V)
    options.frequency_percent = frequency_percent
    options.damping_percent = damping_percent
    options.participation_percent = participation_percent
    options.place_mm = place_mm
    options.distortion_percent = distortion_percent
    options.sample_rate_Hz = sample_rate_Hz
    options.duration_ms = duration_ms
    options.cache = cache
    wanted = focus_of(focus)
    played_on = device_for(wanted, device)
    with shown(progress) as show:
        return Learnt(_antinode.Learnt.make(wanted._core, played_on._core, options, places, play, show))


class Followed(Reported):
    """How a device drifted: N windows of a recording, N_m modes. Made by :func:`antinode.follow`."""

    def __init__(self, core: _antinode.Followed) -> None:
        self._core: _antinode.Followed = core

    def __repr__(self) -> str:
        numbers = self.numbers
        return f"<antinode.Followed: {numbers['common_ppm']:.1f} ppm in the end, {numbers['last_state']}>"

    @property
    def device(self) -> Device:
        """The device as it is in the end; a drawn one stays one."""
        return _make_device(json.loads(self._core.device))

    @property
    def times_s(self) -> Floats:
        """N: the ends of the windows, s from the beginning of the recording."""
        return self._core.times_s

    @property
    def states(self) -> list[str]:
        """N: 'following'; 'silent', where too little was played; 'lost', where the signals were not explained."""
        return self._core.states

    @property
    def reasons(self) -> list[str]:
        """N: why a window is lost, a sentence; else empty."""
        return self._core.reasons

    @property
    def common_ppm(self) -> Floats:
        """N: by how much all frequencies are off the device together, ppm."""
        return self._core.common_ppm

    @property
    def frequency_changes_ppm(self) -> Floats:
        """N x N_m: by how much each frequency is off the device, ppm."""
        return self._core.frequency_changes_ppm

    @property
    def frequency_deviations_ppm(self) -> Floats:
        """N x N_m: standard deviations of these, ppm."""
        return self._core.frequency_deviations_ppm

    @property
    def unexplained_percent(self) -> Floats:
        """N: what the model does not explain beyond the noise, % of the signals."""
        return self._core.unexplained_percent

    @property
    def jumps_percent(self) -> Floats:
        """N: the jump of all frequencies that had to be searched for, %; 0: none."""
        return self._core.jumps_percent

    @property
    def numbers(self) -> dict[str, Any]:
        """All of ``summary.json``."""
        numbers: dict[str, Any] = json.loads(self._core.numbers)
        return numbers

    def save(self, folder: Folder) -> None:
        """Writes the folder of ``antinode follow``: ``drift.csv``, ``device.json``, ``summary.json``, ``report.html``.

        Raises:
            InputError: the folder cannot be written.
        """
        self._core.save(os.fspath(folder))

    def plot(self) -> Any:
        """The common change of all frequencies over time as a Matplotlib figure."""
        from ._plots import plot_drift

        return plot_drift(self)


def follow(
    device: Union[Source, Device],
    recorded: Optional[Folder] = None,
    *,
    voltages_V: Any = None,
    signals: Any = None,
    sample_rate_Hz: Optional[float] = None,
    sensors_mm: Iterable[Probe] = (),
    idle_ceramic: int = 0,
    latency_ms: float = 0.0,
    snr_dB: float = 40.0,
    sensitivity_mm_s_per_V: float = 0.0,
    input_full_scale_V: float = 1.0,
    drift_percent: float = 0.5,
    scatter_percent: float = 0.1,
    damping_percent: float = 10.0,
    gain_percent: float = 5.0,
    jump_percent: float = 2.0,
    feedthrough: Optional[float] = None,
    window_s: float = 1.0,
    memory_s: float = 0.3,
    cache: bool = True,
    progress: Progress = None,
) -> Followed:
    """Follows the drift of a device while whatever is played on it is recorded, as ``antinode follow``.

    Args:
        device: as it was before the drift: :func:`antinode.device`, or what that takes.
        recorded: a folder with ``voltages.wav`` and with ``recorded.csv`` or ``recorded.wav``; or give the three arrays
            below.
        voltages_V: N_b x N_s: what was played, V.
        signals: N x N_s: velocities at the sensors, m/s, then the current of the idle ceramic.
        sample_rate_Hz: of both, 8000 to 2000000 Hz.
        sensors_mm: places of the velocity sensors, ``[24, (24, 10)]``.
        idle_ceramic: a ceramic that is not driven and whose current is heard, counted from 1 as the channels are; 0:
            none.
        latency_ms: of the recording, 0 to 200 ms.
        snr_dB: signal-to-noise ratio of the sensors, -20 to 300 dB.
        sensitivity_mm_s_per_V, input_full_scale_V: the scale of ``recorded.wav``.
        drift_percent, scatter_percent: standard deviations of what all frequencies share, and of each beside it, 0 to
            10 %.
        damping_percent, gain_percent: of each damping ratio, and of what a sensor hears of each mode, 0 to 50 %.
        jump_percent: the largest jump of all frequencies that is searched for, 0 to 10 %.
        feedthrough: standard deviation of what sensors hear of each voltage's slope, in their unit per V/s, 0 to 1;
            None: as much as of the modes above those of the model.
        window_s: what is compared at once, 0 to 60 s.
        memory_s: for how long the slowest mode remembers, 0 to 10 s.
        cache: False: the device is solved without the user's cache.
        progress: a function of what is being done and its share, 0 to 1; True: a bar of tqdm where it is installed.

    Returns:
        :class:`Followed`: ``times_s``, ``common_ppm``, ``device``, ``save(folder)``.

    Raises:
        InputError: something that was given is not allowed, or what was recorded does not fit the device.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Theory.md, section 7.7.
    """
    within("latency_ms", latency_ms, 0, 200)
    within("snr_dB", snr_dB, -20, 300)
    for name, value, most in (
        ("drift_percent", drift_percent, 10),
        ("scatter_percent", scatter_percent, 10),
        ("damping_percent", damping_percent, 50),
        ("gain_percent", gain_percent, 50),
        ("jump_percent", jump_percent, 10),
        ("window_s", window_s, 60),
        ("memory_s", memory_s, 10),
    ):
        within(name, value, 0, most)
    within("feedthrough", feedthrough, 0, 1)
    request = _antinode.FollowRequest()
    request.idle_ceramic = idle_ceramic
    request.latency_ms = latency_ms
    request.snr_dB = snr_dB
    request.drift_percent = drift_percent
    request.scatter_percent = scatter_percent
    request.damping_percent = damping_percent
    request.gain_percent = gain_percent
    request.jump_percent = jump_percent
    request.feedthrough = feedthrough
    request.window_s = window_s
    request.memory_s = memory_s
    request.cache = cache
    places = place_pairs("sensors_mm", sensors_mm)
    before = device_of(device)._core
    arrays = [each is not None for each in (voltages_V, signals, sample_rate_Hz)]
    if recorded is None and not all(arrays) or recorded is not None and any(arrays):
        raise InputError("recorded: allowed: a folder, or voltages_V with signals and sample_rate_Hz")
    scale = _antinode.SensorScale(sensitivity_mm_s_per_V, input_full_scale_V)
    with shown(progress) as show:
        if recorded is not None:
            folder = os.fspath(recorded)
            return Followed(_antinode.Followed.of_folder(before, request, places, folder, scale, show))
        assert sample_rate_Hz is not None
        within("sample_rate_Hz", sample_rate_Hz, 8000, 2e6)
        return Followed(
            _antinode.Followed.of_signals(before, request, places, sample_rate_Hz, voltages_V, signals, show)
        )
