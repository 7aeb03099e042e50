"""The table of an experiment: events.tsv and events.json as BIDS has them, a line per trial."""

from __future__ import annotations

import csv
import json
import os
import time
from datetime import datetime, timezone
from typing import Any, Iterator, Mapping

from ._documents import Folder, as_json
from .errors import InputError

COLUMNS: dict[str, dict[str, Any]] = {
    "onset": {
        "Description": "Begin of the stimulus after that of the experiment; of a catch trial, of its first interval.",
        "Units": "s",
    },
    "duration": {"Description": "Of the stimulus, as the player says.", "Units": "s"},
    "trial_type": {
        "Levels": {
            "detection": "A stimulus or nothing.",
            "discrimination": "A stimulus and a reference.",
            "localisation": "A stimulus at one of the places.",
            "catch": "No stimulus; in a discrimination no difference.",
        }
    },
    "place": {"Description": "Name of the place; of a catch trial, where nothing is played."},
    "level": {"Description": "Sensation level; in a discrimination the difference to the reference.", "Units": "dB"},
    "response": {"Description": "The answer."},
    "response_time": {"Description": "From the question to the answer.", "Units": "s"},
    "volts": {"Description": "Peak voltage of the stimulus, as the player says.", "Units": "V"},
    "limited": {"Description": "1: a limit of the device made the stimulus weaker than its level."},
    "interval": {"Description": "Interval of the stimulus, from 1."},
    "track": {"Description": "Staircase or other run of the procedure, from 0."},
    "correct": {"Description": "1: the answer fits the stimulus."},
}
NOTHING = "n/a"


def described(folder: Folder) -> dict[str, Any]:
    """The experiment of a folder: task, seed, and when it was started."""
    file = os.path.join(folder, "events.json")
    try:
        with open(file, encoding="utf-8") as stream:
            experiment: dict[str, Any] = json.load(stream)["Experiment"]
            return experiment
    except (OSError, ValueError, KeyError) as error:
        raise InputError(f"{file}: cannot be read as that of an experiment: {error!r}; allowed: one of run()") from None


def rows(folder: Folder) -> Iterator[dict[str, str]]:
    """The trials of a folder, one after the other."""
    with open(os.path.join(folder, "events.tsv"), encoding="utf-8", newline="") as stream:
        yield from csv.DictReader(stream, delimiter="\t", quoting=csv.QUOTE_NONE)


class EventTable:
    """The files of a folder, made or resumed.

    Raises:
        InputError: the folder is of another experiment.
    """

    def __init__(self, folder: Folder, experiment: Mapping[str, Any]) -> None:
        os.makedirs(folder, exist_ok=True)
        wanted = json.loads(as_json(experiment))
        if not os.path.exists(os.path.join(folder, "events.json")):
            now = datetime.now(timezone.utc).isoformat(timespec="milliseconds")
            _write(folder, "events.json", {**COLUMNS, "Experiment": {**wanted, "started": now}})
        found = described(folder)
        started = found.pop("started")
        if found != wanted:
            keys = [key for key in wanted if found.get(key) != wanted[key]]
            raise InputError(f"{os.fspath(folder)}: has another {keys[0]}; allowed: the same one, or a new folder")
        self.age_s = max(0.0, time.time() - datetime.fromisoformat(started).timestamp())
        self._file = os.open(os.path.join(folder, "events.tsv"), os.O_RDWR | os.O_CREAT | os.O_APPEND, 0o666)
        end = _end_of_lines(self._file)
        os.ftruncate(self._file, end)  # A line that a crash has cut is not a trial.
        if end == 0:
            self._append(COLUMNS)
            _synchronise_folder(folder)

    def append(self, row: Mapping[str, Any]) -> None:
        """Returns when the line is on the disk."""
        self._append(text(row[column]) for column in COLUMNS)

    def _append(self, cells: Any) -> None:
        line = ("\t".join(cells) + "\n").encode()
        if os.write(self._file, line) != len(line):
            raise OSError("events.tsv: the disk is full")
        os.fsync(self._file)

    def close(self) -> None:
        os.close(self._file)


def text(value: Any) -> str:
    if value is None:
        return NOTHING
    return str(int(value)) if isinstance(value, bool) else str(value)


def _end_of_lines(file: int) -> int:
    """Behind the last end of a line."""
    size = os.lseek(file, 0, os.SEEK_END)
    start = max(0, size - 65536)
    return start + os.pread(file, size - start, start).rfind(b"\n") + 1


def _write(folder: Folder, name: str, document: Mapping[str, Any]) -> None:
    """A whole file or none, whatever happens."""
    part = os.path.join(folder, name + ".part")
    with open(part, "w", encoding="utf-8") as stream:
        stream.write(json.dumps(document, indent=2) + "\n")
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(part, os.path.join(folder, name))
    _synchronise_folder(folder)


def _synchronise_folder(folder: Folder) -> None:
    opened = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(opened)
    finally:
        os.close(opened)
