"""The tables and figures of Enferad et al., J. Sound Vib. 449 (2019) 196-213, as Antinode computes them.

The geometry of the device in print is inferred from its frequencies, so its numbers are a reference, not a target.
``python3 paper.py FOLDER`` prints the tables and writes the figures; the notebook ``paper`` shows both.
"""

import itertools
import pathlib
import sys
from types import SimpleNamespace

import numpy as np
from matplotlib.figure import Figure

import antinode as an

# Tables C.1 (captured) and C.2 (v-scores as measured; none where the print has one number five times), places P1 to P5.
SHAPES = {
    "sinc25": SimpleNamespace(name="sinc 25 mm", modes=6, captured=[0.6831, 0.9418, 0.9755, 0.9359, 0.7124], v_score=None),
    "sinc18": SimpleNamespace(
        name="sinc 18 mm",
        modes=9,
        captured=[0.8833, 0.9868, 0.9838, 0.9887, 0.9757],
        v_score=[0.9792, 0.9885, 0.9902, 0.9611, 0.9945],
    ),
    "sinc10": SimpleNamespace(
        name="sinc 10 mm",
        modes=16,
        captured=[0.9521, 0.9948, 0.9897, 0.9928, 0.9981],
        v_score=[0.8771, 0.9768, 0.9759, 0.9386, 0.9739],
    ),
    "bump25": SimpleNamespace(
        name="bump 25 mm",
        modes=7,
        captured=[0.8285, 0.9727, 0.9544, 0.9816, 0.8717],
        v_score=[0.9877, 0.9953, 0.9911, 0.9609, 0.9973],
    ),
}
PLACES_MM = [-46, -24, 0, 24, 46]
GROWTHS = [None, 1, 4]  # None: chosen by the program.
DETUNINGS = [(0.25, 10, 5), (0.1, 10, 5), (0.5, 20, 10)]  # Frequency, damping, participation: deviations in %.
NO_LIMIT_V = 1e5
STUDIED_MODES = [0, 3]  # The print counts those that its vibrometer saw; the sway mode is left out.


def cell(shape, place):
    """One cell of the tables: a shape at P1 to P5 (from 0), designed and played in each way."""
    name = f"paper-{shape}-p{place + 1}"
    played = {method: an.render(an.focus(name, method=method), duration_ms=27.5) for method in ("exact", "paper")}
    design = played["exact"].design
    peaks = {
        (growth, drive): least_norm(name, {"transients.drive": drive, "transients.growth": growth}).peak_voltage_V
        for growth in GROWTHS
        for drive in ("paper", "offset_free")
    }
    detuned = [
        float(np.median(an.tolerance(design, draws=51, frequency_percent=f, damping_percent=d, participation_percent=p).v_scores))
        for f, d, p in DETUNINGS
    ]
    return SimpleNamespace(**played, peaks=peaks, detuned=detuned, needed=modes_needed(name, SHAPES[shape].captured[place]))


def least_norm(focus, changes):
    """The design by rows (29) where no limit binds."""
    limits = {"limits.voltage_V": NO_LIMIT_V, "limits.full_scale_V": NO_LIMIT_V}
    return an.design(an.focus(focus, method="paper", voltage_limit_V=NO_LIMIT_V, changes=changes), an.device(changes=limits))


def modes_needed(focus, captured):
    """How many modes, by energy, capture as much as the print does; 0 where all of them do not."""
    try:
        design = least_norm(focus, {"modes": {"captured": captured}})
    except an.InputError:
        return 0
    return len(design.numbers["controlled_modes"])


def all_cells():
    return {(shape, place): cell(shape, place) for shape in SHAPES for place in range(5)}


def with_ceramics(chosen):
    """The demonstrator's modes, of which only these ceramics play."""
    modes = an.device("staple").modes()
    listed = [
        {"frequency_Hz": f, "damping_ratio": d, "participation_per_V": p, "shape": s}
        for f, d, p, s in zip(modes.frequencies_Hz, modes.damping_ratios, modes.participation[:, chosen], modes.shapes.T)
    ]
    return an.device(
        {
            "schema": "antinode.device/1",
            "kind": "modal",
            "name": " and ".join(modes.ceramics[i] for i in chosen),
            "points_mm": modes.points_m * 1e3,
            "weights_kg": modes.masses_kg,
            "modes": listed,
            "limits": {"voltage_V": 10_000},
            "covers_whole_body": True,
        }
    )


