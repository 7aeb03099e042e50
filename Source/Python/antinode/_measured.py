"""Measuring, identifying, placing."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Iterable, Optional, Sequence, Union

from . import _antinode
from ._checks import within, word
from ._designs import Folder
from ._documents import Device, Focus, Source, device as _make_device, device_of, focus_of
from ._places import Probe, place_pairs
from ._progress import Progress, shown
from ._recorded import excitation_options
from .errors import InputError

if TYPE_CHECKING:
    from ._antinode import Complexes, Floats


class Measured:
    """Velocities per volt at points: N_f lines, N_p points, N_b ceramics. Made by :func:`antinode.measure`."""

    def __init__(self, core: _antinode.Measured) -> None:
        self._core = core

    def __repr__(self) -> str:
        return f"<antinode.Measured: {len(self.points_m)} points, {len(self.frequencies_Hz)} lines>"

    @property
    def frequencies_Hz(self) -> Floats:
        """N_f lines, Hz. A view."""
        return self._core.frequencies_Hz

    @property
    def points_m(self) -> Floats:
        """N_p x 2: x and y, m. A view."""
        return self._core.points_m

    @property
    def warnings(self) -> list[str]:
        """Sentences about the quality of the measurement; empty where all is well."""
        return self._core.warnings

    def responses(self, ceramic: int) -> Complexes:
        """N_f x N_p: velocity per volt of a ceramic (from 0), (m/s)/V, complex; NaN where it was not measured."""
        within("ceramic", ceramic, 0, self._core.ceramics - 1)
        return self._core.responses(ceramic)


def measure(
    device: Union[Source, Device],
    points_mm: Iterable[Probe],
    folder: Folder,
    *,
    simulate: bool = True,
    simulated_device: Union[None, Source, Device] = None,
    snr_dB: float = 40.0,
    delay_ms: float = 1.234567,
    cubic_percent: float = 0.0,
    signal: str = "multisine",
    sample_rate_Hz: float = 96000.0,
    lowest_frequency_Hz: Optional[float] = None,
    highest_frequency_Hz: Optional[float] = None,
    resolution_Hz: Optional[float] = None,
    periods: int = 4,
    settling_periods: Optional[int] = None,
    levels_V: Sequence[float] = (),
    cache: bool = True,
    progress: Progress = None,
) -> Measured:
    """Measures a device on a simulated bench, as ``antinode measure --simulate``.

    Args:
        device: :func:`antinode.device`, or what that takes.
        points_mm: places, ``[-61, 33]`` or ``[(20, 30), (40, 50)]``.
        folder: of the measurement; an interrupted one is resumed. ``responses.uff`` is for :func:`antinode.identify`.
        simulate: True. A real bench is measured by ``antinode measure``, which asks for the sensor point by point.
        simulated_device: what stands on the bench; None: the same device.
        snr_dB, delay_ms, cubic_percent: of the bench: signal-to-noise ratio, latency, cubic distortion at full level.
        signal: 'multisine', 'sweep' or 'noise'.
        sample_rate_Hz, lowest_frequency_Hz, highest_frequency_Hz, resolution_Hz, periods, settling_periods: of the
            excitation; None: chosen for the modes.
        levels_V: the peak voltage of all ceramics, or of each; default: a fifth of their limits.

    Other args: as :func:`antinode.design`.

    Returns:
        :class:`Measured`: ``frequencies_Hz``, ``responses(ceramic)``.

    Raises:
        InputError: something that was given is not allowed, or the folder holds another measurement.
        KeyboardInterrupt: Ctrl+C; the points that are finished are kept.

    Source: Docs/Theory.md, sections 8.8 to 8.10.
    """
    if not simulate:
        raise InputError("simulate: is False; allowed: True, or a bench with a sensor by `antinode measure`")
    within("snr_dB", snr_dB, -20, 300)
    within("delay_ms", delay_ms, 0, 200)
    within("cubic_percent", cubic_percent, -20, 20)
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
    measured = device_of(device)
    bench = measured if simulated_device is None else device_of(simulated_device)
    settings = _antinode.BenchSettings(snr_dB, delay_ms, cubic_percent)
    places = place_pairs("points_mm", points_mm)
    with shown(progress) as show:
        core = _antinode.Measured.make(
            measured._core, places, os.fspath(folder), options, bench._core, settings, show
        )
    return Measured(core)


class Identified:
    """Modes that follow from measured responses: N_m modes. Made by :func:`antinode.identify`."""

    def __init__(self, core: _antinode.Identified) -> None:
        self._core = core

    def __repr__(self) -> str:
        return f"<antinode.Identified: {len(self.frequencies_Hz)} modes, error {self.reconstruction_error_dB:.1f} dB>"

    @property
    def device(self) -> Device:
        """The device with these modes, of kind 'modal'."""
        return _make_device(json.loads(self._core.device))

    @property
    def frequencies_Hz(self) -> Floats:
        """N_m, Hz."""
        return self._core.frequencies_Hz

    @property
    def frequency_deviations_Hz(self) -> Floats:
        """N_m: their standard deviations, Hz."""
        return self._core.frequency_deviations_Hz

    @property
    def damping_ratios(self) -> Floats:
        """N_m. A view."""
        return self._core.damping_ratios

    @property
    def damping_deviations(self) -> Floats:
        """N_m: their standard deviations. A view."""
        return self._core.damping_deviations

    @property
    def delay_s(self) -> float:
        """The delay that all responses share, s."""
        return self._core.delay_s

    @property
    def reconstruction_error_dB(self) -> float:
        """Measured minus synthesised over measured velocities, dB."""
        return self._core.reconstruction_error_dB

    @property
    def warnings(self) -> list[str]:
        """Sentences about files, identification and modes."""
        return self._core.warnings

    def save(
        self,
        device: Folder,
        *,
        report: Optional[Folder] = None,
        universal_file: Optional[Folder] = None,
        transferred: Optional[Folder] = None,
    ) -> None:
        """Writes the files of ``antinode identify``, the same bytes.

        Args:
            device: the device file (``--out``).
            report: an HTML file, and beside it the diagram to pick modes (``--report``).
            universal_file: frequencies and shapes (``--uff``).
            transferred: the computed device with the measured frequencies; needs ``against`` (``--transfer``).
        """
        if transferred is not None and not self._core.has_comparison:
            raise InputError("--transfer: needs a computed device; allowed only with against=DEVICE")
        names = ["" if name is None else os.fspath(name) for name in (device, report, universal_file, transferred)]
        self._core.save(*names)


def identify(
    *files: Folder,
    name: str = "identified",
    bands_Hz: Iterable[tuple[float, float]] = (),
    orders: Optional[tuple[int, int]] = None,
    kind: Optional[str] = None,
    peaks: bool = False,
    selected_Hz: Sequence[float] = (),
    rejected_Hz: Sequence[float] = (),
    delay_us: Optional[float] = None,
    mass_kg: Optional[float] = None,
    quantity: Optional[str] = None,
    response_unit: Optional[str] = None,
    drive: Optional[str] = None,
    drive_unit: Optional[str] = None,
    points: Optional[Folder] = None,
    references: Sequence[str] = (),
    variables: Sequence[str] = (),
    against: Union[None, Source, Device] = None,
    voltage_limit_V: float = 150.0,
    full_scale_V: Optional[float] = None,
    cache: bool = True,
    progress: Progress = None,
) -> Identified:
    """Finds the modes in measured frequency responses, as ``antinode identify``.

    Args:
        *files: universal files, MATLAB files, text tables, WAV files of impulse responses.
        name: of the device.
        bands_Hz: in which modes are searched, ``[(300, 4000)]``; default: where the measurement is good.
        orders: of the polynomials, lowest and highest, 1 to 100; None: automatic.
        kind: 'real' or 'complex' modes; None: as a test decides.
        peaks: uses peaks and their half-power widths, for comparison.
        selected_Hz, rejected_Hz: keeps only, or leaves out, the modes nearest to these frequencies.
        delay_us: known common delay; None: identified.
        mass_kg: that the points represent, evenly distributed: scales the shapes.
        quantity, response_unit, drive, drive_unit, points, references: where files do not say them: 'velocity',
            'm/s', 'voltage', 'V', a CSV of x and y in mm, the names of the references in the order of the ceramics.
        variables: of MATLAB files those to read; empty: ``H``, ``FRF``, or those whose names differ in numbers.
        against: a computed device to compare with: :func:`antinode.device`, or what that takes.
        voltage_limit_V, full_scale_V: of the device.

    Other args: as :func:`antinode.design`.

    Returns:
        :class:`Identified`: ``device``, ``frequencies_Hz``, ``warnings``, ``save(file)``.

    Raises:
        InputError: a file cannot be read, or something that was given is not allowed.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Theory.md, section 8; Docs/FileFormats.md, "Measured responses".
    """
    if not files:
        raise InputError("files: are none; allowed: at least one file of responses")
    word("kind", kind, ("real", "complex"))
    word("quantity", quantity, ("displacement", "velocity", "acceleration"))
    word("drive", drive, ("voltage", "force"))
    for label, positive in (("mass_kg", mass_kg), ("voltage_limit_V", voltage_limit_V), ("full_scale_V", full_scale_V)):
        within(label, positive, 1e-12, 1e12)
    options = _antinode.IdentifyOptions()
    options.files = [os.fspath(file) for file in files]
    options.name = name
    options.bands = [f"{lower!r}:{upper!r}" for lower, upper in bands_Hz]
    options.orders = "" if orders is None else f"{orders[0]}:{orders[1]}"
    options.is_complex = kind == "complex"
    options.is_real = kind == "real"
    options.uses_peaks = peaks
    options.selected_Hz = list(selected_Hz)
    options.rejected_Hz = list(rejected_Hz)
    options.delay_us = delay_us
    options.mass_kg = mass_kg
    options.quantity = quantity or ""
    options.response_unit = response_unit or ""
    options.drive = drive or ""
    options.drive_unit = drive_unit or ""
    options.points = os.fspath(points) if points else ""
    options.references = list(references)
    options.variables = list(variables)
    options.voltage_limit_V = voltage_limit_V
    options.full_scale_V = full_scale_V
    options.cache = cache
    computed = None if against is None else device_of(against)._core
    with shown(progress) as show:
        return Identified(_antinode.Identified.make(options, computed, show))


class Placed:
    """Positions of ceramics. Made by :func:`antinode.place`."""

    def __init__(self, core: _antinode.Placed) -> None:
        self._core = core

    def __repr__(self) -> str:
        return f"<antinode.Placed '{self.device.name}': the best of {self.candidates} positions>"

    @property
    def device(self) -> Device:
        """The device with its ceramics at the positions found."""
        return Device(_antinode.Device.parse(self._core.document, []))

    @property
    def controllability(self) -> float:
        """How well the worst combination of modes is moved, relative to average positions."""
        return self._core.controllability

    @property
    def controllability_with_ceramics(self) -> Optional[float]:
        """The same with the ceramics' mass and stiffness; None where the device was not solved again."""
        return self._core.controllability_with_ceramics

    @property
    def candidates(self) -> int:
        """The number of positions among which was chosen."""
        return self._core.candidates


