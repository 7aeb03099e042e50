"""The psychometric function: of the answers of an experiment, and of observers that are simulated."""

from __future__ import annotations

import io
import json
import os
import random
from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence, Union

from ._checks import within
from ._documents import Folder
from ._events import NOTHING, described, rows
from ._procedures import QuestPlus, QuestTrack
from ._tasks import Trial
from .errors import InputError

if TYPE_CHECKING:
    from ._antinode import Floats

PARAMETERS = ("threshold_dB", "slope", "guess_rate", "lapse_rate")


def weibull(
    levels_dB: Any, threshold_dB: Any, slope: Any, guess_rate: Any, lapse_rate: Any, is_linear: bool = False
) -> Any:
    """The share of positive answers.

    1 - lapse - (1 - guess - lapse) exp (-10 ** (slope (level - threshold) / 20)); where levels are differences
    (``is_linear``), exp (-(level / threshold) ** slope) instead.

    Source: A. B. Watson, J. Vision 17(3), 10 (2017); as ``dB`` and ``linear`` of questplus.
    """
    import numpy as np

    strength = np.exp(np.minimum(slope * _distances(levels_dB, threshold_dB, is_linear), 7))
    return 1 - lapse_rate - (1 - guess_rate - lapse_rate) * np.exp(-strength)


def _distances(levels_dB: Any, threshold_dB: Any, is_linear: bool) -> Any:
    """Logarithms of the amplitudes over that of the threshold."""
    import numpy as np

    if is_linear:
        return np.log(np.maximum(levels_dB, 1e-12) / threshold_dB)
    return (np.asarray(levels_dB, float) - threshold_dB) * (np.log(10) / 20)


class SimulatedObserver:
    """Answers as a person with a known psychometric function would: for rehearsals.

    Args:
        threshold_dB: at 1 - 1/e of the way from guess to lapse rate; a dict: by the name of the place.
        slope: of Weibull's function (Watson 2017).
        lapse_rate, false_alarm_rate: wrong answers to strong stimuli; 'yes' without a stimulus.
        seed: the answer to a trial follows from it and from the number of the trial.
    """

    def __init__(
        self,
        threshold_dB: Union[float, Mapping[str, float]] = 20.0,
        slope: float = 2.0,
        *,
        lapse_rate: float = 0.0,
        false_alarm_rate: float = 0.0,
        seed: int = 1,
    ) -> None:
        self._threshold_dB = threshold_dB
        self._slope, self._lapse_rate, self._false_alarm_rate, self._seed = slope, lapse_rate, false_alarm_rate, seed

    def __call__(self, trial: Trial) -> str:
        numbers = random.Random(f"{self._seed} {trial.number}")
        yes_or_no = trial.choices == ("yes", "no")
        guess_rate = self._false_alarm_rate if yes_or_no else 1 / len(trial.choices)
        if trial.level is None:
            return trial.choices[numbers.random() >= guess_rate] if yes_or_no else numbers.choice(trial.choices)
        every = self._threshold_dB
        threshold = every[trial.place] if isinstance(every, Mapping) else every
        is_linear = trial.trial_type == "discrimination"
        share = weibull(trial.level, threshold, self._slope, guess_rate, self._lapse_rate, is_linear)
        if numbers.random() < share and trial.expected is not None:
            return trial.expected
        return numbers.choice([choice for choice in trial.choices if choice != trial.expected])


class Psychometric:
    """Fitted psychometric functions. Made by :func:`antinode.experiment.fit`.

    Attributes:
        numbers: what ``psychometric.json`` has: ``functions`` by place ('all' of a localisation) with ``threshold_dB``,
            ``slope``, ``guess_rate``, ``lapse_rate``, each as ``value``, ``lower_95``, ``upper_95``, the ``levels_dB``
            with their ``trials`` and ``positive`` answers, and ``quest_plus``, the mean of its posterior; ``catch``,
            ``missed``, ``limited``: trials of these kinds; ``confusions``: of a localisation, how often each place
            (first key) was answered as each (second key).
    """

    def __init__(self, numbers: dict[str, Any]) -> None:
        self.numbers = numbers

    def plot(self) -> Any:
        """The functions with their 95 % intervals and the answers, as a Matplotlib figure."""
        from ._plots import plot_psychometric

        return plot_psychometric(self)

    def _repr_png_(self) -> bytes:
        stream = io.BytesIO()
        self.plot().savefig(stream, format="png", dpi=100)
        return stream.getvalue()

    def save(self, folder: Folder) -> None:
        """Writes ``psychometric.json`` and ``psychometric.png``."""
        os.makedirs(folder, exist_ok=True)
        with open(os.path.join(folder, "psychometric.json"), "w", encoding="utf-8") as stream:
            stream.write(json.dumps(self.numbers, indent=2) + "\n")
        with open(os.path.join(folder, "psychometric.png"), "wb") as picture:
            picture.write(self._repr_png_())

    def __str__(self) -> str:
        return "\n".join(
            f"{place}: threshold {found['threshold_dB']['value']:.1f} dB"
            f" ({found['threshold_dB']['lower_95']:.1f} to {found['threshold_dB']['upper_95']:.1f}),"
            f" slope {found['slope']['value']:.1f}"
            for place, found in self.numbers["functions"].items()
        )

    def __repr__(self) -> str:
        return f"<antinode.experiment.Psychometric of {', '.join(self.numbers['functions'])}>"