def two_modes(velocity_mm_s=20):
    """Targets whose sum is the two modes alone, each with this velocity at the centre: the least sum of 40 Gaussians."""
    modes = an.device("staple").modes()
    x = modes.points_m[:, 0] * 1e3
    centres = np.linspace(x.min(), x.max(), 40)
    fields = np.exp(-4 * np.log(2) * ((x[:, None] - centres) / 12) ** 2)
    projected = modes.shapes.T @ (modes.masses_kg[:, None] * fields)  # Paper (24).
    wanted = np.zeros(len(modes))
    wanted[STUDIED_MODES] = velocity_mm_s / modes.shapes_at(0)[STUDIED_MODES]
    heights = np.linalg.lstsq(projected, wanted, rcond=1e-3)[0]
    return [
        {"shape": "gaussian", "width_mm": 12, "x_mm": c, "peak_velocity_mm_s": abs(h), "phase": 1 if h > 0 else -1}
        for c, h in zip(centres, heights)
        if abs(h) > 1e-3
    ]


def two_mode_focus(targets, drive, limit_V, growth=(4, 1)):
    """As the print has it: ten cycles of the first mode take 26 ms here, so the later of its two instants."""
    return an.focus(
        {
            "schema": "antinode.focus/1",
            "name": "two modes",
            "targets": targets,
            "focus_time_ms": 50,
            "modes": {"count": 2},
            "transients": {"drive": drive, "growth": growth, "cycles": [10, 25]},
            "allocation": {"method": "paper", "voltage_limit_V": limit_V},
        }
    )


def one_ceramic_per_mode(design, modes, limit_V):
    """The drives of a design, each mode's by the ceramic that moves it most, and what remains of them within a limit."""
    wanted = {each["mode"] - 1: each["wanted_velocity_m_s_sqrt_kg"] for each in design.numbers["controlled_modes"]}
    time = np.arange(0, 0.06, 1 / 192_000)
    voltages = np.zeros((modes.participation.shape[1], time.size))
    for each in design.oscillations:
        participation = modes.participation[each["mode"]]
        ceramic = abs(participation).argmax()
        since = np.clip(time, each["start_s"], each["end_s"]) - each["start_s"]
        angle = each["angular_frequency_rad_s"] * since
        wave = np.exp(each["growth_per_s"] * since) * (each["in_phase"] * np.sin(angle) + each["quadrature"] * np.cos(angle))
        wave[(time < each["start_s"]) | (time >= each["end_s"])] = 0
        voltages[ceramic] += wanted[each["mode"]] / participation[ceramic] * wave
    return time, np.clip(voltages, -limit_V, limit_V), abs(voltages).max()


def played_by(modes, time, voltages, focus_time=0.05):
    """The modal velocities at the focus under voltages that are held from sample to sample (Docs/Theory.md, section 3.1)."""
    decay = modes.damping_ratios * modes.angular_frequencies_rad_s
    damped = np.sqrt(modes.angular_frequencies_rad_s**2 - decay**2)
    poles, step = (-decay + 1j * damped)[:, None], time[1] - time[0]
    before = time < focus_time - step / 2
    kept = (1 - np.exp(-poles * step)) / poles * np.exp(poles * (focus_time - time[before]))
    states = (kept * (modes.participation @ voltages[:, before])).sum(axis=1)
    return states.real - decay / damped * states.imag


def unallocated(targets, drive, limit_V, pair):
    """As if it had been rendered."""
    design, modes = an.design(two_mode_focus(targets, drive, 10_000), pair), pair.modes()
    time, voltages, peak = one_ceramic_per_mode(design, modes, limit_V)
    velocities = played_by(modes, time, voltages)[:, None]
    return SimpleNamespace(times_s=time, voltages_V=voltages, modal_velocities=velocities, focus_sample=0, design=design), peak


