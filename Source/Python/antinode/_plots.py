"""Figures of Matplotlib, which is loaded when the first one is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping

if TYPE_CHECKING:
    from ._antinode import Floats
    from ._documents import Device
    from ._tracks import Performed


def _figure(rows: int, columns: int, size: tuple[float, float]) -> Any:
    """A figure of its own, which no window manager knows: a notebook shows it, a script saves it."""
    from matplotlib.figure import Figure  # type: ignore[import]

    figure = Figure(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False)


def plot_values(is_plate: bool, points_m: Floats, values: Mapping[str, Floats], title: str, label: str) -> Any:
    """Values at points: curves over a line, maps of a plate."""
    x, y = points_m[:, 0] * 1e3, points_m[:, 1] * 1e3
    if not is_plate:
        figure, axes = _figure(1, 1, (7.6, 4.0))
        for name, each in values.items():
            axes[0, 0].plot(x, each, label=name)
        axes[0, 0].set(xlabel="x, mm", ylabel=label, title=title)
        axes[0, 0].legend()
        return figure
    figure, axes = _figure(1, len(values), (4.4 * len(values), 3.6))
    largest = max(float(abs(each).max()) for each in values.values())
    for axis, (name, each) in zip(axes[0], values.items()):
        drawn = axis.tricontourf(x, y, each, levels=41, vmin=-largest, vmax=largest, cmap="RdBu_r")
        axis.set(xlabel="x, mm", ylabel="y, mm", title=name, aspect="equal")
    figure.colorbar(drawn, ax=axes[0, -1], label=label)
    figure.suptitle(title)
    return figure


def plot_device(device: Device) -> Any:
    """The points of the surface and the ceramics, as its document has them."""
    from matplotlib.patches import Rectangle  # type: ignore[import]

    modes = device.modes()
    document = device.to_dict()
    figure, axes = _figure(1, 1, (7.6, 5.0 if modes._core.is_plate else 2.0))
    axis = axes[0, 0]
    axis.plot(modes.points_m[:, 0] * 1e3, modes.points_m[:, 1] * 1e3, ".", markersize=2, color="0.7")
    for ceramic in document.get("ceramics", []):
        if "size_x_mm" in ceramic:
            corner, size = (ceramic["x_mm"], ceramic["y_mm"]), (ceramic["size_x_mm"], ceramic["size_y_mm"])
        elif "length_mm" in ceramic:
            width = ceramic.get("width_mm", 0)
            corner, size = (ceramic["x_mm"] - ceramic["length_mm"] / 2, -width / 2), (ceramic["length_mm"], width)
        else:
            continue
        axis.add_patch(Rectangle(corner, *size, fill=False))
    axis.set(xlabel="x, mm", ylabel="y, mm", title=device.name, aspect="equal")
    return figure


def plot_fingers(performed: Performed) -> Any:
    """Displacements over time, one below the other, um."""
    count = len(performed.fingers)
    figure, axes = _figure(count, 1, (7.6, 1.2 + 1.3 * count))
    for finger, name in enumerate(performed.fingers):
        axis = axes[finger, 0]
        for values, first, label in (
            (performed.wanted_m[:, finger], 0, "wanted"),
            (performed.displacements_m[finger], -performed.trigger_sample, "reached"),
        ):
            times = [(first + sample) / performed.sample_rate_Hz * 1e3 for sample in range(len(values))]
            axis.plot(times, values * 1e6, label=label)
        axis.set(ylabel="um", title=name)
    axes[0, 0].legend()
    axes[-1, 0].set(xlabel="time, ms")
    return figure
