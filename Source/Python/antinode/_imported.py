"""Devices from results of finite elements."""

from __future__ import annotations

import json
import os
from typing import Optional

from . import _antinode
from ._checks import within, word
from ._designs import Folder
from ._documents import Device, device as _make_device
from .errors import InputError


class Imported:
    """A device of what a finite-element program computed: N_b ceramics. Made by :func:`antinode.import_device`."""

    def __init__(self, core: _antinode.Imported) -> None:
        self._core = core

    def __repr__(self) -> str:
        return f"<antinode.Imported '{self.device.name}': {self.surface_nodes} nodes of its surface>"

    @property
    def device(self) -> Device:
        """The device, of kind 'modal'."""
        return _make_device(json.loads(self._core.device))

    @property
    def mass_kg(self) -> float:
        """The mass that the surface represents, from the norms of the shapes, kg."""
        return self._core.mass_kg

    @property
    def total_mass_kg(self) -> Optional[float]:
        """The mass as a table of the program says, kg; None: it does not."""
        return self._core.total_mass_kg

    @property
    def static_errors(self) -> list[float]:
        """N_b: what the modes leave of the static displacement by each ceramic, RMS, relative; empty: it is not known."""
        return self._core.static_errors

    @property
    def modes_left_out(self) -> int:
        """How many modes do not move the surface along its normal."""
        return self._core.modes_left_out

    @property
    def surface_nodes(self) -> int:
        """How many nodes the surface has, before they were thinned."""
        return self._core.surface_nodes

    @property
    def warnings(self) -> list[str]:
        """Sentences about what speaks against the device."""
        return self._core.warnings

    def save(self, file: Folder) -> None:
        """Writes the device file of ``antinode import``, the same bytes.

        Raises:
            InputError: it cannot be written.
        """
        self._core.save(os.fspath(file))


def import_device(
    *files: Folder,
    name: str = "imported",
    units: str = "SI",
    normal: str = "z",
    side: str = "top",
    outline: Optional[Folder] = None,
    flatness_mm: Optional[float] = None,
    points: int = 2000,
    case_voltage_V: float = 1.0,
    damping_ratio: float = 0.01,
    voltage_limit_V: float = 150.0,
    full_scale_V: Optional[float] = None,
) -> Imported:
    """Makes a device of the modes and reaction forces of a finite-element program, as ``antinode import``.

    Args:
        *files: CalculiX ``.frd`` and ``.dat`` files, or universal files.
        name: of the device.
        units: of the files: 'SI' (m, kg, N, s) or 'mm' (mm, t, N, s).
        normal: the axis that is normal to the surface: 'x', 'y' or 'z'.
        side: which plane is touched: 'top', the highest along that axis, or 'bottom'.
        outline: where the surface ends: a plate with an outline, by embedded name or .json file, or a drawing (.svg,
            .dxf); None: nothing is known of it.
        flatness_mm: how far nodes of the surface may lie behind its plane, mm; None: a thousandth of its extent.
        points: at most, 3 to 20000; more nodes are thinned evenly.
        case_voltage_V: at which the ceramics of the static cases strain, V.
        damping_ratio: of modes for which the program says none, 1e-6 to 0.9.
        voltage_limit_V: of every ceramic, V.
        full_scale_V: the voltage of a sample of 1, V; None: the voltage limit.

    Returns:
        :class:`Imported`: ``device``, ``warnings``, ``save(file)``.

    Raises:
        InputError: a file cannot be read, there is no surface, a ceramic has no force, or no mode moves the surface.
        KeyboardInterrupt: Ctrl+C.

    Source: Docs/Theory.md, section 1.14; Docs/Manual/importing.md.
    """
    if not files:
        raise InputError("files: are none; allowed: at least one file of results")
    word("units", units, ("SI", "mm"))
    word("normal", normal, ("x", "y", "z"))
    word("side", side, ("top", "bottom"))
    within("points", points, 3, 20000)
    within("damping_ratio", damping_ratio, 1e-6, 0.9)
    for label, positive in (
        ("flatness_mm", flatness_mm),
        ("case_voltage_V", case_voltage_V),
        ("voltage_limit_V", voltage_limit_V),
        ("full_scale_V", full_scale_V),
    ):
        within(label, positive, 1e-12, 1e12)
    options = _antinode.ImportOptions()
    options.files = [os.fspath(file) for file in files]
    options.name = name
    options.units = units
    options.normal = normal
    options.side = side
    options.outline = "" if outline is None else os.fspath(outline)
    options.flatness_mm = flatness_mm or 0.0
    options.points = points
    options.case_voltage_V = case_voltage_V
    options.damping_ratio = damping_ratio
    options.voltage_limit_V = voltage_limit_V
    options.full_scale_V = full_scale_V
    return Imported(_antinode.Imported.make(options))
