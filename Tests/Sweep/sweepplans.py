"""The plans of the tests of sweeps on several processes."""


def tolerance(cases):
    """Devices around the demonstrator: frequency, damping and participation of each mode, the voltage of each case; under a millisecond a case."""
    return {"schema": "antinode.sweep/1", "name": "tolerance", "focus": "demonstrator", "scheme": "random", "cases": cases, "evaluate": "closed_form",
            "set": {"deviation.frequency_spread_percent": 0.1, "deviation.damping_spread_percent": 10, "deviation.participation_spread_percent": 5},
            "vary": [{"key": "deviation.voltage_percent", "normal": {"mean": 0, "standard_deviation": 1}}],
            "record": ["v_score_truncated", "field_error_truncated", "peak_ratio_truncated", "v_score"], "points_mm": [[24, 0], [60, 0]]}


def places(cases):
    """A design for each case, some 30 ms: long enough for kills to hit tasks."""
    return {"schema": "antinode.sweep/1", "name": "places", "focus": "demonstrator", "scheme": "random", "cases": cases, "evaluate": "closed_form",
            "vary": [{"key": "focus.targets.0.x_mm", "uniform": {"minimum": 10, "maximum": 60}}],
            "record": ["v_score_truncated", "field_error_truncated"]}


RESULTS = ["results.csv", "results.mat", "summary.json", "report.html"]


def contents(folder):
    """The bytes of a sweep's results."""
    return {name: (folder / name).read_bytes() for name in RESULTS}
