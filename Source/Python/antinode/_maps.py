"""A focus at every place of a surface."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _antinode
from ._checks import within
from ._designs import Folder
from ._documents import Device, Focus, Source, device_for, focus_of
from ._pictures import Reported
from ._progress import Progress, shown

if TYPE_CHECKING:
    from ._antinode import Floats


class Mapped(Reported):
    """A focus at every place of a surface: N_y rows from below, N_x columns. Made by :func:`antinode.map`.

    Arrays are N_y x N_x, with NaN where there is no design; on a line N_y is 1.
    """

    _first = 1  # How sharp the focus is.

    def __init__(self, core: _antinode.Mapped) -> None:
        self._core: _antinode.Mapped = core

    def __repr__(self) -> str:
        return f"<antinode.Mapped '{self.focus}' on '{self.device}': {len(self.x_mm)} x {len(self.y_mm)} places>"

    @property
    def device(self) -> str:
        """The name of the device."""
        return self._core.device

    @property
    def focus(self) -> str:
        """The name of the focus."""
        return self._core.focus

    @property
    def x_mm(self) -> Floats:
        """N_x: where the columns are, mm."""
        return self._core.x_mm

    @property
    def y_mm(self) -> Floats:
        """N_y: where the rows are, mm."""
        return self._core.y_mm

    @property
    def captured(self) -> Floats:
        """The root of the share of the wanted field's energy that the controlled modes represent; 1 is best."""
        return self._core.captured

    @property
    def v_score(self) -> Floats:
        """Correlation of the field at the focus with the wanted one; 1 is best."""
        return self._core.v_score

    @property
    def field_error(self) -> Floats:
        """RMS of the field minus the wanted one, over that of the wanted one."""
        return self._core.field_error

    @property
    def peak_voltage_V(self) -> Floats:
        """The largest voltage that a focus needs there, V."""
        return self._core.peak_voltage_V

    @property
    def voltage_limit_V(self) -> float:
        """The largest voltage that is allowed, V."""
        return self._core.voltage_limit_V

    @property
    def spill_over(self) -> Floats:
        """The part of the field that lies in modes beyond the device's own."""
        return self._core.spill_over

    @property
    def felt_contrast_dB(self) -> Floats:
        """Sensation level at the focus over that of the strongest place farther away, dB; NaN where it was left out."""
        return self._core.felt_contrast_dB

    @property
    def errors(self) -> dict[tuple[int, int], str]:
        """Why there is no design: sentences by row and column."""
        columns = len(self.x_mm)
        return {divmod(place, columns): sentence for place, sentence in enumerate(self._core.errors) if sentence}

    @property
    def numbers(self) -> dict[str, Any]:
        """All of ``summary.json``."""
        numbers: dict[str, Any] = json.loads(self._core.numbers)
        return numbers

    def save(self, folder: Folder) -> None:
        """Writes the folder of ``antinode map``: ``map.csv``, ``report.html``, ``summary.json``.

        Raises:
            InputError: the folder cannot be written.
        """
        self._core.save(os.fspath(folder))

    def plot(self, number: str = "v_score") -> Any:
        """One of the arrays as a Matplotlib figure.

        Args:
            number: 'captured', 'v_score', 'field_error', 'peak_voltage_V', 'spill_over' or 'felt_contrast_dB'.
        """
        from ._plots import plot_map

        return plot_map(self, number)


def map(
    device: Union[None, Source, Device] = None,
    focus: Union[Source, Focus] = "demonstrator",
    *,
    places: int = 2000,
    felt: bool = True,
    threshold: Optional[Folder] = None,
    sample_rate_Hz: float = 192000.0,
    threads: Optional[int] = None,
    cache: bool = True,
    progress: Progress = None,
) -> Mapped:
    """Designs a focus at every place of a surface, as ``antinode map``: where it is sharp, what it needs, how it is felt.

    Args:
        device: :func:`antinode.device`, or what that takes; None: the one that the focus names, else ``staple``.
        focus: :func:`antinode.focus`, or what that takes; its first target goes to every place, the others stay as far
            from it as they are.
        places: about how many, in a grid of square cells, 1 to 100000.
        felt: False leaves out what skin feels, which takes most of the time.
        threshold: a CSV of Hz and um: what skin feels; None: the built-in table.
        sample_rate_Hz: that the voltages are played at, 8000 to 2000000 Hz.
        threads: places at once, 1 to 1024; None: one per processor.
        cache: False: the device is solved without the user's cache.
        progress: a function of what is being done and its share, 0 to 1; True: a bar of tqdm where it is installed.

    Returns:
        :class:`Mapped`: ``v_score``, ``peak_voltage_V``, ``felt_contrast_dB``, ``save(folder)``. The same for any
        number of threads.

    Raises:
        InputError: something that was given is not allowed.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Decisions/0108-maps.md; Docs/Theory.md, section 6.
    """
    within("places", places, 1, 100000)
    within("threads", threads, 1, 1024)
    settings = _antinode.MapSettings()
    settings.places = places
    settings.felt = felt
    settings.threshold = os.fspath(threshold) if threshold else ""
    settings.sample_rate_Hz = sample_rate_Hz
    settings.threads = threads
    settings.cache = cache
    wanted = focus_of(focus)
    with shown(progress) as show:
        return Mapped(_antinode.Mapped.make(wanted._core, device_for(wanted, device)._core, settings, show))
