"""A waveform for every finger."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Iterable, Optional, Union

from . import _antinode
from ._checks import within
from ._designs import Folder
from ._documents import Device, Source, Waveforms, device_for, waveforms as _make_waveforms
from ._progress import Progress, shown

if TYPE_CHECKING:
    from ._antinode import Floats


class Performed:
    """Waveforms at fingers as the plate model played them: N_b ceramics, N_s samples, N_f fingers, those with tracks
    first. Made by :func:`antinode.perform`.

    Arrays are read-only views of the memory of the result, which they keep alive.
    """

    def __init__(self, core: _antinode.Performed) -> None:
        self._core = core
        self._scores: Optional[dict[str, Any]] = None

    def __repr__(self) -> str:
        scores = self.scores
        volts = f"{scores['peak_voltage_V']:.4g} V"
        return f"<antinode.Performed '{scores['waveforms']}' on '{scores['device']}': {len(self.fingers)} fingers, {volts}>"

    @property
    def fingers(self) -> list[str]:
        """N_f names, as in ``report.html``."""
        return self._core.fingers

    @property
    def sample_rate_Hz(self) -> float:
        """Hz."""
        return self._core.sample_rate_Hz

    @property
    def trigger_sample(self) -> int:
        """The sample (from 0) of the trigger, from which tracks count their time."""
        return self._core.trigger_sample

    @property
    def voltages_V(self) -> Floats:
        """N_b x N_s: the voltages that ceramics act on, V. A view."""
        return self._core.voltages_V

    @property
    def output_voltages_V(self) -> Floats:
        """N_b x N_s: the voltages to play, V: the same, with lags of ceramics undone where the device has any. A view."""
        return self._core.output_voltages_V

    @property
    def displacements_m(self) -> Floats:
        """N_f x samples: what the surface did at the fingers, m; it goes on while the surface rings. A view."""
        return self._core.displacements_m

    @property
    def wanted_m(self) -> Floats:
        """Samples from the trigger on x N_f: what was wanted, m. A view."""
        return self._core.wanted_m

    @property
    def scores(self) -> dict[str, Any]:
        """All numbers of ``summary.json``: errors, levels and volts."""
        if self._scores is None:
            self._scores = json.loads(self._core.summary)
        return self._scores

    def save(self, folder: Folder, *, report: bool = True) -> None:
        """Writes the folder of ``antinode perform``, the same bytes.

        Raises:
            InputError: the folder cannot be written.
        """
        self._core.save(os.fspath(folder), report)

    def plot(self) -> Any:
        """What each finger feels over time as a Matplotlib figure, with what was wanted."""
        from ._plots import plot_fingers

        return plot_fingers(self)


def perform(
    waveforms: Union[Source, Waveforms] = "three-fingers",
    device: Union[None, Source, Device] = None,
    *,
    sample_rate_Hz: float = 48000.0,
    latency_ms: Optional[float] = None,
    threshold: Optional[Folder] = None,
    passes: Iterable[Folder] = (),
    longest_latency_ms: float = 0.0,
    sensitivity_mm_s_per_V: float = 0.0,
    input_full_scale_V: float = 1.0,
    cache: bool = True,
    progress: Progress = None,
) -> Performed:
    """Gives every finger a waveform of its own, as ``antinode perform``.

    Args:
        waveforms: :func:`antinode.waveforms`, or what that takes.
        device: :func:`antinode.device`, or what that takes; None: the one that the waveforms name, else
            ``glass-148x210``.
        sample_rate_Hz: of the voltages, 1000 to 2000000 Hz.
        latency_ms: voltages follow the tracks as live inputs, by filters with this latency, 0.1 to 100 ms; None: the
            whole event is known.
        threshold: a CSV of Hz and um: what skin feels; None: the built-in table.
        passes: folders of earlier passes with what was recorded, in their order: the design corrects the best of them.
        longest_latency_ms: of each recording, 0 to 200 ms: it is looked for; 0: recordings begin with their voltages.
        sensitivity_mm_s_per_V, input_full_scale_V: the scale of ``recorded.wav``.
        cache: False: the device is solved without the user's cache.
        progress: a function of what is being done and its share, 0 to 1; True: a bar of tqdm where it is installed.

    Returns:
        :class:`Performed`: ``voltages_V``, ``displacements_m``, ``scores``, ``save(folder)``.

    Raises:
        InputError: something that was given is not allowed, or fingers are too near to each other.
        LimitError: the levels are beyond the limits; ``reachable_share`` says what share of them is not.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Theory.md, sections 4.13 and 5.3.
    """
    within("sample_rate_Hz", sample_rate_Hz, 1000, 2e6)
    within("latency_ms", latency_ms, 0.1, 100)
    within("longest_latency_ms", longest_latency_ms, 0, 200)
    recorded = [os.fspath(folder) for folder in passes]
    settings = _antinode.PerformSettings(
        sample_rate_Hz,
        latency_ms or 0.0,
        os.fspath(threshold) if threshold else "",
        recorded,
        longest_latency_ms,
        sensitivity_mm_s_per_V,
        input_full_scale_V,
        cache,
    )
    wanted = waveforms if isinstance(waveforms, Waveforms) else _make_waveforms(waveforms)
    with shown(progress) as show:
        return Performed(_antinode.Performed.make(wanted._core, device_for(wanted, device, "glass-148x210")._core, settings, show))
