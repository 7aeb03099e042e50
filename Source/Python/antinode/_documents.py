"""Devices, focuses and waveforms: values that are made of a name, a file or a dict."""

from __future__ import annotations

import inspect
import json
import os
from typing import Any, Mapping, Optional, Union

from . import _antinode
from ._checks import with_suggestion
from ._pictures import Pictured, Style
from .errors import InputError

Folder = Union[str, "os.PathLike[str]"]
Source = Union[Folder, Mapping[str, Any]]
Changes = Mapping[str, Any]


def as_json(value: Any) -> str:
    """JSON of a value; NumPy's numbers and arrays too."""

    def plain(other: Any) -> Any:
        if hasattr(other, "tolist"):
            return other.tolist()
        raise TypeError(f"{type(other).__name__} is not JSON")

    try:
        return json.dumps(value, default=plain)
    except (TypeError, ValueError) as error:
        raise InputError(f"{error}; allowed: numbers, texts, lists and dicts, as JSON has them") from None


def assignments(keys: Changes) -> list[str]:
    """Keys with their values as ``--set`` takes them, without those that are None."""
    return [f"{key}={as_json(value)}" for key, value in keys.items() if value is not None]


def name_or_file(source: Union[str, "os.PathLike[str]"]) -> str:
    """How the library names it: a path is a file even where it is in the working folder and has another ending."""
    if isinstance(source, str):
        return source
    path = os.fspath(source)
    return path if os.sep in path or path.endswith(".json") else os.path.join(os.curdir, path)


