"""What is played to measure a device, and what recordings of it say."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Optional, Sequence, Union

from . import _antinode
from ._checks import within, word
from ._designs import Folder
from ._documents import Device, Source, device as _make_device, device_of
from ._pictures import Reported
from .errors import InputError

if TYPE_CHECKING:
    from ._antinode import Complexes, Floats


def excitation_options(
    signal: str,
    sample_rate_Hz: float,
    lowest_frequency_Hz: Optional[float],
    highest_frequency_Hz: Optional[float],
    resolution_Hz: Optional[float],
    periods: int,
    settling_periods: Optional[int],
    levels_V: Sequence[float],
    cache: bool,
) -> _antinode.ExcitationOptions:
    """What excite and measure have in common."""
    word("signal", signal, ("multisine", "sweep", "noise"))
    options = _antinode.ExcitationOptions()
    options.signal = signal
    options.sample_rate_Hz = sample_rate_Hz
    options.lowest_frequency_Hz = lowest_frequency_Hz
    options.highest_frequency_Hz = highest_frequency_Hz
    options.resolution_Hz = resolution_Hz
    options.periods = periods
    options.settling_periods = settling_periods
    options.levels_V = list(levels_V)
    options.cache = cache
    return options


class Excitation:
    """What all ceramics play to measure a device, one after the other: N_b ceramics, N_f lines. Made by
    :func:`antinode.excite`."""

    def __init__(self, core: _antinode.Excitation) -> None:
        self._core = core

    def __repr__(self) -> str:
        return f"<antinode.Excitation of '{self.device}': {len(self.ceramics)} ceramics, {len(self.frequencies_Hz)} lines>"

    @property
    def device(self) -> str:
        """The name of the device."""
        return self._core.device

    @property
    def ceramics(self) -> list[str]:
        """N_b names, in the order in which they play."""
        return self._core.ceramics

    @property
    def sample_rate_Hz(self) -> float:
        """Hz."""
        return self._core.sample_rate_Hz

    @property
    def frequencies_Hz(self) -> Floats:
        """N_f: the lines that are measured, Hz."""
        return self._core.frequencies_Hz

    @property
    def levels_V(self) -> Floats:
        """N_b: the peak voltage of each ceramic, V. A view."""
        return self._core.levels_V

    @property
    def full_scale_V(self) -> float:
        """The voltage of a played sample of 1, V."""
        return self._core.full_scale_V

    @property
    def signal(self) -> Floats:
        """The samples of one ceramic's run without the silence after it, peak 1. A view."""
        return self._core.signal

    @property
    def crest_factor(self) -> float:
        """Peak over effective value of the signal."""
        return self._core.crest_factor

    @property
    def played(self) -> Floats:
        """(N_b + 1) x samples of full scale: all runs, ceramics first, then the sync channel: ``excitation.wav``.

        Raises:
            InputError: it has more than 512 MiB.
        """
        return self._core.played()

    @property
    def numbers(self) -> dict[str, Any]:
        """All of ``excitation.json``."""
        numbers: dict[str, Any] = json.loads(self._core.numbers)
        return numbers

    def save(self, folder: Folder) -> None:
        """Writes the folder of ``antinode excite``: ``excitation.wav``, ``excitation.json``, ``signal.wav``.

        Raises:
            InputError: the folder cannot be written, or there are more than 512 MiB of samples.
        """
        self._core.save(os.fspath(folder))


