"""Designs and renders of a focus."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Callable, Iterable, Optional, Union

from . import _antinode
from ._documents import Device, Focus, Source, device_for, focus_of
from ._pictures import Pictured, Style, style
from ._places import Probe, place_pairs
from ._progress import Progress, shown

if TYPE_CHECKING:
    from ._antinode import Floats

Folder = Union[str, "os.PathLike[str]"]


class Design(Pictured):
    """The voltages of a focus, not yet played: N_d drives, N_b ceramics, N_p points. Made by :func:`antinode.design`.

    Arrays are read-only views of the memory of the design, which they keep alive.
    """

    def __init__(self, core: _antinode.Design) -> None:
        self._core = core
        self._numbers: Optional[dict[str, Any]] = None

    def __repr__(self) -> str:
        return f"<antinode.Design '{self.focus}' on '{self.device}': {self.peak_voltage_V:.4g} V>"

    @property
    def device(self) -> str:
        """The name of the device."""
        return self._core.device

    @property
    def focus(self) -> str:
        """The name of the focus."""
        return self._core.focus

    @property
    def peak_voltage_V(self) -> float:
        """The largest voltage of any ceramic, V."""
        return self._core.peak_voltage_V

    @property
    def allocation_V(self) -> Floats:
        """N_b x N_d: ``U_i(t) = sum_l allocation_V[i, l] value_l(t)``, V. A view."""
        return self._core.allocation_V

    @property
    def oscillations(self) -> list[dict[str, float]]:
        """N_d drives: mode (from 0), start_s, end_s, growth_per_s, angular_frequency_rad_s, in_phase, quadrature.

        With tau = t - start_s, for start_s <= t < end_s, else 0:
        ``exp(growth tau) (in_phase sin(angular_frequency tau) + quadrature cos(angular_frequency tau))``.
        """
        return self._core.oscillations

    @property
    def samples_V(self) -> Optional[Floats]:
        """N_b x N_s: the samples of a free waveform, V; None where there are none. A view."""
        return self._core.samples_V

    @property
    def voltage_limits_V(self) -> Floats:
        """N_b: the limit of each ceramic, V. A view."""
        return self._core.voltage_limits_V

    @property
    def points_m(self) -> Floats:
        """N_p x 2: x and y of the points of the surface, m. A view."""
        return self._core.points_m

    @property
    def wanted_field_m_s(self) -> Floats:
        """N_p: the wanted velocity at the (first) focus, m/s. A view."""
        return self._core.wanted_field_m_s

    @property
    def represented_field_m_s(self) -> Floats:
        """N_p: its part that the controlled modes represent, m/s. A view."""
        return self._core.represented_field_m_s

    @property
    def predicted_field_m_s(self) -> Floats:
        """N_p: what the voltages do by the closed form, m/s (Docs/Theory.md, section 3.1)."""
        return self._core.predicted_field_m_s()

    @property
    def certificate(self) -> dict[str, Any]:
        """How near the allocation is to the optimum: status, gap, bound, peak_ratio and more, as in ``design.json``."""
        certificate: dict[str, Any] = self.numbers["certificate"]
        return certificate

    @property
    def numbers(self) -> dict[str, Any]:
        """All of ``design.json`` but its power: choices with reasons, warnings, controlled modes, lower bound."""
        if self._numbers is None:
            self._numbers = json.loads(self._core.numbers())
        return self._numbers

    def to_dict(self) -> dict[str, Any]:
        """All of ``design.json``, with the electrical power, which takes a render."""
        document: dict[str, Any] = json.loads(self._core.text())
        return document

    def save(self, folder: Folder) -> None:
        """Writes ``design.json``, the same bytes as ``antinode design --out``."""
        self._core.save(os.fspath(folder))

    def _draw(self, style: Style) -> bytes:
        return self._core.png(style)

    def plot(self) -> Any:
        """Wanted, represented and predicted field as a Matplotlib figure."""
        from ._plots import plot_values

        fields = {
            "wanted": self.wanted_field_m_s * 1e3,
            "represented": self.represented_field_m_s * 1e3,
            "predicted": self.predicted_field_m_s * 1e3,
        }
        return plot_values(self._core.is_plate, self.points_m, fields, f"{self.focus} on {self.device}", "mm/s")


class Rendered(Pictured):
    """A focus as the plate model played it: N_b ceramics, N_s samples, N_p points. Made by :func:`antinode.render`.

    Arrays are read-only views of the memory of the render, which they keep alive.
    """

    def __init__(self, core: _antinode.Rendered, design: Design) -> None:
        self._core = core
        self._design = design
        self._scores: Optional[dict[str, Any]] = None

    def __repr__(self) -> str:
        return f"<antinode.Rendered '{self._design.focus}' on '{self._design.device}'>"

    @property
    def design(self) -> Design:
        """The design that was played."""
        return self._design

    @property
    def scores(self) -> dict[str, Any]:
        """All numbers of ``summary.json``: v_score, field_error, contrast, felt, power and more."""
        if self._scores is None:
            self._scores = json.loads(self._core.summary)
        return self._scores

    @property
    def sample_rate_Hz(self) -> float:
        """Hz."""
        return self._core.sample_rate_Hz

    @property
    def focus_sample(self) -> int:
        """The sample (from 0) of the first focus."""
        return self._core.focus_sample

    @property
    def times_s(self) -> Floats:
        """N_s: the times of the samples from the trigger, s."""
        import numpy as np

        return np.arange(self.voltages_V.shape[1]) / self.sample_rate_Hz

    @property
    def voltages_V(self) -> Floats:
        """N_b x N_s: the voltages that ceramics act on, after the limiter, V. A view."""
        return self._core.voltages_V

    @property
    def output_voltages_V(self) -> Floats:
        """N_b x N_s: the voltages to play, V: the same, with lags of ceramics undone where the device has any. A view."""
        return self._core.output_voltages_V

    @property
    def probes_mm(self) -> Floats:
        """N_probes x 2: x and y of the probes, mm."""
        return self._core.probes_mm

    @property
    def probe_velocities_m_s(self) -> Floats:
        """N_probes x N_s: the velocity of the surface at the probes, m/s. A view."""
        return self._core.probe_velocities_m_s

    @property
    def modal_velocities(self) -> Floats:
        """Modes x N_s, m/s kg^1/2; of complex modes the imaginary parts lie behind. A view."""
        return self._core.modal_velocities

    @property
    def points_m(self) -> Floats:
        """N_p x 2: x and y of the points of the surface, m. A view."""
        return self._core.points_m

    @property
    def wanted_field_m_s(self) -> Floats:
        """N_p: the wanted velocity at the (first) focus, m/s. A view."""
        return self._core.wanted_field_m_s

    @property
    def represented_field_m_s(self) -> Floats:
        """N_p: its part that the controlled modes represent, m/s. A view."""
        return self._core.represented_field_m_s

    @property
    def reached_field_m_s(self) -> Floats:
        """N_p: the velocity that the plate model reached, m/s. A view."""
        return self._core.reached_field_m_s

    def save(
        self, folder: Folder, *, format: str = "wav", report: bool = True, figures: Iterable[str] = ()
    ) -> None:
        """Writes the folder of ``antinode render``, the same bytes.

        Args:
            folder: made where it is missing.
            format: of the voltages: 'wav', 'csv', 'mat', 'tfw'.
            report: whether ``report.html`` is written.
            figures: 'svg', 'pdf': the figures of the report for print.

        Raises:
            InputError: the folder cannot be written, or a format cannot hold the samples.
        """
        self._core.save(os.fspath(folder), format, report, list(figures))

    def _draw(self, style: Style) -> bytes:
        return self._core.field_png(style)

    def voltages_png(
        self, *, width: int = 760, height: int = 0, scale: float = 1.0, theme: str | None = None
    ) -> bytes:
        """The voltages of all ceramics as the bytes of a PNG file. Args: as :meth:`png`."""
        return self._core.voltages_png(style(width, height, scale, theme))

    def plot(self) -> Any:
        """Wanted, represented and reached field as a Matplotlib figure."""
        from ._plots import plot_values

        fields = {
            "wanted": self.wanted_field_m_s * 1e3,
            "represented": self.represented_field_m_s * 1e3,
            "reached": self.reached_field_m_s * 1e3,
        }
        title = f"{self._design.focus} on {self._design.device}"
        return plot_values(self._core.is_plate, self.points_m, fields, title, "mm/s")


def design(
    focus: Union[Source, Focus] = "demonstrator",
    device: Union[None, Source, Device] = None,
    *,
    sample_rate_Hz: float = 192000.0,
    reconstruction: str = "band_limited",
    repeat_Hz: float = 10.0,
    threshold: Optional[Folder] = None,
    cache: bool = True,
    progress: Progress = None,
) -> Design:
    """Designs the voltages of a focus, as ``antinode design``.

    Args:
        focus: :func:`antinode.focus`, or what that takes.
        device: :func:`antinode.device`, or what that takes; None: the one that the focus names, else ``staple``.
        sample_rate_Hz: that the voltages are played at, 8000 to 2000000 Hz.
        reconstruction: 'band_limited', or 'zero_order_hold' for generators that hold samples.
        repeat_Hz: foci per second for which electrical power and currents are computed.
        threshold: a CSV of Hz and um: what skin feels; None: the built-in table.
        cache: False: the device is solved without the user's cache.
        progress: a function of what is being done and its share, 0 to 1; True: a bar of tqdm where it is installed. Of
            a design alone nothing is told: its solver does not know how long it will take.

    Returns:
        :class:`Design`: ``allocation_V``, ``oscillations``, ``certificate``, ``save(folder)``.

    Raises:
        InputError: something that was given is not allowed.
        LimitError: the voltage limit cannot be met; ``minimum_peak_voltage_V`` and ``reachable_velocity_m_s`` say
            what would be.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Theory.md, sections 2 to 4.
    """
    settings = design_settings(sample_rate_Hz, reconstruction, repeat_Hz, threshold, cache)
    with shown(progress) as show:
        return made_design(focus, device, settings, show)


def design_settings(
    sample_rate_Hz: float, reconstruction: str, repeat_Hz: float, threshold: Optional[Folder], cache: bool
) -> _antinode.DesignSettings:
    """What of design, render, tolerance and trade-off is the same."""
    table = os.fspath(threshold) if threshold else ""
    return _antinode.DesignSettings(sample_rate_Hz, reconstruction, repeat_Hz, table, cache)


def made_design(
    focus: Union[Source, Focus],
    device: Union[None, Source, Device],
    settings: _antinode.DesignSettings,
    show: Optional[Callable[[str, float], object]],
) -> Design:
    """A design by settings that are made already."""
    wanted = focus_of(focus)
    return Design(_antinode.Design.make(wanted._core, device_for(wanted, device)._core, settings, show))


def render(
    focus: Union[Source, Focus, Design] = "demonstrator",
    device: Union[None, Source, Device] = None,
    *,
    probes_mm: Iterable[Probe] = (),
    duration_ms: Optional[float] = None,
    block_size: int = 512,
    sample_rate_Hz: float = 192000.0,
    reconstruction: str = "band_limited",
    repeat_Hz: float = 10.0,
    threshold: Optional[Folder] = None,
    cache: bool = True,
    progress: Progress = None,
) -> Rendered:
    """Designs a focus and plays it on the plate model, as ``antinode render``.

    Args:
        focus: :func:`antinode.focus`, or what that takes; or a :class:`Design`, which is played as it is: then device,
            sample rate, reconstruction, repeat_Hz, threshold and cache are those of the design.
        probes_mm: places where velocities are recorded, ``[24, (24, 10)]``; default: those of the focus, or its
            targets.
        duration_ms: from the trigger; default: until the surface has calmed down.
        block_size: samples per block, 1 or more; does not affect the result.

    Other args: as :func:`antinode.design`.

    Returns:
        :class:`Rendered`: ``voltages_V``, ``probe_velocities_m_s``, ``scores``, ``save(folder)``.

    Raises: as :func:`antinode.design`.

    Source: Docs/Theory.md, sections 5 and 6.
    """
    places = place_pairs("probes_mm", probes_mm)
    settings = _antinode.RenderSettings(places, duration_ms, block_size)
    of_design = design_settings(sample_rate_Hz, reconstruction, repeat_Hz, threshold, cache)
    with shown(progress) as show:
        made = focus if isinstance(focus, Design) else made_design(focus, device, of_design, show)
        return Rendered(_antinode.Rendered.make(made._core, settings, show), made)