class Document:
    """What devices, focuses and waveforms have in common. Values: nothing changes them."""

    _core: Any

    @property
    def name(self) -> str:
        """Its name, as files have it."""
        return str(self._core.name)

    def to_dict(self) -> dict[str, Any]:
        """The document, as its file has it (``Docs/FileFormats.md``): a copy that may be changed."""
        document: dict[str, Any] = json.loads(self._core.document)
        return document

    def _named(self) -> dict[str, Any]:
        """The document with the name that it has from its file, where it does not say one."""
        return {**self.to_dict(), "name": self.name}

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self)._of, (as_json(self._named()),)

    @classmethod
    def _of(cls, text: str) -> Any:
        raise NotImplementedError

    def save(self, file: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the document as a file that the command line and this package read."""
        with open(file, "w", encoding="utf-8") as stream:
            stream.write(json.dumps(self.to_dict(), indent=2) + "\n")

    def __repr__(self) -> str:
        return f"<antinode.{type(self).__name__} '{self.name}'>"


class Device(Document, Pictured):
    """A surface with its ceramics, damping and limits. Made by :func:`antinode.device`."""

    def __init__(self, core: _antinode.Device) -> None:
        self._core = core
        self._modes: Optional[_antinode.Modes] = None

    @classmethod
    def _of(cls, text: str) -> Device:
        return cls(_antinode.Device.parse(text, []))

    @property
    def kind(self) -> str:
        """'beam', 'staple', 'plate' or 'modal'; with measured modes still that of the drawing."""
        return str(self._core.kind)

    def modes(self, count: Optional[int] = None, *, cache: bool = True) -> _antinode.Modes:
        """The modes of the device, as ``antinode modes`` lists them.

        Args:
            count: number of flexible modes; None: that of the device.
            cache: False: solved without reading or writing the user's cache.

        Returns:
            :class:`antinode.Modes`, with frequencies, damping ratios, participation and shapes.

        Raises:
            InputError: the device cannot be solved.

        Source: Docs/Theory.md, section 1.
        """
        if count is None and cache and self._modes is not None:
            return self._modes
        modes = _antinode.Modes._solve(self._core, count, cache)
        if count is None and cache:
            self._modes = modes
        return modes

    def _draw(self, style: Style) -> bytes:
        return self.modes()._device_png(style)

    def plot(self) -> Any:
        """The device from above as a Matplotlib figure: its points and ceramics."""
        from ._plots import plot_device

        return plot_device(self)


class Focus(Document):
    """A wanted velocity field: place, width, strength and time. Made by :func:`antinode.focus`."""

    def __init__(self, core: _antinode.Focus) -> None:
        self._core = core

    @classmethod
    def _of(cls, text: str) -> Focus:
        return cls(_antinode.Focus.parse(text, []))


class Waveforms(Document):
    """The wanted waveform of each finger. Made by :func:`antinode.waveforms`."""

    def __init__(self, core: _antinode.Waveforms) -> None:
        self._core = core

    @classmethod
    def _of(cls, text: str) -> Waveforms:
        return cls(_antinode.Waveforms.parse(text, []))


def _core_of(kind: Any, source: Source, keys: Changes) -> Any:
    if isinstance(source, Mapping):
        return kind.parse(as_json(source), assignments(keys))
    if isinstance(source, (str, os.PathLike)):
        return kind.load(name_or_file(source), assignments(keys))
    raise InputError(f"{kind.__name__.lower()}: is of type {type(source).__name__}; allowed: a name, a file, a dict")


def device(source: Union[Source, Device] = "staple", *, changes: Optional[Changes] = None, **keys: Any) -> Device:
    """A device: a surface with its ceramics, damping and limits.

    Args:
        source: an embedded or a user's name (``"glass-148x210"``), a file (``"my.json"``), a dict with the keys of
            such a file, or a :class:`Device`.
        changes: values of keys below the first level, ``{"limits.voltage_V": 20, "ceramics.0.name": "left"}``; the index
            of a list counts from 0.
        **keys: values of the keys of the file, with their units: ``thickness_mm=1.5``, ``quality_factor=80``.

    Returns:
        :class:`Device`: ``name``, ``kind``, ``to_dict()``, ``modes()``.

    Raises:
        InputError: no such device, or a key or value that is not allowed.

    Source: Docs/FileFormats.md, "Device".
    """
    start: Source = source._named() if isinstance(source, Device) else source
    return Device(_core_of(_antinode.Device, start, {**keys, **(changes or {})}))


def focus(
    source: Union[Source, Focus] = "demonstrator",
    *,
    x_mm: Optional[float] = None,
    y_mm: Optional[float] = None,
    width_mm: Optional[float] = None,
    peak_velocity_mm_s: Optional[float] = None,
    peak_level_dB_SL: Optional[float] = None,
    shape: Optional[str] = None,
    focus_time_ms: Optional[float] = None,
    method: Optional[str] = None,
    voltage_limit_V: Optional[float] = None,
    brake_duration_ms: Optional[float] = None,
    changes: Optional[Changes] = None,
    **keys: Any,
) -> Focus:
    """A focus: a velocity field that is large at one place at one instant.

    Args:
        source: an embedded or a user's name, a file, a dict with the keys of such a file, or a :class:`Focus`.
        x_mm, y_mm: the centre of the first target, mm.
        width_mm: its full width at half maximum, mm.
        peak_velocity_mm_s: its velocity, mm/s.
        peak_level_dB_SL: in its place: what a fingertip feels at the centre, dB above the threshold.
        shape: 'sinc', 'bump' or 'gaussian'.
        focus_time_ms: from the trigger to the focus, ms.
        method: of the allocation: 'exact', 'least_voltage' or 'paper'.
        voltage_limit_V: for every ceramic, V; never more than the device allows.
        brake_duration_ms: all modes are at rest this long after the focus, ms.
        changes: values of other keys below the first level, ``{"targets.1.x_mm": 60, "transients.cycles": 20}``.
        **keys: values of other keys of the file: ``fingers=[{"x_mm": 24}]``, ``modes={"count": 8}``.

    Returns:
        :class:`Focus`.

    Raises:
        InputError: no such focus, or a key or value that is not allowed.

    Source: Docs/FileFormats.md, "Focus"; Docs/Theory.md, section 2.
    """
    if peak_velocity_mm_s is not None and peak_level_dB_SL is not None:
        raise InputError("peak_level_dB_SL: stands beside peak_velocity_mm_s; allowed: one of them")

    start: Source = source._named() if isinstance(source, Focus) else source
    first = {
        "targets.0.x_mm": x_mm,
        "targets.0.y_mm": y_mm,
        "targets.0.width_mm": width_mm,
        "targets.0.peak_velocity_mm_s": peak_velocity_mm_s,
        "targets.0.peak_level_dB_SL": peak_level_dB_SL,
        "targets.0.shape": shape,
        "focus_time_ms": focus_time_ms,
        "allocation.method": method,
        "allocation.voltage_limit_V": voltage_limit_V,
        "transients.brake_duration_ms": brake_duration_ms,
    }
    # What replaces a whole key comes before what changes a part of it.
    try:
        return Focus(_core_of(_antinode.Focus, start, {**keys, **first, **(changes or {})}))
    except InputError as error:
        raise with_suggestion(error, keys, list(inspect.signature(focus).parameters)[1:-2]) from None


def waveforms(
    source: Union[Source, Waveforms] = "three-fingers", *, changes: Optional[Changes] = None, **keys: Any
) -> Waveforms:
    """Waveforms at fingers, and fingers that are to feel nothing.

    Args:
        source: an embedded or a user's name, a file, a dict with the keys of such a file (recordings are then looked
            for in the working folder), or :class:`Waveforms`.
        changes: values of keys below the first level, ``{"tracks.0.x_mm": 70}``.
        **keys: values of the keys of the file: ``band_Hz=[40, 500]``.

    Returns:
        :class:`Waveforms`.

    Raises:
        InputError: no such waveforms, or a key or value that is not allowed.

    Source: Docs/FileFormats.md, "Waveforms"; Docs/Theory.md, section 4.13.
    """
    start: Source = source._named() if isinstance(source, Waveforms) else source
    return Waveforms(_core_of(_antinode.Waveforms, start, {**keys, **(changes or {})}))


def device_of(source: Union[Source, Device]) -> Device:
    """A device, or what makes one."""
    return source if isinstance(source, Device) else device(source)


def device_for(wanted: Union[Focus, Waveforms], source: Union[None, Source, Device], usual: str = "staple") -> Device:
    """The device that is given, else the one that a focus or waveforms name, else the usual one."""
    return device_of(source if source is not None else wanted._core.device or usual)


def focus_of(source: Union[Source, Focus]) -> Focus:
    """A focus, or what makes one."""
    return source if isinstance(source, Focus) else focus(source)


def waveforms_of(source: Union[Source, Waveforms]) -> Waveforms:
    """Waveforms, or what makes them."""
    return source if isinstance(source, Waveforms) else waveforms(source)


def names(kind: str = "device") -> list[str]:
    """The embedded names, sorted.

    Args:
        kind: 'device', 'focus' or 'waveforms'.

    Raises:
        InputError: another kind.
    """
    if kind not in ("device", "focus", "waveforms"):
        raise InputError(f"kind: is '{kind}'; allowed: 'device', 'focus', 'waveforms'")
    return _antinode.embedded_names(kind)