def excite(
    device: Union[Source, Device],
    *,
    signal: str = "multisine",
    sample_rate_Hz: float = 96000.0,
    lowest_frequency_Hz: Optional[float] = None,
    highest_frequency_Hz: Optional[float] = None,
    resolution_Hz: Optional[float] = None,
    periods: int = 4,
    settling_periods: Optional[int] = None,
    sweep_s: float = 4.0,
    odd: bool = False,
    seed: int = 1,
    levels_V: Sequence[float] = (),
    cache: bool = True,
) -> Excitation:
    """Makes what the ceramics play to measure a device, as ``antinode excite``.

    Args:
        device: :func:`antinode.device`, or what that takes.
        signal: 'multisine', 'sweep' or 'noise'; one ceramic plays it after the other.
        sample_rate_Hz: Hz.
        lowest_frequency_Hz, highest_frequency_Hz: the band, Hz; None: from half the lowest mode to the highest one, at
            most 20 kHz.
        resolution_Hz: the largest spacing of lines, Hz; None: a quarter of the narrowest mode's width.
        periods: that are measured.
        settling_periods: before them; None: until the slowest mode has settled.
        sweep_s: duration of a sweep, s.
        odd: a multisine of odd lines with gaps, which shows distortion.
        seed: of noise and gaps.
        levels_V: the peak voltage of all ceramics, or of each, V; default: a fifth of their limits.
        cache: False: the device is solved without the user's cache.

    Returns:
        :class:`Excitation`: ``played``, ``frequencies_Hz``, ``save(folder)``; :func:`antinode.frf` takes it.

    Raises:
        InputError: something that was given is not allowed.

    Source: Docs/Theory.md, section 8.8.
    """
    within("seed", seed, 0, 2000000000)
    options = excitation_options(
        signal,
        sample_rate_Hz,
        lowest_frequency_Hz,
        highest_frequency_Hz,
        resolution_Hz,
        periods,
        settling_periods,
        levels_V,
        cache,
    )
    options.sweep_s = sweep_s
    options.odd = odd
    options.seed = seed
    return Excitation(_antinode.Excitation.make(device_of(device)._core, options))


class Estimated(Reported):
    """Velocities per volt, or per newton of a hammer: N_f lines, N_p points, N_r references. Made by
    :func:`antinode.frf`."""

    def __init__(self, core: _antinode.Estimated) -> None:
        self._core: _antinode.Estimated = core

    def __repr__(self) -> str:
        lines, points = len(self.frequencies_Hz), len(self.points_m)
        return f"<antinode.Estimated: {lines} lines, {points} points, {len(self.references)} references>"

    @property
    def frequencies_Hz(self) -> Floats:
        """N_f lines, Hz. A view."""
        return self._core.frequencies_Hz

    @property
    def points_m(self) -> Floats:
        """N_p x 2: x and y, m. A view."""
        return self._core.points_m

    @property
    def references(self) -> list[str]:
        """N_r names: ceramics, or the points that the hammer hit."""
        return self._core.references

    def responses(self, reference: int) -> Complexes:
        """N_f x N_p of a reference (from 0): (m/s)/V, or (m/s)/N of a hammer, complex; NaN where it was not measured."""
        within("reference", reference, 0, len(self.references) - 1)
        return self._core.responses(reference)

    def coherence(self, reference: int) -> Floats:
        """N_f x N_p of a reference (from 0): 0 to 1; NaN where it is not known. A view."""
        within("reference", reference, 0, len(self.references) - 1)
        return self._core.coherence(reference)

    @property
    def warnings(self) -> list[str]:
        """Sentences about the quality of the recordings, and what was assumed of them."""
        return self._core.warnings

    @property
    def hits(self) -> int:
        """How many hits of the hammer were used; 0 of an excitation."""
        return self._core.hits

    @property
    def hits_left_out(self) -> int:
        """How many were not, because they are clipped, double or cut off."""
        return self._core.hits_left_out

    def save(self, file: Folder, *, report: Optional[Folder] = None) -> None:
        """Writes the universal file of ``antinode frf``, the same bytes.

        Args:
            file: for :func:`antinode.identify` and :func:`antinode.retune`.
            report: a folder for ``report.html``.

        Raises:
            InputError: a file cannot be written.
        """
        self._core.save(os.fspath(file), "" if report is None else os.fspath(report))

    def plot(self, reference: int = 0) -> Any:
        """The RMS over the points of the responses of a reference (from 0) as a Matplotlib figure."""
        from ._plots import plot_responses

        return plot_responses(self, reference)


