"""What is asked of a person: detection, discrimination, localisation."""

from __future__ import annotations

import dataclasses
import random
from dataclasses import dataclass
from typing import Any, ClassVar, Mapping, Optional

from ._checks import within, word
from ._events import NOTHING
from ._procedures import Procedure
from .errors import InputError


@dataclass(frozen=True)
class Trial:
    """One trial, as the functions that cue and ask get it.

    Attributes:
        number: from 1.
        trial_type: 'detection', 'discrimination', 'localisation' or 'catch'.
        place: the name of the place; of a catch trial, the place at which nothing is played.
        level: of the procedure, dB; None: a catch trial.
        levels_dB_SL: what each interval plays; None: nothing.
        interval: that of the stimulus, from 1; None: a catch trial.
        question, choices: what is asked, and the answers that are allowed.
        expected: the answer that fits the stimulus; None: there is none.
        track: which run of the procedure, from 0; None: a catch trial.
        jitter_s: pause before the first interval.
    """

    number: int
    trial_type: str
    place: str
    level: Optional[float]
    levels_dB_SL: tuple[Optional[float], ...]
    interval: Optional[int]
    question: str
    choices: tuple[str, ...]
    expected: Optional[str]
    track: Optional[int]
    jitter_s: float


@dataclass(frozen=True, kw_only=True)
class Task:
    """What all tasks have.

    Args:
        places: what the player prepares, by name: ``{"left": {"x_mm": -24}, ...}``.
        procedure: how levels are chosen; of a localisation one for all places, else one for each place.
        catch: the share of trials without a stimulus, 0 to 0.9; they are not counted by the procedure.
        jitter_s: shortest and longest pause before a trial.
        interval_s: from the begin of an interval to the next one, or to the question.
    """

    places: Mapping[str, Mapping[str, Any]]
    procedure: Procedure
    catch: float = 0.0
    jitter_s: tuple[float, float] = (0.5, 1.5)
    interval_s: float = 1.0

    _type: ClassVar[str]
    _is_linear: ClassVar[bool] = False

    def __post_init__(self) -> None:
        if not self.places:
            raise InputError("places: is empty; allowed: one place or more")
        for name in self.places:
            if name == NOTHING or not name.isprintable() or not name.strip():
                raise InputError(f"places: has the name {name!r}; allowed: printable texts other than '{NOTHING}'")
        within("catch", self.catch, 0, 0.9)
        within("jitter_s", self.jitter_s[0], 0, self.jitter_s[1])
        within("interval_s", self.interval_s, 0, 60)

    def _described(self) -> dict[str, Any]:
        fields = {field.name: getattr(self, field.name) for field in dataclasses.fields(self)}
        procedure = {"name": type(self.procedure).__name__, **dataclasses.asdict(self.procedure)}
        return {"task": {"name": self._type, **fields, "procedure": procedure}}

    def _guess_rate(self) -> float:
        return 0.01

    def _groups(self) -> list[tuple[str, ...]]:
        """The places that share a procedure."""
        return [(place,) for place in self.places]

    def _asked(self, level: Optional[float], place: str, numbers: random.Random) -> dict[str, Any]:
        """The parts of a trial that differ from task to task; None: of a catch trial."""
        raise NotImplementedError

    def _trial(
        self, number: int, track: Optional[int], level: Optional[float], place: str, numbers: random.Random
    ) -> Trial:
        jitter_s = numbers.uniform(*self.jitter_s)
        asked = self._asked(level, place, numbers)
        kind = "catch" if level is None else self._type
        return Trial(number=number, trial_type=kind, place=place, level=level, track=track, jitter_s=jitter_s, **asked)


def _in_two_intervals(
    question: str, stimulus: Optional[float], other: Optional[float], level: Optional[float], numbers: random.Random
) -> dict[str, Any]:
    interval = numbers.choice((1, 2))
    return {
        "levels_dB_SL": (stimulus, other) if interval == 1 else (other, stimulus),
        "interval": None if level is None else interval,
        "question": question,
        "choices": ("1", "2"),
        "expected": None if level is None else str(interval),
    }


@dataclass(frozen=True, kw_only=True)
class Detection(Task):
    """Is there a stimulus? Levels of the procedure are dB SL.

    Args, beside those of :class:`Task`:
        method: 'yes/no', or '2AFC': in which of two intervals it was.
    """

    method: str = "yes/no"
    _type = "detection"

    def __post_init__(self) -> None:
        super().__post_init__()
        word("method", self.method, ("yes/no", "2AFC"))

    def _guess_rate(self) -> float:
        return 0.5 if self.method == "2AFC" else 0.01

    def _asked(self, level: Optional[float], place: str, numbers: random.Random) -> dict[str, Any]:
        if self.method == "2AFC":
            return _in_two_intervals("In which interval was it?", level, None, level, numbers)
        return {
            "levels_dB_SL": (level,),
            "interval": None if level is None else 1,
            "question": "Did you feel it?",
            "choices": ("yes", "no"),
            "expected": "no" if level is None else "yes",
        }


@dataclass(frozen=True, kw_only=True)
class Discrimination(Task):
    """Which of two stimuli is the stronger one? Levels of the procedure are dB above the reference.

    Args, beside those of :class:`Task`:
        reference_dB_SL: the level of the other stimulus.
        method: '2AFC', or 'yes/no': whether the second one is stronger, after the reference.
    """

    reference_dB_SL: float
    method: str = "2AFC"
    _type = "discrimination"
    _is_linear = True

    def __post_init__(self) -> None:
        super().__post_init__()
        word("method", self.method, ("yes/no", "2AFC"))
        within("reference_dB_SL", self.reference_dB_SL, -200, 200)

    def _guess_rate(self) -> float:
        return 0.5 if self.method == "2AFC" else 0.01

    def _asked(self, level: Optional[float], place: str, numbers: random.Random) -> dict[str, Any]:
        reference = self.reference_dB_SL
        stimulus = reference + (level or 0)
        if self.method == "2AFC":
            return _in_two_intervals("Which one was stronger?", stimulus, reference, level, numbers)
        return {
            "levels_dB_SL": (reference, stimulus),
            "interval": None if level is None else 2,
            "question": "Was the second one stronger?",
            "choices": ("yes", "no"),
            "expected": "no" if level is None else "yes",
        }


@dataclass(frozen=True, kw_only=True)
class Localisation(Task):
    """At which of the places is the stimulus? Levels of the procedure are dB SL; places come in shuffled blocks."""

    _type = "localisation"

    def __post_init__(self) -> None:
        super().__post_init__()
        within("places", len(self.places), 2, 1000)

    def _guess_rate(self) -> float:
        return 1 / len(self.places)

    def _groups(self) -> list[tuple[str, ...]]:
        return [tuple(self.places)]

    def _asked(self, level: Optional[float], place: str, numbers: random.Random) -> dict[str, Any]:
        return {
            "levels_dB_SL": (level,),
            "interval": None if level is None else 1,
            "question": "Where was it?",
            "choices": tuple(self.places),
            "expected": None if level is None else place,
        }
