"""Sweeps from Python and on Dask's workers come to the bytes of the command line."""

import json
import os
import pathlib
import signal
import threading

import numpy as np
import pytest

import antinode as an

RESULTS = ["report.html", "results.csv", "results.mat", "summary.json"]


def plan(cases=40):
    return {
        "schema": "antinode.sweep/1",
        "name": "places",
        "focus": "demonstrator",
        "scheme": "random",
        "cases": cases,
        "evaluate": "closed_form",
        "vary": [
            {"key": "focus.targets.0.x_mm", "uniform": {"minimum": 10, "maximum": 60}},
            {"key": "focus.allocation.method", "values": ["exact", "paper"]},
        ],
        "record": ["v_score_truncated", "field_error_truncated"],
    }


def contents(folder):
    return {name: (pathlib.Path(folder) / name).read_bytes() for name in RESULTS}


@pytest.fixture
def commanded(program, tmp_path):
    """The file of a plan and the folder that the command made of it."""
    file = tmp_path / "plan.json"
    file.write_text(json.dumps(plan()))
    program("sweep", file, "--out", tmp_path / "commanded", "--quiet")
    return file, tmp_path / "commanded"


@pytest.fixture(scope="module")
def cluster():
    """Two processes of one thread each on the loopback, which are started again where they end."""
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=True, host="127.0.0.1", dashboard_address=None
    ) as started:
        with distributed.Client(started) as client:
            yield client


def test_a_sweep_writes_the_folder_of_the_command(commanded, tmp_path):
    file, wanted = commanded
    swept = an.sweep(file, threads=2)
    swept.save(tmp_path / "saved")
    assert contents(tmp_path / "saved") == contents(wanted)
    an.sweep(file, folder=tmp_path / "kept")
    assert {each.relative_to(tmp_path / "kept") for each in (tmp_path / "kept").rglob("*")} == {
        each.relative_to(wanted) for each in wanted.rglob("*")
    }
    assert contents(tmp_path / "kept") == contents(wanted)


def test_a_plan_as_a_dict_is_that_of_its_file(commanded, tmp_path):
    an.sweep(plan()).save(tmp_path / "saved")
    assert contents(tmp_path / "saved") == contents(commanded[1])


def test_workers_of_dask_come_to_the_same_bytes(commanded, tmp_path, cluster):
    file, wanted = commanded
    heard = []
    an.sweep(file, cluster, progress=lambda what, share: heard.append(share)).save(tmp_path / "saved")
    assert contents(tmp_path / "saved") == contents(wanted)
    assert heard == sorted(heard) and heard[-1] == 1


def test_parts_are_computed_by_several_workers(cluster):
    """Where each part was computed, by the name of its worker; the scheduler keeps it for each finished task."""
    seen = set()

    def remember(what, share):
        seen.update(worker for workers in cluster.who_has().values() for worker in workers)

    an.sweep(plan(), cluster, progress=remember)
    assert len(seen) == 2


def test_a_worker_that_is_killed_changes_nothing(program, tmp_path, cluster):
    cases = 48
    file = tmp_path / "plan.json"
    file.write_text(json.dumps(plan(cases)))
    program("sweep", file, "--out", tmp_path / "commanded", "--quiet")
    # Asked before any is killed: one that is just starting again may leave the question unanswered.
    alive = list(cluster.run(os.getpid).values())
    killed = []

    def kill(what, share):
        if share > 0.2 * (len(killed) + 1) and len(killed) < 2:
            killed.append(alive[len(killed)])
            os.kill(killed[-1], signal.SIGKILL)

    an.sweep(file, cluster, progress=kill).save(tmp_path / "saved")
    assert len(killed) == 2
    assert contents(tmp_path / "saved") == contents(tmp_path / "commanded")


def test_a_worker_that_hangs_changes_nothing(commanded, tmp_path, cluster, monkeypatch):
    """Its task neither ends nor fails: Dask waits for it. The part is submitted again."""
    monkeypatch.setattr("antinode._sweeps.PATIENCE_S", 1)
    stopped = list(cluster.run(os.getpid).values())[0]

    def stop(what, share):
        os.kill(stopped, signal.SIGSTOP)

    try:
        an.sweep(commanded[0], cluster, progress=stop).save(tmp_path / "saved")
    finally:
        os.kill(stopped, signal.SIGCONT)
    assert contents(tmp_path / "saved") == contents(commanded[1])


