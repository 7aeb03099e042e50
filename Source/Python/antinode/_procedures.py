"""Which level comes next: constant stimuli, staircases, QUEST+."""

from __future__ import annotations

import random
from dataclasses import dataclass
from typing import Any, Iterator, Mapping, Optional, Protocol, Sequence, TypeVar, Union

from ._checks import within
from .errors import InputError

Item = TypeVar("Item")


class Track(Protocol):
    """One run of a procedure. Levels are dB: over the threshold of skin, or over the reference of a discrimination."""

    @property
    def is_finished(self) -> bool: ...

    def level(self) -> float:
        """That of the next trial; the same until :meth:`update`."""
        ...

    def update(self, level: float, is_positive: bool) -> None: ...


def shuffled(items: Sequence[Item], numbers: random.Random) -> Iterator[Item]:
    """All items in a random order, then again in another one, without end."""
    while True:
        order = list(items)
        numbers.shuffle(order)
        yield from order


def _numbers(name: str, values: Union[float, Sequence[float]]) -> tuple[float, ...]:
    try:
        numbers = tuple(float(value) for value in (values if hasattr(values, "__iter__") else [values]))
    except (TypeError, ValueError):
        raise InputError(f"{name}: is {values!r}; allowed: a number or a list of numbers") from None
    if not numbers:
        raise InputError(f"{name}: is empty; allowed: a number or a list of numbers")
    for number in numbers:
        within(name, number, -200, 200)
    return numbers


@dataclass(frozen=True)
class ConstantStimuli:
    """Each level as often, in shuffled blocks of all levels.

    Args:
        levels_dB: the levels.
        repeats: trials per level.
    """

    levels_dB: Sequence[float]
    repeats: int = 20

    def __post_init__(self) -> None:
        object.__setattr__(self, "levels_dB", _numbers("levels_dB", self.levels_dB))
        within("repeats", self.repeats, 1, 1_000_000)

    def tracks(self, is_linear: bool, guess_rate: float, numbers: random.Random) -> list[Track]:
        """The one track of this procedure."""
        return [_Constant(self, numbers)]


class _Constant:
    def __init__(self, procedure: ConstantStimuli, numbers: random.Random) -> None:
        self._levels = shuffled(procedure.levels_dB, numbers)
        self._left = procedure.repeats * len(procedure.levels_dB)
        self._level = next(self._levels)

    @property
    def is_finished(self) -> bool:
        return self._left == 0

    def level(self) -> float:
        return self._level

    def update(self, level: float, is_positive: bool) -> None:
        self._left -= 1
        self._level = next(self._levels)


@dataclass(frozen=True)
class Staircase:
    """Up after some negative answers in a row, down after some positive ones.

    Until the first reversal each answer counts.

    Args:
        start_dB: the first level; a list: several staircases, interleaved at random.
        steps_dB: the step, or a list: the next one after each reversal, then the last.
        up: negative answers in a row before the level rises.
        down: positive answers in a row before it falls; with ``up=1`` the staircase goes to the level of
            0.5 ** (1 / down) positive answers: 50 %, 70.7 %, 79.4 %.
        reversals, trials: each staircase ends when it has had both.
        minimum_dB, maximum_dB: levels stay within.

    Source: H. Levitt, J. Acoust. Soc. Am. 49, 467 (1971).
    """

    start_dB: Union[float, Sequence[float]]
    steps_dB: Union[float, Sequence[float]] = (8, 4, 2)
    up: int = 1
    down: int = 2
    reversals: int = 8
    trials: int = 0
    minimum_dB: float = -20.0
    maximum_dB: float = 60.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "start_dB", _numbers("start_dB", self.start_dB))
        object.__setattr__(self, "steps_dB", _numbers("steps_dB", self.steps_dB))
        for name in ("up", "down", "reversals"):
            within(name, getattr(self, name), 1, 1_000_000)
        within("trials", self.trials, 0, 1_000_000)
        within("minimum_dB", self.minimum_dB, -200, self.maximum_dB)

    def tracks(self, is_linear: bool, guess_rate: float, numbers: random.Random) -> list[Track]:
        """A track for each first level."""
        return [_Stairs(self, start) for start in self.start_dB]  # type: ignore[union-attr]


