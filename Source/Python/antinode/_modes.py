"""The modes of a device, as arrays."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Optional, Union

from . import _antinode
from ._pictures import Pictured, Style

if TYPE_CHECKING:
    from ._antinode import Floats


class Modes(Pictured):
    """The modes of a device: N_m modes, N_p points of the surface, N_b ceramics. Made by :meth:`antinode.Device.modes`.

    All arrays are read-only. Those that are not computed from others are views of the memory of the model, which they
    keep alive. Modes count from 0 here, and from 1 in files.

    Source: Docs/Theory.md, section 1.
    """

    def __init__(self, core: _antinode.Modes) -> None:
        self._core = core

    def __len__(self) -> int:
        return len(self.damping_ratios)

    def __repr__(self) -> str:
        return f"<antinode.Modes of '{self.device}': {len(self)} modes, {len(self.ceramics)} ceramics>"

    @property
    def device(self) -> str:
        """The name of the device."""
        return self._core.device

    @property
    def frequencies_Hz(self) -> Floats:
        """N_m: the undamped frequencies, Hz, ascending."""
        return self._core.frequencies_Hz

    @property
    def angular_frequencies_rad_s(self) -> Floats:
        """N_m: the same, rad/s. A view."""
        return self._core.angular_frequencies_rad_s

    @property
    def damping_ratios(self) -> Floats:
        """N_m: of critical damping. A view."""
        return self._core.damping_ratios

    @property
    def participation(self) -> Floats:
        """N_m x N_b: modal force per volt, N kg^-1/2 / V. A view."""
        return self._core.participation

    @property
    def participation_imaginary(self) -> Optional[Floats]:
        """N_m x N_b: the imaginary part where modes are complex, else None. A view."""
        return self._core.participation_imaginary

    @property
    def shapes(self) -> Floats:
        """N_p x N_m: displacement normal to the surface, mass-normalised, kg^-1/2. A view."""
        return self._core.shapes

    @property
    def shapes_imaginary(self) -> Optional[Floats]:
        """N_p x N_m: the imaginary part where modes are complex, else None. A view."""
        return self._core.shapes_imaginary

    @property
    def points_m(self) -> Floats:
        """N_p x 2: x and y of the points, m. A view."""
        return self._core.points_m

    @property
    def masses_kg(self) -> Floats:
        """N_p: the mass that each point stands for, kg. A view."""
        return self._core.masses_kg

    @property
    def frequency_errors(self) -> Floats:
        """N_m: the estimated relative error of each frequency; empty where it is unknown. A view."""
        return self._core.frequency_errors

    @property
    def ceramics(self) -> list[str]:
        """N_b names, in the order of the channels."""
        return self._core.ceramics

    @property
    def rigid_body_modes(self) -> int:
        """How many modes of frequency 0 there are, which are not listed."""
        return self._core.rigid_body_modes

    @property
    def warnings(self) -> list[str]:
        """Sentences about the accuracy of the model."""
        return self._core.warnings

    def shapes_at(self, x_mm: float, y_mm: float = 0.0) -> Floats:
        """The shapes of all modes at one place, kg^-1/2: N_m values, or 2 N_m of complex modes, imaginary parts behind.

        Raises:
            InputError: the place is outside the surface.

        Source: Docs/Theory.md, section 1.5.
        """
        return self._core.shapes_at(x_mm, y_mm)

    def to_csv(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the table of ``antinode modes --csv``."""
        with open(file, "w", encoding="utf-8", newline="") as stream:
            stream.write(self._core.csv())

    def to_universal_file(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Writes frequencies and shapes as ``antinode modes --uff``."""
        with open(file, "wb") as stream:
            stream.write(self._core.universal_file())

    def _draw(self, style: Style) -> bytes:
        return self._core.gallery_png(12, style)

    def plot(self, mode: int = 0) -> Any:
        """The shape of a mode (from 0) as a Matplotlib figure."""
        from ._plots import plot_values

        return plot_values(
            self._core.is_plate,
            self.points_m,
            {f"mode {mode}": self.shapes[:, mode]},
            f"{self.device}: mode {mode}, {self.frequencies_Hz[mode]:.1f} Hz",
            "shape, kg$^{-1/2}$",
        )