def test_the_command_resumes_what_workers_have_begun(program, tmp_path, cluster):
    file = tmp_path / "plan.json"
    file.write_text(json.dumps(plan()))

    def stop(what, share):
        if share > 0.5:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        an.sweep(file, cluster, folder=tmp_path / "begun", progress=stop)
    parts = tmp_path / "begun" / "parts"
    before = {part.name: part.stat().st_mtime_ns for part in parts.iterdir()}
    assert 20 <= len(before) < 40
    program("sweep", file, "--out", tmp_path / "begun", "--quiet")
    program("sweep", file, "--out", tmp_path / "commanded", "--quiet")
    assert {name: (parts / name).stat().st_mtime_ns for name in before} == before
    assert contents(tmp_path / "begun") == contents(tmp_path / "commanded")


def test_values_are_those_of_the_table(commanded):
    swept = an.sweep(commanded[0])
    rows = [line.split(",") for line in (commanded[1] / "results.csv").read_text().splitlines()]
    assert rows[0] == ["case", *swept.keys, *swept.columns, "error"]
    assert swept.values.shape == (40, 2) and not swept.values.flags.writeable
    assert list(swept.column("focus.targets.0.x_mm")) == [float(row[1]) for row in rows[1:]]
    assert list(swept.column("v_score_truncated")) == [float(row[3]) for row in rows[1:]]
    assert set(swept.column("focus.allocation.method")) == {1, 2}
    assert swept.summary == json.loads((commanded[1] / "summary.json").read_text())
    assert swept.errors == {} and "places" in repr(swept) and "v_score_truncated" in str(swept)
    with pytest.raises(an.InputError, match="column: is 'voltage'"):
        swept.column("voltage")


def test_cases_that_cannot_be_computed_are_told(tmp_path):
    wide = plan(20)
    wide["vary"] = [{"key": "focus.targets.0.x_mm", "uniform": {"minimum": -200, "maximum": 200}}]
    swept = an.sweep(wide)
    far = {number for number, x_mm in enumerate(swept.column("focus.targets.0.x_mm")) if abs(x_mm) > 100}
    assert far and far <= set(swept.errors)
    assert all("x_mm" in swept.errors[number] for number in far)


def test_what_is_wrong_is_told_before_anything_is_written(tmp_path, program, cluster):
    wrong = {**plan(), "record": ["loudness"]}
    file = tmp_path / "plan.json"
    file.write_text(json.dumps(wrong))
    said = program("sweep", file, "--out", tmp_path / "out", fails=True)
    with pytest.raises(an.InputError) as error:
        an.sweep(file, cluster, folder=tmp_path / "out")
    assert str(error.value) in said
    assert not (tmp_path / "out").exists()
    with pytest.raises(an.InputError, match="threads"):
        an.sweep(plan(), threads=0)
    with pytest.raises(an.InputError, match="threads"):
        an.sweep(plan(), cluster, threads=2)


def test_a_folder_of_another_plan_is_refused(tmp_path):
    an.sweep(plan(3), folder=tmp_path / "out")
    with pytest.raises(an.InputError, match="another plan"):
        an.sweep(plan(4), folder=tmp_path / "out")