class _Stairs:
    def __init__(self, procedure: Staircase, start: float) -> None:
        self._procedure = procedure
        self._level = start
        self._trials = self._reversals = self._streak = self._direction = 0
        self._latest: Optional[bool] = None

    @property
    def is_finished(self) -> bool:
        return self._reversals >= self._procedure.reversals and self._trials >= self._procedure.trials

    def level(self) -> float:
        return min(max(self._level, self._procedure.minimum_dB), self._procedure.maximum_dB)

    def update(self, level: float, is_positive: bool) -> None:
        rule = self._procedure
        self._trials += 1
        self._streak = self._streak + 1 if is_positive == self._latest else 1
        self._latest = is_positive
        if self._reversals and self._streak < (rule.down if is_positive else rule.up):
            return
        direction = -1 if is_positive else 1
        self._reversals += direction == -self._direction
        self._direction, self._streak = direction, 0
        steps: Sequence[float] = rule.steps_dB  # type: ignore[assignment]
        self._level = self.level() + direction * steps[min(self._reversals, len(steps) - 1)]


@dataclass(frozen=True)
class QuestPlus:
    """The level that is expected to tell most about the psychometric function, by the package questplus.

    The function is Weibull's with the scale ``dB`` of questplus, or, of a difference to a reference, ``linear``.

    Args:
        trials: of each place; of a localisation in all.
        levels_dB: those that may be played.
        thresholds_dB: of the prior; None: the levels.
        slopes, guess_rates, lapse_rates: of the prior; ``guess_rates`` None: that of the task, 1/k or, of yes/no, 0.01.
        prior: weights by 'threshold', 'slope', 'lower_asymptote', 'lapse_rate'; what is absent is uniform.

    Source: A. B. Watson, J. Vision 17(3), 10 (2017).
    """

    trials: int = 40
    levels_dB: Sequence[float] = range(-10, 51)
    thresholds_dB: Optional[Sequence[float]] = None
    slopes: Sequence[float] = (1, 1.5, 2, 3, 4, 5)
    guess_rates: Optional[Sequence[float]] = None
    lapse_rates: Sequence[float] = (0.02,)
    prior: Optional[Mapping[str, Sequence[float]]] = None

    def __post_init__(self) -> None:
        within("trials", self.trials, 1, 1_000_000)
        for name in ("levels_dB", "thresholds_dB", "slopes", "guess_rates", "lapse_rates"):
            if getattr(self, name) is not None:
                object.__setattr__(self, name, _numbers(name, getattr(self, name)))

    def tracks(self, is_linear: bool, guess_rate: float, numbers: random.Random) -> list[Track]:
        """The one track of this procedure.

        Raises:
            InputError: questplus is not installed, or a difference is not above 0.
        """
        return [QuestTrack(self, is_linear, guess_rate)]


class QuestTrack:
    """The track of a :class:`QuestPlus`."""

    def __init__(self, procedure: QuestPlus, is_linear: bool, guess_rate: float) -> None:
        try:
            from questplus import QuestPlusWeibull  # type: ignore[import]
        except ImportError:
            raise InputError(
                "procedure: QuestPlus needs the package questplus, which is missing; allowed: python3-questplus of"
                " Debian, or another procedure"
            ) from None
        thresholds = procedure.levels_dB if procedure.thresholds_dB is None else procedure.thresholds_dB
        if is_linear and min(thresholds) <= 0:
            raise InputError(f"thresholds_dB: has {min(thresholds):g}; allowed of a discrimination: above 0 dB")
        self._left = procedure.trials
        self._quest = QuestPlusWeibull(
            intensities=procedure.levels_dB,
            thresholds=thresholds,
            slopes=procedure.slopes,
            lower_asymptotes=(guess_rate,) if procedure.guess_rates is None else procedure.guess_rates,
            lapse_rates=procedure.lapse_rates,
            prior=procedure.prior,
            responses=("yes", "no"),
            stim_scale="linear" if is_linear else "dB",
        )

    @property
    def is_finished(self) -> bool:
        return self._left == 0

    @property
    def posterior_mean(self) -> dict[str, float]:
        """By 'threshold', 'slope', 'lower_asymptote', 'lapse_rate', as questplus names them."""
        return {key: float(value) for key, value in self._quest.param_estimate.items()}

    def level(self) -> float:
        import numpy as np

        with np.errstate(divide="ignore", invalid="ignore"):  # 0 log 0, which questplus leaves out of its sums
            return float(self._quest.next_intensity)

    def update(self, level: float, is_positive: bool) -> None:
        self._left -= 1
        self._quest.update(intensity=level, response="yes" if is_positive else "no")
        # The posterior has all that is needed; a history would grow.
        self._quest.stim_history.clear()
        self._quest.resp_history.clear()


Procedure = Union[ConstantStimuli, Staircase, QuestPlus]