def fit(folder: Folder, *, resamples: int = 500, seed: int = 1) -> Psychometric:
    """The psychometric function of each place, by maximum likelihood, from the table of an experiment.

    The guess rate is 1/k of a forced choice among k; of yes/no it is fitted together with the catch trials, or, where
    there are none, to at most 0.06. The lapse rate is at most 0.06, the slope 0.5 to 10. Trials that were missed or
    limited are left out.

    Args:
        folder: that of :func:`run`, also while it runs.
        resamples: of the parametric bootstrap, 0 to 100 000; 0: no intervals.
        seed: of the bootstrap.

    Returns:
        :class:`Psychometric`: ``numbers``, ``plot()``, ``save(folder)``.

    Raises:
        InputError: the folder has no experiment, or answers at fewer than two levels.

    Source: F. A. Wichmann and N. J. Hill, Percept. Psychophys. 63, 1293 and 1314 (2001). Needs SciPy.
    """
    within("resamples", resamples, 0, 100_000)
    task = described(folder)["task"]
    name, method = task["name"], task.get("method", "AFC")
    tally = _Tally(folder, task)
    guess_rate = {"2AFC": 0.5, "yes/no": None, "AFC": 1 / len(task["places"])}[method]
    functions = {}
    for number, (place, counts) in enumerate(tally.counts.items()):
        if len(counts) < 2:
            raise InputError(f"{place}: has answers at {len(counts)} level; allowed: 2 or more")
        data = _Data(counts, tally.catch.get(place, [0, 0]), guess_rate, name == "discrimination")
        functions[place] = data.fitted(resamples, [seed, number])
        if task["procedure"]["name"] == "QuestPlus":
            functions[place]["quest_plus"] = _posterior_mean(task["procedure"], counts, guess_rate, name)
    if not functions:
        raise InputError(f"{os.fspath(folder)}: has no answers; allowed: answers at 2 levels or more")
    numbers = {"task": name, "method": method, "functions": functions, **tally.left_out}
    return Psychometric({**numbers, "confusions": tally.confusions} if name == "localisation" else numbers)


class _Tally:
    """The answers of a table: all and positive ones by place and level, of catch trials by place."""

    def __init__(self, folder: Folder, task: Mapping[str, Any]) -> None:
        self.counts: dict[str, dict[float, list[int]]] = {}
        self.catch: dict[str, list[int]] = {}
        self.left_out = {"catch": 0, "missed": 0, "limited": 0}
        self.confusions = {shown: {answered: 0 for answered in task["places"]} for shown in task["places"]}
        for row in rows(folder):
            self._add(row, task["name"] == "localisation")

    def _add(self, row: Mapping[str, str], is_localisation: bool) -> None:
        is_catch, is_missed = row["trial_type"] == "catch", row["response"] == NOTHING
        is_limited = row["limited"] == "1" and not is_catch
        self.left_out["catch"] += is_catch
        self.left_out["missed"] += is_missed
        self.left_out["limited"] += is_limited
        if is_missed or is_limited:
            return
        if is_catch:
            count, is_positive = self.catch.setdefault(row["place"], [0, 0]), row["response"] == "yes"
        else:
            place = "all" if is_localisation else row["place"]
            count = self.counts.setdefault(place, {}).setdefault(float(row["level"]), [0, 0])
            is_positive = row["correct"] == "1"
            if is_localisation:
                self.confusions[row["place"]][row["response"]] += 1
        count[0] += 1
        count[1] += is_positive


def _posterior_mean(
    procedure: Mapping[str, Any], counts: Mapping[float, Sequence[int]], guess_rate: Optional[float], name: str
) -> dict[str, float]:
    """What QUEST+ knows after these answers, whose order does not matter."""
    quest = QuestPlus(**{key: value for key, value in procedure.items() if key != "name"})
    track = QuestTrack(quest, name == "discrimination", 0.01 if guess_rate is None else guess_rate)
    for level, (trials, positive) in counts.items():
        for number in range(trials):
            track.update(level, number < positive)
    return track.posterior_mean


