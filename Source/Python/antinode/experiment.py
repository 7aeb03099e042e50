"""Experiments on what people feel: detection, discrimination and localisation at places of a surface.

>>> import antinode as an
>>> task = an.experiment.Localisation(
...     places={"left": {"x_mm": -24}, "right": {"x_mm": 24}},
...     procedure=an.experiment.QuestPlus(trials=40))
>>> an.experiment.run(player, task, "subject01", seed=1)
>>> an.experiment.fit("subject01").save("subject01")

The player makes the stimuli (:class:`Player`), a function asks; PsychoPy can be that function. Order, places, jitter
and catch trials follow from the seed. Each trial is on the disk before the next one begins, and a run that was ended at
any instant is resumed by the same call.

Manual: Docs/Manual/trials.md.
"""

from __future__ import annotations

import random
import time
from typing import Any, Callable, Iterator, Mapping, Optional, Protocol

from ._documents import Folder
from ._events import NOTHING, EventTable, rows, text
from ._procedures import ConstantStimuli, QuestPlus, Staircase, Track, shuffled
from ._psychometric import Psychometric, SimulatedObserver, fit
from ._tasks import Detection, Discrimination, Localisation, Task, Trial
from .errors import InputError

__all__ = [
    "ConstantStimuli",
    "Detection",
    "Discrimination",
    "Localisation",
    "Player",
    "Psychometric",
    "QuestPlus",
    "SimulatedObserver",
    "Staircase",
    "Task",
    "Trial",
    "fit",
    "keyboard",
    "run",
]


class Player(Protocol):
    """What makes the stimuli."""

    def prepare(self, stimuli: Mapping[str, Mapping[str, Any]]) -> object:
        """Is called once, before the first trial, with the places of the task."""
        ...

    def play(self, name: str, *, level_dB_SL: float) -> Any:
        """Plays at a place.

        Returns:
            A dict, or an object with attributes: ``onset``: when the motion begins, s, on the clock of :func:`run`;
            ``volts``: peak voltage, V; ``limited``: whether a limit made it weaker; and, if known, ``duration``, s.
        """
        ...


def _schedule(
    task: Task,
    streams: list[tuple[Track, Iterator[str]]],
    numbers: random.Random,
    present: Callable[[Trial], Optional[str]],
) -> int:
    """Presents all trials: each unfinished track has one, in a random order, then again. Gives their number.

    All random numbers of an experiment are drawn here in one order, so that recorded answers lead to the same state.
    """
    number = 0
    while unfinished := [index for index, (track, _) in enumerate(streams) if not track.is_finished]:
        numbers.shuffle(unfinished)
        for index in unfinished:
            while numbers.random() < task.catch:
                number += 1
                present(task._trial(number, None, None, numbers.choice(list(task.places)), numbers))
            number += 1
            track, places = streams[index]
            level = track.level()
            trial = task._trial(number, index, level, next(places), numbers)
            answer = present(trial)
            if answer is not None:
                track.update(level, answer == trial.expected)
    return number


def keyboard(trial: Trial) -> str:
    """Asks in the terminal: a choice, its first letters, or its number, which begins at 1."""
    listed = ", ".join(f"{number}: {choice}" for number, choice in enumerate(trial.choices, 1))
    while True:
        text = input(f"{trial.question} [{listed}] ").strip()
        begun = [choice for choice in trial.choices if text and choice.startswith(text)]
        if text in trial.choices or len(begun) == 1:
            return text if text in trial.choices else begun[0]
        if text.isdecimal() and 1 <= int(text) <= len(trial.choices):
            return trial.choices[int(text) - 1]


def announce(trial: Trial, interval: int) -> None:
    """Tells the terminal which trial and interval begin."""
    print(f"Trial {trial.number}" + (f", interval {interval}" if len(trial.levels_dB_SL) > 1 else ""))