def frf(
    *recordings: Folder,
    sheet: Union[None, Folder, Excitation] = None,
    points: Optional[Folder] = None,
    estimator: str = "h1",
    sensitivity_mm_s_per_V: float = 0.0,
    input_full_scale_V: float = 1.0,
    sync_channel: int = -1,
    reference_channel: int = 0,
    reference_full_scale_V: float = 1.0,
    latency_ms: float = 0.0,
    channels: Sequence[str] = (),
    hit_point: str = "",
    quantity: Optional[str] = None,
    response_unit: str = "",
    response_scale: float = 1.0,
    force_unit: str = "",
    force_scale: float = 1.0,
    trigger_percent: float = 10.0,
    block_s: Optional[float] = None,
    window_decay_per_s: Optional[float] = None,
    lowest_frequency_Hz: Optional[float] = None,
    highest_frequency_Hz: Optional[float] = None,
) -> Estimated:
    """Computes frequency responses from recordings, as ``antinode frf``: of an excitation, or of a hammer.

    Args:
        *recordings: of an excitation WAV files, each of one or more points, in the order of the points; of a hammer
            WAV, text, universal or MATLAB files.
        sheet: the excitation that was played: ``excitation.json``, or what :func:`antinode.excite` gave; None: a
            hammer was.
        points: a CSV of x and y, mm; None: 1 mm apart on a line, or as the files of a hammer say.
        estimator: for noise: 'h1', 'h2' or their geometric mean 'hv'.
        sensitivity_mm_s_per_V, input_full_scale_V: of an excitation: the scale of the sensors.
        sync_channel: with the sync output, counted from 1; 0: none; -1: the last one.
        reference_channel: with the measured voltage of the amplifiers, counted from 1; 0: none.
        reference_full_scale_V: the voltage of a sample of 1 of that channel, V.
        latency_ms: of the sensors, where there is no sync channel, 0 to 200 ms.
        channels: of a hammer: those of WAV and text files in their order, ``["force", "1:x", "1:y"]``.
        hit_point: the point that is hit; empty: as the files say.
        quantity: 'displacement', 'velocity' or 'acceleration'; None: as the files say.
        response_unit, response_scale: of the motion: ``"m/s^2"``, ``"g"``, and what a sample of 1 is in it.
        force_unit, force_scale: of the force likewise; empty: as the files say, or N.
        trigger_percent: of the largest force of a file, 0.1 to 99 %.
        block_s: duration of a hit, 0.001 to 600 s; None: up to the next one, at most 4 s or 4096 samples.
        window_decay_per_s: of the exponential window, 1/s; 0: none; None: chosen.
        lowest_frequency_Hz, highest_frequency_Hz: of a hammer: the band, Hz; None: as far as the force drives.

    Returns:
        :class:`Estimated`: ``frequencies_Hz``, ``responses(reference)``, ``save(file)``.

    Raises:
        InputError: a file cannot be read, or something that was given is not allowed or does not fit.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Theory.md, sections 8.9 and 8.11.
    """
    if not recordings:
        raise InputError("recordings: are none; allowed: at least one file")
    word("estimator", estimator, ("h1", "h2", "hv"))
    word("quantity", quantity, ("displacement", "velocity", "acceleration"))
    files = [os.fspath(file) for file in recordings]
    places = "" if points is None else os.fspath(points)
    if sheet is not None:
        within("sync_channel", sync_channel, -1, 16383)
        within("reference_channel", reference_channel, 0, 16383)
        within("latency_ms", latency_ms, 0, 200)
        options = _antinode.RecordingOptions()
        options.files = files
        options.points = places
        options.sensor = _antinode.SensorScale(sensitivity_mm_s_per_V, input_full_scale_V)
        options.sync_channel = sync_channel
        options.reference_channel = reference_channel
        options.reference_full_scale_V = reference_full_scale_V
        options.latency_ms = latency_ms
        played = sheet._core if isinstance(sheet, Excitation) else _antinode.Excitation.load(os.fspath(sheet))
        return Estimated(_antinode.Estimated.of_excitation(played, options, estimator))
    within("response_scale", response_scale, 1e-300, 1e300)
    within("force_scale", force_scale, 1e-300, 1e300)
    within("trigger_percent", trigger_percent, 0.1, 99)
    within("block_s", block_s, 1e-3, 600)
    within("window_decay_per_s", window_decay_per_s, 0, 1e300)
    within("lowest_frequency_Hz", lowest_frequency_Hz, 0, 1e6)
    within("highest_frequency_Hz", highest_frequency_Hz, 1, 1e6)
    hammer = _antinode.HammerOptions()
    hammer.channels = list(channels)
    hammer.hit_point = hit_point
    hammer.quantity = quantity or ""
    hammer.response_unit = response_unit
    hammer.response_scale = response_scale
    hammer.force_unit = force_unit
    hammer.force_scale = force_scale
    hammer.trigger_percent = trigger_percent
    hammer.block_s = block_s
    hammer.window_decay_per_s = window_decay_per_s
    hammer.lowest_frequency_Hz = lowest_frequency_Hz
    hammer.highest_frequency_Hz = highest_frequency_Hz
    return Estimated(_antinode.Estimated.of_hammer(files, places, estimator, hammer))