def two_mode_study():
    """Both drives, 20 and 50 V, each mode by one ceramic or allocated, on the pair of ceramics with the least peak."""
    targets = two_modes()
    free = two_mode_focus(targets, "offset_free", 10_000)
    pair = min(
        map(with_ceramics, map(list, itertools.combinations(range(8), 2))),
        key=lambda device: an.design(free, device).peak_voltage_V,
    )
    cases = []
    for drive, limit, is_allocated in itertools.product(("paper", "offset_free"), (20, 50), (False, True)):
        case = SimpleNamespace(drive=drive, limit_V=limit, is_allocated=is_allocated, rendered=None, peak_V=0.0)
        try:
            if is_allocated:
                design = an.design(two_mode_focus(targets, drive, limit), pair)
                case.rendered, case.peak_V = an.render(design), design.peak_voltage_V
            else:
                case.rendered, case.peak_V = unallocated(targets, drive, limit, pair)
        except an.LimitError as error:
            case.peak_V = error.minimum_peak_voltage_V
        cases.append(case)
    return SimpleNamespace(pair=pair.name, frequencies_Hz=pair.modes().frequencies_Hz[STUDIED_MODES], cases=cases)


def outcome(case):
    if case.rendered is None:
        return f"needs at least {case.peak_V:.4g} V; the limit allows {40 * case.limit_V / case.peak_V:.4g} mm/s"
    return f"needs {case.peak_V:.4g} V and is clipped" if case.peak_V > case.limit_V else f"peak {case.peak_V:.4g} V"


def table(caption, rows):
    """Text with columns as wide as their widest cell."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    return "\n".join([caption, *("  " + "  ".join(map(str.ljust, row, widths)).rstrip() for row in rows), ""])


def tables(cells, study):
    """All tables as text: ours beside the print."""

    def by_place(caption, text):
        rows = [["shape", "P1", "P2", "P3", "P4", "P5"]]
        for shape, of_print in SHAPES.items():
            rows.append([of_print.name, *(text(cells[shape, place], of_print, place) for place in range(5))])
        return table(caption, rows)

    def both(key, digits):
        return lambda c, *_: f"{c.paper.scores[key]:.5f} / {c.exact.scores[key]:.{digits}f}"

    def drives(growth):
        def text(c, *_):
            ours, free = c.peaks[growth, "paper"], c.peaks[growth, "offset_free"]
            return f"{ours:.1f} / {free:.1f} ({ours / free:.2f})"

        return by_place(f"Minimum norm of (29), V, growth {growth or 'chosen'}: paper's drive / offset-free (ratio)", text)

    def detuned(level):
        def text(c, of_print, place):
            return f"{c.detuned[level]:.4f} / " + (f"{of_print.v_score[place]:.4f}" if of_print.v_score else "-")

        spread = "{} % frequency, {} % damping, {} % participation".format(*DETUNINGS[level])
        return by_place(f"Table C.2, v-score on detuned plates ({spread}; median of 51): ours / measured", text)

    first, second = study.frequencies_Hz
    rows = [["drive", "limit", "allocation", "outcome"]]
    for case in study.cases:
        how = "rows (29) within the limit" if case.is_allocated else "one ceramic per mode"
        rows.append([case.drive, f"{case.limit_V} V", how, outcome(case)])
    return [
        by_place("Table C.1, captured: ours / print", lambda c, p, i: f"{c.exact.scores['captured']:.4f} / {p.captured[i]:.4f}"),
        by_place("Modes needed, by energy, to reach Table C.1 / the print's count", lambda c, p, i: f"{c.needed or 'none'} / {p.modes}"),
        by_place("v-score against the truncated field: rows (29) / exact", both("v_score_truncated", 6)),
        by_place("Field error against the truncated field: rows (29) / exact", both("field_error_truncated", 5)),
        by_place(
            "Peak voltage, V: exact / minimum norm of (29)",
            lambda c, *_: f"{c.exact.design.peak_voltage_V:.2f} / {c.peaks[None, 'offset_free']:.2f}",
        ),
        *map(drives, GROWTHS),
        *map(detuned, range(len(DETUNINGS))),
        table(f"Two modes ({first:.4g} and {second:.4g} Hz, 20 mm/s each at the centre) with {study.pair}", rows),
    ]


def grid(rows, columns, size):
    figure = Figure(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False)


def growth_figure():
    """Fig. 3: how two modes grow to their velocity at the focus under the paper's drive, for three growths."""
    modes = an.device("staple").modes()
    targets = two_modes()
    figure, axes = grid(1, 2, (9.6, 4))
    for growth in (1, 4, 10):
        focus = two_mode_focus(targets, "paper", 10_000, [growth, growth])
        drives = an.design(focus, with_ceramics(range(8))).oscillations
        for axis, mode in zip(axes[0], STUDIED_MODES):
            decay = modes.damping_ratios[mode] * modes.angular_frequencies_rad_s[mode]
            damped = np.sqrt(modes.angular_frequencies_rad_s[mode] ** 2 - decay**2)
            mine = [each for each in drives if each["mode"] == mode]
            time = np.linspace(0, 0.05 - mine[0]["start_s"], 4000)
            state = sum(response(-decay + 1j * damped, each, time) for each in mine)
            velocity = state.real - decay / damped * state.imag
            axis.plot(time * 1e3, velocity / velocity[-1], label=f"growth {growth}")
            axis.set(title=f"{modes.frequencies_Hz[mode]:.0f} Hz", xlabel="time from the start of the mode, ms")
    axes[0, 0].set_ylabel("velocity / velocity at the focus")
    axes[0, 0].legend()
    return figure