def run(
    player: Player,
    task: Task,
    folder: Folder,
    *,
    seed: int = 1,
    answer: Callable[[Trial], Optional[str]] = keyboard,
    cue: Optional[Callable[[Trial, int], object]] = None,
    clock: Callable[[], float] = time.monotonic,
    wait: Callable[[float], object] = time.sleep,
) -> int:
    """Runs an experiment to its end, or the rest of one that was ended.

    Args:
        player: makes the stimuli.
        task: :class:`Detection`, :class:`Discrimination` or :class:`Localisation`.
        folder: gets ``events.tsv``, a line per trial, and ``events.json``. What is there is not played again: its
            answers bring the procedure to where it was.
        seed: of order, places, jitter and catch trials.
        answer: gets the trial after its last interval, returns one of its choices; None: missed, so the level is
            played again later. An exception ends the run; the trials before it stay.
        cue: is called as each interval of a trial begins, numbered from 1; None: the terminal says it if it also asks.
        clock, wait: seconds; others than those of ``time`` simulate time or keep a window alive.

    Returns:
        The number of trials in the folder.

    Raises:
        InputError: an argument or answer is not allowed, or the folder is of another experiment.
    """
    numbers = random.Random(seed)
    streams = [
        (track, shuffled(group, numbers))
        for group in task._groups()
        for track in task.procedure.tracks(task._is_linear, task._guess_rate(), numbers)
    ]
    if cue is None and answer is keyboard:
        cue = announce
    table = EventTable(folder, {**task._described(), "seed": seed})
    try:
        begun = clock() - table.age_s
        recorded = rows(folder)
        player.prepare(task.places)

        def present(trial: Trial) -> Optional[str]:
            row = next(recorded, None)
            if row is None:
                made = _presented(player, task, trial, answer, cue, clock, wait)
                table.append({**made, "onset": f"{made['onset'] - begun:.4f}"})
                response: Optional[str] = made["response"]
                return response
            wanted = {"trial_type": trial.trial_type, "place": trial.place, "interval": text(trial.interval)}
            if any(row[key] != value for key, value in wanted.items()):
                raise InputError(f"events.tsv: trial {trial.number} is of another version; allowed: a new folder")
            return None if row["response"] == NOTHING else row["response"]

        return _schedule(task, streams, numbers, present)
    finally:
        table.close()


def _presented(
    player: Player,
    task: Task,
    trial: Trial,
    answer: Callable[[Trial], Optional[str]],
    cue: Optional[Callable[[Trial, int], object]],
    clock: Callable[[], float],
    wait: Callable[[float], object],
) -> dict[str, Any]:
    """A trial from its pause to its answer, as a row of the table; the onset on the clock."""
    wait(trial.jitter_s)
    onset = clock()
    stimulus: dict[str, Any] = {}
    limited: Optional[bool] = None
    for interval, level in enumerate(trial.levels_dB_SL, 1):
        begun = clock()
        if cue is not None:
            cue(trial, interval)
        if level is not None:
            played = player.play(trial.place, level_dB_SL=level)
            limited = bool(_said(played, "limited")) or bool(limited)
            if interval == trial.interval:
                stimulus = {key: _said(played, key) for key in ("onset", "duration", "volts")}
        wait(max(0.0, begun + task.interval_s - clock()))
    asked = clock()
    response = answer(trial)
    response_time = clock() - asked
    if response is not None and response not in trial.choices:
        raise InputError(f"answer: is {response!r}; allowed: {', '.join(trial.choices)}")
    is_right = None if response is None or trial.expected is None else response == trial.expected
    return {
        "onset": stimulus.get("onset", onset),
        "duration": stimulus.get("duration"),
        "trial_type": trial.trial_type,
        "place": trial.place,
        "level": trial.level,
        "response": response,
        "response_time": None if response is None else f"{response_time:.4f}",
        "volts": f"{stimulus['volts']:.4g}" if stimulus else None,
        "limited": limited,
        "interval": trial.interval,
        "track": trial.track,
        "correct": is_right,
    }


def _said(played: Any, key: str) -> Any:
    return played.get(key) if isinstance(played, Mapping) else getattr(played, key, None)