def test_ctrl_c_ends_a_sweep_and_its_parts_stay(tmp_path):
    signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(1.0, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        an.sweep(plan(100000), folder=tmp_path / "out")
    assert not (tmp_path / "out" / "summary.json").exists() and (tmp_path / "out" / "plan.json").exists()


def varying(*entries):
    return {"schema": "antinode.sweep/1", "focus": "demonstrator", "record": ["v_score"], "vary": list(entries)}


def circle(name):
    return {"key": f"device.{name}", "uniform": {"minimum": -np.pi, "maximum": np.pi}}


def test_a_latin_hypercube_has_each_share_once_and_a_sobol_sequence_is_even():
    two = varying(*({"key": f"focus.{name}", "uniform": {"minimum": 0, "maximum": 1}} for name in "ab"))
    (listed,) = an.sampled(two, "latin_hypercube", 97)["vary"]
    for column in np.transpose(listed["values"]):
        assert sorted((column * 97).astype(int)) == list(range(97))
    places = np.array(an.sampled(two, "sobol", 256)["vary"][0]["values"])
    corners = np.stack(np.meshgrid(*[np.arange(1, 21) / 20] * 2), axis=-1).reshape(-1, 2)
    inside = (places[None] < corners[:, None]).all(axis=2).mean(axis=1)
    assert abs(inside - corners.prod(axis=1)).max() < 0.02  # Its order is log (N)^2 / N.


def test_sampled_values_are_those_of_the_entries():
    plan = an.sampled(
        varying(
            {"keys": ["focus.a", "device.b"], "normal": {"mean": 3, "standard_deviation": 1, "minimum": 2}, "times": [1, -2], "plus": [0, 7]},
            {"keys": ["focus.c", "focus.d"], "values": [[1, "x"], [2, "y"]]},
            {"key": "focus.e", "from": 0.1, "to": 100, "count": 4, "spacing": "logarithmic"},
        ),
        "sobol",
        64,
        seed=3,
    )
    (listed,) = plan["vary"]
    assert listed["keys"] == ["focus.a", "device.b", "focus.c", "focus.d", "focus.e"] and plan["seed"] == 3
    a, b, c, d, e = zip(*listed["values"])
    assert np.allclose(b, 7 - 2 * np.array(a)) and min(a) >= 2 and np.median(a) == pytest.approx(3.1, abs=0.3)
    assert set(zip(c, d)) == {(1, "x"), (2, "y")} and np.allclose(sorted(set(e)), [0.1, 1, 10, 100])
    swept = an.sweep(an.sampled(plan_of_places(), "sobol", 8))
    assert swept.keys == ["focus.targets.0.x_mm", "focus.allocation.method"] and len(swept.values) == 8


def plan_of_places():
    return {key: value for key, value in plan().items() if key not in ("scheme", "cases")}


def test_indices_of_ishigamis_function_are_those_of_its_closed_form():
    """Ishigami and Homma 1990: variances of the parts."""
    a, b = 7, 0.1
    first, second = 0.5 * (1 + b * np.pi**4 / 5) ** 2, a**2 / 8
    both = b**2 * np.pi**8 * (1 / 18 - 1 / 50)
    shares = {"x": (first, first + both), "y": (second, second), "z": (0, both)}
    (listed,) = an.sampled(varying(*map(circle, shares)), "saltelli", 4096)["vary"]
    x, y, z = np.transpose(listed["values"])
    results = np.sin(x) + a * np.sin(y) ** 2 + b * z**4 * np.sin(x)
    indices = an.sobol_indices(results, list(shares))
    for key, expected in shares.items():
        for order, share in zip(("first", "total"), np.array(expected) / (first + second + both)):
            index = indices[key][order]
            assert index["value"] == pytest.approx(share, abs=0.01)
            assert index["lower_95"] <= share <= index["upper_95"] < index["lower_95"] + 0.15
    results[3::400] = np.nan
    assert an.sobol_indices(results, list(shares))["y"]["total"]["value"] == pytest.approx(indices["y"]["total"]["value"], abs=0.02)


@pytest.mark.parametrize(
    "make, part",
    [
        (lambda: an.sampled(varying(circle("x")), "even", 8), "saltelli"),
        (lambda: an.sampled(varying(), "sobol", 8), "varies nothing"),
        (lambda: an.sampled(varying(circle("x")), "saltelli", 100_000), "33333"),
        (lambda: an.sampled(varying({"key": "focus.a"}), "sobol", 8), "says not"),
        (lambda: an.sampled({**varying(circle("x")), "set": {"deviation.damping_spread_percent": 3}}, "saltelli", 8), "each mode's own"),
        (lambda: an.sobol_indices(np.ones(30), ["x"]), "do not vary"),
        (lambda: an.sobol_indices(np.ones(31), ["x"]), "multiple of 3"),
    ],
)
def test_what_cannot_be_sampled_is_refused_in_a_sentence(make, part):
    with pytest.raises(an.InputError, match="allowed") as refused:
        make()
    assert part in str(refused.value)
