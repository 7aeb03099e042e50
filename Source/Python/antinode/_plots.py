"""Figures of Matplotlib, which is loaded when the first one is drawn."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping

from ._checks import word

if TYPE_CHECKING:
    from ._antinode import Estimated, Floats, Followed, Learnt, Mapped, Modes, Performed, Sensors, Tolerance, Tradeoff
    from ._documents import Device
    from ._psychometric import Psychometric


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
    figure, axes = _figure(1, 1, (7.6, 5.0 if modes._is_plate else 2.0))
    axis = axes[0, 0]
    axis.plot(modes.points_m[:, 0] * 1e3, modes.points_m[:, 1] * 1e3, ".", markersize=2, color="0.7")
    for ceramic in document.get("base", document).get("ceramics", []):
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


def plot_map(mapped: Mapped, number: str) -> Any:
    """A number by the place of the focus: a map of a plate, a curve over a line."""
    labels = {
        "captured": "captured",
        "v_score": "v-score",
        "field_error": "field error",
        "peak_voltage_V": "peak voltage, V",
        "spill_over": "modes beyond",
        "felt_contrast_dB": "felt contrast, dB",
    }
    word("number", number, list(labels))
    values = getattr(mapped, number)
    if len(mapped.y_mm) == 1:
        figure, axes = _figure(1, 1, (7.6, 4.0))
        axes[0, 0].plot(mapped.x_mm, values[0])
        axes[0, 0].set(ylabel=labels[number])
    else:
        figure, axes = _figure(1, 1, (7.6, 5.0))
        drawn = axes[0, 0].pcolormesh(mapped.x_mm, mapped.y_mm, values, shading="nearest")
        axes[0, 0].set(ylabel="y, mm", aspect="equal")
        figure.colorbar(drawn, ax=axes[0, 0], label=labels[number])
    axes[0, 0].set(xlabel="x of the focus, mm", title=f"{mapped.focus} on {mapped.device}")
    return figure


def plot_tolerance(tolerance: Tolerance) -> Any:
    """The share of devices with at most this field error."""
    figure, axes = _figure(1, 1, (7.6, 4.0))
    for design in tolerance.numbers["designs"]:
        errors = sorted(100 * draw["field_error"] for draw in design["draws"])
        shares = [100 * (count + 1) / len(errors) for count in range(len(errors))]
        axes[0, 0].step(errors, shares, where="post", label=f"{design['design']}, {design['peak_voltage_V']:.3g} V")
    axes[0, 0].set(xlabel="field error, %", ylabel="devices, %", title=f"{tolerance.design.focus}: tolerance")
    axes[0, 0].set_xlim(left=0)
    axes[0, 0].legend()
    return figure


def plot_tradeoff(tradeoff: Tradeoff) -> Any:
    """Peak voltage against time in motion by method, or against felt contrast."""
    figure, axes = _figure(1, 1, (7.6, 4.4))
    axis = axes[0, 0]
    points = [point for point in tradeoff.points if "failure" not in point]
    if any("method" in point for point in points):
        for method in dict.fromkeys(point["method"] for point in points):
            own = sorted(
                (point["time_in_motion_ms"], point["peak_voltage_V"]) for point in points if point["method"] == method
            )
            axis.plot([time for time, _ in own], [voltage for _, voltage in own], "o-", label=method)
        axis.axhline(tradeoff.numbers["lower_bound_voltage_V"], color="0.5", linestyle="--", label="lower bound")
        axis.set(xlabel="time in motion before the focus, ms", yscale="log")
        axis.legend()
    else:
        felt = [point for point in points if point["contrast_dB"] is not None]
        axis.plot([point["contrast_dB"] for point in felt], [point["peak_voltage_V"] for point in felt], "o-")
        axis.set(xlabel="felt contrast, dB")
    axis.set(ylabel="peak voltage, V", title=f"{tradeoff.numbers['focus']} on {tradeoff.numbers['device']}")
    return figure


def plot_sensors(sensors: Sensors) -> Any:
    """Information of one sensor by its place, and the chosen places."""
    x, y = sensors.candidates_mm[:, 0], sensors.candidates_mm[:, 1]
    bits = sensors.candidate_bits[: len(x)]
    figure, axes = _figure(1, 1, (7.6, 4.4))
    axis = axes[0, 0]
    if y.min() == y.max():
        axis.plot(x, bits)
        axis.set(ylabel="one sensor, bits")
        for rank, (place, _) in enumerate(sensors.places_mm, 1):
            axis.axvline(place, color="0.5", linestyle=":")
            axis.annotate(str(rank), (place, bits.max()))
    else:
        drawn = axis.scatter(x, y, c=bits, marker="s", s=12)
        figure.colorbar(drawn, ax=axis, label="one sensor, bits")
        axis.set(ylabel="y, mm", aspect="equal")
        for rank, place in enumerate(sensors.places_mm, 1):
            axis.annotate(str(rank), place, color="w", ha="center", va="center")
    axis.set(xlabel="x, mm", title="Where to listen")
    return figure


def plot_passes(learnt: Learnt) -> Any:
    """The estimated field error by pass."""
    figure, axes = _figure(1, 1, (7.6, 4.0))
    errors = [each["estimated_field_error_percent"] for each in learnt.passes]
    axes[0, 0].plot(range(1, len(errors) + 1), errors, "o-")
    axes[0, 0].set(xlabel="pass", ylabel="estimated field error, %", title=learnt.design.focus, xticks=range(1, len(errors) + 1))
    axes[0, 0].set_ylim(bottom=0)
    return figure


def plot_drift(followed: Followed) -> Any:
    """The common change of all frequencies over time, with gaps where it was not followed."""
    figure, axes = _figure(1, 1, (7.6, 4.0))
    changes = [
        change if state == "following" else float("nan") for change, state in zip(followed.common_ppm, followed.states)
    ]
    axes[0, 0].plot(followed.times_s, changes, "o-" if len(changes) < 100 else "-")
    axes[0, 0].set(xlabel="time, s", ylabel="change of all frequencies, ppm", title="Drift")
    return figure


def plot_responses(estimated: Estimated, reference: int) -> Any:
    """The RMS over all points of the responses of a reference."""
    import numpy as np

    figure, axes = _figure(1, 1, (7.6, 4.0))
    level = np.sqrt(np.nanmean(np.abs(estimated.responses(reference)) ** 2, axis=1))
    axes[0, 0].semilogy(estimated.frequencies_Hz, level)
    unit = "(m/s)/N" if estimated.hits else "(m/s)/V"
    axes[0, 0].set(xlabel="frequency, Hz", ylabel=f"velocity, {unit}", title=estimated.references[reference])
    return figure


def plot_psychometric(fitted: Psychometric) -> Any:
    """The share of positive answers by level, at each place, with its 95 % interval; areas of dots are trials."""
    figure, axes = _figure(1, 1, (7.6, 4.4))
    axis = axes[0, 0]
    for place, each in fitted.numbers["functions"].items():
        curve = each["curve"]
        (line,) = axis.plot(curve["levels_dB"], curve["value"], label=place)
        if None not in curve["lower_95"]:
            bounds = curve["lower_95"], curve["upper_95"]
            axis.fill_between(curve["levels_dB"], *bounds, color=line.get_color(), alpha=0.15)
        shares = [positive / trials for positive, trials in zip(each["positive"], each["trials"])]
        axis.scatter(each["levels_dB"], shares, [4 * trials for trials in each["trials"]], color=line.get_color())
        axis.axvline(each["threshold_dB"]["value"], color=line.get_color(), linestyle=":")
    against = ", dB above the reference" if fitted.numbers["task"] == "discrimination" else ", dB SL"
    positive = "answers 'yes'" if fitted.numbers["method"] == "yes/no" else "correct answers"
    axis.set(xlabel=f"level{against}", ylabel=f"share of {positive}", title=fitted.numbers["task"])
    axis.set_ylim(-0.03, 1.03)
    axis.legend()
    return figure


def plot_mode(modes: Modes, mode: int) -> Any:
    shape = {f"mode {mode}": modes.shapes[:, mode]}
    title = f"{modes.device}: mode {mode}, {modes.frequencies_Hz[mode]:.1f} Hz"
    return plot_values(modes._is_plate, modes.points_m, shape, title, "shape, kg$^{-1/2}$")