def place(
    device: Union[Source, Device] = "aluminium-200x120",
    *,
    count: int = 8,
    size_mm: Union[None, float, tuple[float, float]] = None,
    step_mm: Optional[float] = None,
    rim_mm: Optional[float] = None,
    free_edge_mm: float = 2.0,
    keep_out_mm: Iterable[Sequence[float]] = (),
    modes: int = 40,
    focus_time_ms: Optional[float] = None,
    focuses: Iterable[Union[Source, Focus]] = (),
    frozen: bool = False,
    progress: Progress = None,
) -> Placed:
    """Finds the best positions of ceramics on a device, as ``antinode place``.

    Args:
        device: :func:`antinode.device`, or what that takes.
        count: how many ceramics, 1 to 64.
        size_mm: of each, a length or length and width; None: as the device's first, or 10.
        step_mm: spacing of positions; None: half a ceramic.
        rim_mm: on a plate: largest distance from an edge.
        free_edge_mm: least distance from free edges.
        keep_out_mm: rectangles without ceramics, ``[(x0, y0, x1, y1)]``.
        modes: how many of the lowest modes are to be moved, 1 to 200.
        focus_time_ms: available to move them; None: 25.
        focuses: places for the voltage that these need.
        frozen: the device is not solved again with the placed ceramics.
        progress: as in :func:`antinode.design`.

    Returns:
        :class:`Placed`: ``device``, ``controllability``.

    Raises:
        InputError: something that was given is not allowed, or there is no position.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Theory.md, section 1.9.
    """
    within("count", count, 1, 64)
    within("modes", modes, 1, 200)
    within("rim_mm", rim_mm, 0, 1e5)
    within("free_edge_mm", free_edge_mm, 0, 1000)
    within("focus_time_ms", focus_time_ms, 0.1, 60000)
    options = _antinode.PlaceOptions()
    options.count = count
    options.modes = modes
    if size_mm is not None:
        options.size_mm = repr(float(size_mm)) if isinstance(size_mm, (int, float)) else f"{size_mm[0]!r}x{size_mm[1]!r}"
    options.step_mm = step_mm
    options.rim_mm = rim_mm
    options.free_edge_mm = free_edge_mm
    options.keep_out_mm = [",".join(repr(float(value)) for value in zone) for zone in keep_out_mm]
    options.focus_time_ms = focus_time_ms
    options.frozen = frozen
    bare = device_of(device)
    wanted = [focus_of(each) for each in focuses]
    with shown(progress) as show:
        return Placed(_antinode.Placed.make(bare._core, options, [each._core for each in wanted], show))