def response(pole, drive, time):
    """The state z of dz/dt = pole z + drive, in closed form (Docs/Theory.md, section 3.1)."""
    rate = drive["growth_per_s"] + 1j * drive["angular_frequency_rad_s"]
    half = (drive["quadrature"] - 1j * drive["in_phase"]) / 2
    return sum(a / (s - pole) * (np.exp(s * time) - np.exp(pole * time)) for a, s in ((half, rate), (half.conjugate(), rate.conjugate())))


def case_title(case):
    return f"{case.drive}, {case.limit_V} V, " + ("allocated" if case.is_allocated else "one ceramic per mode")


def two_mode_voltages(study):
    """Fig. 4, 9 and 10: the voltages of two ceramics for two modes, within 20 V and 50 V."""
    figure, axes = grid(4, 2, (9.6, 10))
    for axis, case in zip(axes.flat, study.cases):
        axis.set(title=case_title(case) + ("" if case.rendered else ": infeasible"), ylabel="V")
        if case.rendered:
            axis.plot(case.rendered.times_s * 1e3, case.rendered.voltages_V.T)
    return figure


def bars(axis, rendered):
    """The modal velocities at the focus: reached as bars, wanted as marks."""
    reached = rendered.modal_velocities[:, rendered.focus_sample]
    wanted = {each["mode"]: each["wanted_velocity_m_s_sqrt_kg"] for each in rendered.design.numbers["controlled_modes"]}
    last = max(wanted) + 4
    axis.bar(range(1, last + 1), reached[:last] * 1e3)
    axis.plot(list(wanted), np.array([*wanted.values()]) * 1e3, "k_")


def two_mode_spectra(study):
    """Fig. 11: the modal velocities at the focus in the same eight cases."""
    figure, axes = grid(4, 2, (9.6, 10))
    for axis, case in zip(axes.flat, study.cases):
        axis.set(title=case_title(case) + ("" if case.rendered else ": infeasible"), ylabel="mm/s kg^1/2")
        if case.rendered:
            bars(axis, case.rendered)
    return figure


def cells_figure(cells, shapes, draw, label):
    """A row per shape, a column per place."""
    figure, axes = grid(len(shapes), 5, (12, 1.4 + 1.9 * len(shapes)))
    for i, shape in enumerate(shapes):
        for place in range(5):
            draw(axes[i, place], cells[shape, place].exact)
        axes[i, 0].set_ylabel(SHAPES[shape].name)
    for axis, place in zip(axes[0], PLACES_MM):
        axis.set_title(f"{place} mm")
    figure.supxlabel(label)
    return figure


def fields(axis, rendered):
    """Wanted, truncated and reached field, mm/s."""
    x = rendered.points_m[:, 0] * 1e3
    axis.plot(x, rendered.wanted_field_m_s * 1e3, ":", x, rendered.represented_field_m_s * 1e3, "--")
    axis.plot(x, rendered.reached_field_m_s * 1e3, linewidth=0.8)


def field_figures(cells):
    """Fig. 12, 13 and 17: the twenty fields and their modal velocities."""
    names = list(SHAPES)
    return {
        "figure-12": cells_figure(cells, names[:3], fields, "position, mm; velocity, mm/s: wanted, truncated, reached"),
        "figure-13": cells_figure(cells, names, bars, "mode; modal velocity, mm/s kg^1/2: reached (bars), wanted (marks)"),
        "figure-17": cells_figure(cells, names[3:], fields, "position, mm; velocity, mm/s: wanted, truncated, reached"),
    }