class _Data:
    """Answers by level, and how their likelihood is made largest."""

    def __init__(
        self, counts: Mapping[float, Sequence[int]], catch: Sequence[int], guess_rate: Optional[float], is_linear: bool
    ) -> None:
        import numpy as np

        self._levels = np.array(sorted(counts))
        self._trials, self._positive = np.array([counts[level] for level in sorted(counts)], float).T
        self._catch = np.array(catch, float)
        self._guess_rate, self._is_linear = guess_rate, is_linear
        low, high = self._levels[0], self._levels[-1]
        span = max(high - low, 1.0)
        threshold = (max(low, high / 1000) / 10, high * 10) if is_linear else (low - span, high + span)
        if threshold[0] <= 0 and is_linear:
            raise InputError(f"levels: are at most {high:g} dB; allowed of a discrimination: some above 0 dB")
        guess = (0.0, 0.5 if catch[0] else 0.06) if guess_rate is None else (guess_rate, guess_rate)
        self._bounds = [threshold, (0.5, 10.0), guess, (0.0, 0.06)]

    def shares(self, parameters: Floats, levels: Any) -> Any:
        threshold, slope, guess_rate, lapse_rate = parameters
        return weibull(levels, threshold, slope, guess_rate, lapse_rate, self._is_linear)

    def _loss(self, parameters: Floats, positive: Floats, false_alarms: float) -> tuple[float, Floats]:
        """The negative logarithm of the likelihood, and its gradient."""
        import numpy as np

        threshold, slope, guess_rate, lapse_rate = parameters
        distances = _distances(self._levels, threshold, self._is_linear)
        strength = np.exp(np.minimum(slope * distances, 7))
        missed = np.exp(-strength)
        steepness = (1 - guess_rate - lapse_rate) * missed * strength
        by_threshold = -slope * steepness * (1 / threshold if self._is_linear else np.log(10) / 20)
        gradients = np.array([by_threshold, steepness * distances, missed, missed - 1])
        gradients = np.column_stack([gradients, [0, 0, 1, 0]])
        share = np.append(1 - lapse_rate - (1 - guess_rate - lapse_rate) * missed, guess_rate).clip(1e-9, 1 - 1e-9)
        yes = np.append(positive, false_alarms)
        no = np.append(self._trials, self._catch[0]) - yes
        return float(-(yes @ np.log(share) + no @ np.log1p(-share))), -gradients @ (yes / share - no / (1 - share))

    def _best(self, positive: Floats, false_alarms: float, starts: Sequence[Floats]) -> Floats:
        from scipy.optimize import minimize  # type: ignore[import]

        given = {"args": (positive, false_alarms), "method": "L-BFGS-B", "jac": True, "bounds": self._bounds}
        found = [minimize(self._loss, start, **given) for start in starts]
        best: Floats = min(found, key=lambda each: float(each.fun)).x
        return best

    def fitted(self, resamples: int, seed: Sequence[int]) -> dict[str, Any]:
        import numpy as np

        guess = 0.02 if self._guess_rate is None else self._guess_rate
        thresholds = np.linspace(self._levels[0], self._levels[-1], 5).clip(self._bounds[0][0])
        starts = [np.array([threshold, slope, guess, 0.01]) for threshold in thresholds for slope in (1.0, 3.0)]
        best = self._best(self._positive, self._catch[1], starts)
        numbers = np.random.default_rng(seed)
        shares = self.shares(best, self._levels)
        positive = numbers.binomial(self._trials.astype(int), shares, (resamples, len(shares)))
        false_alarms = numbers.binomial(int(self._catch[0]), best[2], resamples)
        drawn = [self._best(*resampled, [best]) for resampled in zip(positive, false_alarms)] or [np.full(4, np.nan)]
        lower, upper = np.quantile(drawn, [0.025, 0.975], axis=0)
        grid = np.linspace(self._levels[0], self._levels[-1], 101)
        curve = np.quantile([self.shares(each, grid) for each in drawn], [0.025, 0.975], axis=0)
        return {
            **{
                name: {"value": float(best[i]), "lower_95": _number(lower[i]), "upper_95": _number(upper[i])}
                for i, name in enumerate(PARAMETERS)
            },
            "levels_dB": self._levels.tolist(),
            "trials": self._trials.astype(int).tolist(),
            "positive": self._positive.astype(int).tolist(),
            "curve": {
                "levels_dB": grid.tolist(),
                "value": self.shares(best, grid).tolist(),
                "lower_95": [_number(each) for each in curve[0]],
                "upper_95": [_number(each) for each in curve[1]],
            },
        }


def _number(value: float) -> Optional[float]:
    """None, which JSON has, for NaN."""
    return float(value) if value == value else None
