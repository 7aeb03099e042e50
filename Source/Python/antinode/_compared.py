"""Designs that are compared: on devices that differ from the model, and with each other."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _antinode
from ._checks import within
from ._designs import Design, Folder, design_settings, made_design
from ._documents import Device, Focus, Source, device_for, focus_of
from ._pictures import Reported
from ._progress import Progress, shown

if TYPE_CHECKING:
    from ._antinode import Floats


class Tolerance(Reported):
    """A design on N devices that differ from the model. Made by :func:`antinode.tolerance`.

    Where the focus is robust (``allocation.robust``), its design without robustness is compared on the same devices.
    """

    def __init__(self, core: _antinode.Tolerance, design: Design) -> None:
        self._core: _antinode.Tolerance = core
        self._design = design
        self._numbers: Optional[dict[str, Any]] = None

    def __repr__(self) -> str:
        return f"<antinode.Tolerance of '{self._design.focus}' on {len(self.field_errors)} devices>"

    def __str__(self) -> str:
        return self._core.text()

    @property
    def design(self) -> Design:
        """The design that was played on all devices."""
        return self._design

    @property
    def field_errors(self) -> Floats:
        """N: RMS of reached minus represented field over that of the represented one, on each device."""
        return self._core.field_errors

    @property
    def v_scores(self) -> Floats:
        """N: correlation of the reached with the represented field, on each device; 1 is best."""
        return self._core.v_scores

    @property
    def peak_ratios(self) -> Floats:
        """N: reached over wanted velocity at the peak, on each device."""
        return self._core.peak_ratios

    @property
    def numbers(self) -> dict[str, Any]:
        """All of ``tolerance.json``: the spread, percentiles of all designs, and the largest causes of error."""
        if self._numbers is None:
            self._numbers = json.loads(self._core.numbers)
        return self._numbers

    @property
    def causes(self) -> list[dict[str, Any]]:
        """What of the device causes the error, the largest first: mode (from 1), kind, field_error."""
        causes: list[dict[str, Any]] = self.numbers["designs"][-1]["causes"]
        return causes

    def save(self, folder: Folder) -> None:
        """Writes the folder of ``antinode design --tolerance``: ``design.json``, ``tolerance.json``, ``tolerance.html``.

        Raises:
            InputError: the folder cannot be written.
        """
        self._core.save(os.fspath(folder))

    def plot(self) -> Any:
        """How many devices have at most this field error, as a Matplotlib figure; one curve per design."""
        from ._plots import plot_tolerance

        return plot_tolerance(self)


def tolerance(
    focus: Union[Source, Focus, Design] = "demonstrator",
    device: Union[None, Source, Device] = None,
    *,
    draws: int = 200,
    seed: int = 1,
    frequency_percent: Optional[float] = None,
    damping_percent: Optional[float] = None,
    participation_percent: Optional[float] = None,
    drift_percent: Optional[float] = None,
    sample_rate_Hz: float = 192000.0,
    reconstruction: str = "band_limited",
    repeat_Hz: float = 10.0,
    threshold: Optional[Folder] = None,
    cache: bool = True,
    progress: Progress = None,
) -> Tolerance:
    """Plays a design on devices that differ from the model, as ``antinode design --tolerance``.

    Args:
        focus: :func:`antinode.focus`, or what that takes; or a :class:`Design`: then device, sample rate,
            reconstruction, repeat_Hz, threshold and cache are those of the design.
        device: :func:`antinode.device`, or what that takes; None: the one that the focus names, else ``staple``.
        draws: how many random devices, 1 to 1000000.
        seed: of these devices; the same seed draws the same devices for every design.
        frequency_percent: standard deviation of each frequency, 0 to 10 %; None: as the focus is robust against,
            else 0.1.
        damping_percent: of each damping ratio, 0 to 50 %; None: likewise, else 10.
        participation_percent: of each participation, 0 to 50 %; None: likewise, else 5.
        drift_percent: of a factor that all frequencies share, 0 to 10 %; None: likewise, else 0.

    Other args: as :func:`antinode.design`.

    Returns:
        :class:`Tolerance`: ``field_errors``, ``v_scores``, ``causes``, ``save(folder)``.

    Raises: as :func:`antinode.design`, and InputError for a spread that is not allowed.

    Source: Docs/Theory.md, section 7.4.
    """
    within("draws", draws, 1, 1000000)
    within("seed", seed, 0, 2**31 - 1)
    options = _antinode.ToleranceOptions()
    options.draws = draws
    options.seed = seed
    options.frequency_percent = frequency_percent
    options.damping_percent = damping_percent
    options.participation_percent = participation_percent
    options.drift_percent = drift_percent
    settings = design_settings(sample_rate_Hz, reconstruction, repeat_Hz, threshold, cache)
    with shown(progress) as show:
        made = focus if isinstance(focus, Design) else made_design(focus, device, settings, show)
        return Tolerance(_antinode.Tolerance.make(made._core, options, show), made)


class Tradeoff(Reported):
    """Designs of one focus by all methods and growths, or by the weight of what is felt elsewhere. Made by
    :func:`antinode.tradeoff`."""

    def __init__(self, core: _antinode.Tradeoff) -> None:
        self._core: _antinode.Tradeoff = core
        self._numbers: Optional[dict[str, Any]] = None

    def __repr__(self) -> str:
        return f"<antinode.Tradeoff of '{self.numbers['focus']}': {len(self.points)} designs>"

    def __str__(self) -> str:
        return self._core.text()

    @property
    def numbers(self) -> dict[str, Any]:
        """All of ``tradeoff.json``: the points, and the voltage that no waveform does with less than, V."""
        if self._numbers is None:
            self._numbers = json.loads(self._core.numbers)
        return self._numbers

    @property
    def points(self) -> list[dict[str, Any]]:
        """The designs: method, peak_voltage_V, time_in_motion_ms, field_error_truncated, on_front and more; of a focus
        with ``felt`` weight, peak_voltage_V, contrast_dB and more. ``failure`` says why there is no design."""
        points: list[dict[str, Any]] = self.numbers["points"]
        return points

    @property
    def front(self) -> list[dict[str, Any]]:
        """The points that no other one has both less voltage and less time than; none of a focus with ``felt``."""
        return [point for point in self.points if point.get("on_front")]

    def save(self, folder: Folder) -> None:
        """Writes the folder of ``antinode design --tradeoff``: ``tradeoff.json``, ``tradeoff.csv``, ``tradeoff.html``.

        Raises:
            InputError: the folder cannot be written.
        """
        self._core.save(os.fspath(folder))

    def plot(self) -> Any:
        """Peak voltage against time in motion, or against felt contrast, as a Matplotlib figure."""
        from ._plots import plot_tradeoff

        return plot_tradeoff(self)


def tradeoff(
    focus: Union[Source, Focus] = "demonstrator",
    device: Union[None, Source, Device] = None,
    *,
    sample_rate_Hz: float = 192000.0,
    reconstruction: str = "band_limited",
    threshold: Optional[Folder] = None,
    cache: bool = True,
    progress: Progress = None,
) -> Tradeoff:
    """Compares designs of a focus by all methods and growths, as ``antinode design --tradeoff``.

    A focus with ``felt`` is designed with each weight of what is felt elsewhere instead.

    Args: as :func:`antinode.design`.

    Returns:
        :class:`Tradeoff`: ``points``, ``front``, ``save(folder)``.

    Raises:
        InputError: something that was given is not allowed, or not even the first design can be made.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Theory.md, sections 4.10 and 4.14.
    """
    settings = design_settings(sample_rate_Hz, reconstruction, 10.0, threshold, cache)
    wanted = focus_of(focus)
    with shown(progress) as show:
        return Tradeoff(_antinode.Tradeoff.make(wanted._core, device_for(wanted, device)._core, settings, show))