def time_figures():
    """Fig. 14 to 16: the strongest modes, the spectrogram, and the field around a focus after 25 and 50 ms."""
    early, late = (an.render(an.focus("paper-sinc25-p4", focus_time_ms=time)) for time in (25, 50))
    figures = {}
    figures["figure-14"], axes = grid(1, 1, (9.6, 4.8))
    strongest = np.argsort(-abs(early.modal_velocities[:, early.focus_sample]))[:5]
    for mode in np.sort(strongest):
        axes[0, 0].plot(early.times_s * 1e3, early.modal_velocities[mode] * 1e3, label=f"mode {mode + 1}", linewidth=0.8)
    axes[0, 0].set(xlabel="ms", ylabel="modal velocity, mm/s kg^1/2")
    axes[0, 0].legend()
    figures["figure-15"], axes = grid(1, 1, (9.6, 4.2))
    axes[0, 0].specgram(early.probe_velocities_m_s[0], NFFT=1024, noverlap=960, Fs=early.sample_rate_Hz / 1e3, xextent=None)
    axes[0, 0].set(ylim=(0, 12), xlabel="ms", ylabel="kHz")
    modes = an.device("staple").modes()
    line = np.argsort(modes.points_m[:, 0])[::8]
    for name, rendered in (("figure-16a", early), ("figure-16b", late)):
        figures[name], axes = grid(1, 1, (9.6, 4.8))
        reach = int(1.5e-3 * rendered.sample_rate_Hz)
        around = slice(rendered.focus_sample - reach, rendered.focus_sample + reach + 1)
        field = modes.shapes[line] @ rendered.modal_velocities[: len(modes), around] * 1e3
        x, time = modes.points_m[line, 0] * 1e3, (rendered.times_s[around] - rendered.times_s[rendered.focus_sample]) * 1e3
        drawn = axes[0, 0].pcolormesh(x, time, field.T, cmap="RdBu_r", vmin=-40, vmax=40, shading="nearest")
        axes[0, 0].set(xlabel="position, mm", ylabel="time from the focus, ms")
        figures[name].colorbar(drawn, label="mm/s")
    return figures


def figures(cells, study):
    """All figures by the names of their files."""
    two = {"figure-03": growth_figure(), "figure-09": two_mode_voltages(study), "figure-11": two_mode_spectra(study)}
    return {**two, **field_figures(cells), **time_figures()}


def check(cells, study):
    """What holds on this geometry, else an AssertionError: a capture is short in three cells, by at most 0.026."""
    captured = fine = 0
    for (shape, place), each in cells.items():
        of_print, exact, design = SHAPES[shape], each.exact.scores, each.exact.design
        assert exact["modes_controlled"] == of_print.modes
        assert exact["captured"] >= of_print.captured[place] - 0.026
        captured += exact["captured"] >= of_print.captured[place]
        assert each.paper.scores["v_score_truncated"] >= (0.997 if shape == "sinc10" else 0.999)
        assert exact["v_score_truncated"] >= 0.9999 and exact["field_error_truncated"] <= 1e-2
        fine += exact["field_error_truncated"] <= 2e-3
        assert design.numbers["lower_bound_voltage_V"] < design.peak_voltage_V <= 1.1 * each.peaks[None, "offset_free"]
        assert of_print.v_score is None or each.detuned[0] >= of_print.v_score[place]
    assert len(cells) == 20 and captured >= 17 and fine >= 12
    assert len(study.cases) == 8
    for case in study.cases:
        if case.is_allocated and case.rendered:
            assert case.peak_V <= case.limit_V * (1 + 1e-9) and case.rendered.scores["field_error_truncated"] < 0.1
        elif case.is_allocated:
            assert case.peak_V > case.limit_V
    # Offset-free, 50 V is enough; with the paper's constant it is not.
    allocated = {(case.drive, case.limit_V): case.rendered for case in study.cases if case.is_allocated}
    assert allocated["offset_free", 50] and not allocated["paper", 50]


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "antinode-paper")
    folder.mkdir(parents=True, exist_ok=True)
    everything = all_cells(), two_mode_study()
    check(*everything)
    print(*tables(*everything), sep="\n")
    for name, figure in figures(*everything).items():
        figure.savefig(folder / f"{name}.png", dpi=150)