class Retuned:
    """A device after a drift: N_m modes, N_b ceramics. Made by :func:`antinode.retune`."""

    def __init__(self, core: _antinode.Retuned) -> None:
        self._core = core

    def __repr__(self) -> str:
        return f"<antinode.Retuned: {sum(self.found)} of {len(self.found)} modes found>"

    @property
    def device(self) -> Device:
        """The device as it is now; a drawn one stays one."""
        return _make_device(json.loads(self._core.device))

    @property
    def frequency_changes(self) -> Floats:
        """N_m: relative changes of the frequencies. A view."""
        return self._core.frequency_changes

    @property
    def damping_changes(self) -> Floats:
        """N_m: relative changes of the damping ratios. A view."""
        return self._core.damping_changes

    @property
    def frequency_deviations(self) -> Floats:
        """N_m: standard deviations that are left, relative. A view."""
        return self._core.frequency_deviations

    @property
    def participation_scales(self) -> Floats:
        """N_b: by what each ceramic's participation was multiplied; 1 where it was not seen. A view."""
        return self._core.participation_scales

    @property
    def found(self) -> list[bool]:
        """N_m: whether the mode was seen; others moved with their neighbours."""
        return self._core.found

    @property
    def delay_s(self) -> float:
        """The delay that all responses share, s."""
        return self._core.delay_s

    @property
    def reconstruction_error_dB(self) -> float:
        """Measured minus synthesised over measured velocities, dB."""
        return self._core.reconstruction_error_dB

    def save(self, file: Folder) -> None:
        """Writes the device file of ``antinode retune``, the same bytes.

        Raises:
            InputError: it cannot be written.
        """
        self._core.save(os.fspath(file))


def retune(
    device: Union[Source, Device],
    *files: Folder,
    frequency_percent: float = 2,
    drift_percent: float = 3,
    damping_percent: float = 30,
    participation_percent: float = 5,
    place_mm: float = 1.0,
    cache: bool = True,
) -> Retuned:
    """Updates a drifted device from the responses of a few points, as ``antinode retune``.

    Args:
        device: as it was before: :func:`antinode.device`, or what that takes.
        *files: responses of a few points, as :func:`antinode.frf` and :func:`antinode.measure` write them.
        frequency_percent, damping_percent, participation_percent: how far each mode may be off the device: standard
            deviations, 0.01 to 50 %.
        drift_percent: the same of the factor that all frequencies share.
        place_mm: how far each point may be beside its place along x and y: a standard deviation, 0 to 50 mm.
        cache: False: the device is solved without the user's cache.

    Returns:
        :class:`Retuned`: ``device``, ``frequency_changes``, ``save(file)``.

    Raises:
        InputError: a file cannot be read or does not fit the device, or none of its modes is found.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Theory.md, section 8.7.
    """
    if not files:
        raise InputError("files: are none; allowed: at least one file of responses")
    within("frequency_percent", frequency_percent, 0.01, 50)
    within("drift_percent", drift_percent, 0.01, 50)
    within("damping_percent", damping_percent, 0.01, 50)
    within("participation_percent", participation_percent, 0.01, 50)
    within("place_mm", place_mm, 0, 50)
    deviations = _antinode.RetuneDeviations()
    deviations.frequency_percent = frequency_percent
    deviations.drift_percent = drift_percent
    deviations.damping_percent = damping_percent
    deviations.participation_percent = participation_percent
    deviations.place_mm = place_mm
    names = [os.fspath(file) for file in files]
    return Retuned(_antinode.Retuned.make(device_of(device)._core, names, deviations, cache))
