"""Many cases of one question, on this computer or on the workers of Dask."""

from __future__ import annotations

import importlib
import os
import tempfile
import threading
import time
from functools import lru_cache
from typing import Any, Callable, Mapping, Optional, Union

from . import _antinode
from ._checks import within
from ._documents import Folder, as_json
from ._progress import Progress, shown
from .errors import InputError

Plan = Union[Folder, Mapping[str, Any]]


def sweep(
    plan: Plan,
    client: Optional[Any] = None,
    *,
    folder: Optional[Folder] = None,
    threads: Optional[int] = None,
    cache: bool = True,
    progress: Progress = None,
) -> _antinode.Swept:
    """Computes all cases of a plan, as ``antinode sweep``.

    Args:
        plan: a file, or a dict with the keys of such a file; names of files in a dict begin at the working folder.
        client: a ``distributed.Client`` of Dask: its workers compute the parts, each as one task on one thread. They
            need this package in this version, and no common folder. None: this computer.
        folder: keeps plan, parts and results as ``--out`` does. What is there already is not computed again, whoever
            has computed it: this function, the command, or its shards. None: nothing is kept.
        threads: cases at once on this computer, 1 to 1024; None: one per processor.
        cache: False: devices are solved without the user's cache.
        progress: a function of the current step and its share, 0 to 1; True: a bar of tqdm if it is installed.

    Returns:
        :class:`Swept`: ``values``, ``column(name)``, ``summary``, ``save(folder)``; the same bytes for any number of
        threads and workers.

    Raises:
        InputError: the plan is wrong, a recorded key does not exist, or the folder is of another plan.
        KeyboardInterrupt: Ctrl+C; parts in ``folder`` stay.

    Source: Docs/FileFormats.md, "Sweep"; Docs/Design/sweeps.md.
    """
    within("threads", threads, 1, 1024)
    if client is not None and threads is not None:
        raise InputError("threads: is of this computer; allowed: None with a client, whose workers have their own")
    if isinstance(plan, Mapping):
        core = _antinode.Sweep.parse(as_json(dict(plan)), cache)
    else:
        core = _antinode.Sweep.load(os.fspath(plan), cache)
    core.check()
    with shown(progress) as show:
        if folder is not None:
            swept = _filled(core, os.fspath(folder), client, threads, cache, show)
            swept.save(folder)
            core.open(os.fspath(folder)).tidy()
            return swept
        with tempfile.TemporaryDirectory(prefix="antinode-") as scratch:
            return _filled(core, os.path.join(scratch, "sweep"), client, threads, cache, show)


Show = Optional[Callable[[str, float], object]]


def _filled(
    core: _antinode.Sweep, folder: str, client: Optional[Any], threads: Optional[int], cache: bool, show: Show
) -> _antinode.Swept:
    parts = core.open(folder)
    if client is None:
        parts.compute(threads, show)
    else:
        _compute_on_workers(parts, core.document, client, cache, show)
    return parts.merge()


def _compute_on_workers(parts: _antinode.SweepParts, document: str, client: Any, cache: bool, show: Show) -> None:
    """Each missing part is a task: Dask gives it to a worker that is free, and to another one where that one ends.

    A task whose worker hangs, or whose result is lost as its worker ends, never finishes. Where no part comes for a
    while, those missing are submitted again, each time after twice as long; the first result of a part counts.
    """
    missing = parts.missing()
    wanted = len(missing)
    finished = importlib.import_module("distributed").as_completed(with_results=True)
    indices: dict[str, int] = {}
    submitted: list[Any] = []

    def submit() -> float:
        # A task itself, so that a worker that has ended takes nothing along that cannot be made again.
        kept = client.submit(_itself, document, pure=False)
        tasks = client.map(_part, missing, document=kept, cache=cache, pure=False)
        indices.update((task.key, index) for task, index in zip(tasks, missing))
        submitted.extend((kept, *tasks))
        finished.update(tasks)
        return time.monotonic()

    patience_s = PATIENCE_S
    try:
        latest = submit() if missing else 0.0
        while missing:
            if finished.has_ready():
                task, part = next(finished)
                index = indices[task.key]
                if index in missing:
                    parts.keep(index, part)
                    missing.remove(index)
                    if show is not None:
                        show("Sweeping", 1 - len(missing) / wanted)
                latest = time.monotonic()
            elif time.monotonic() - latest > patience_s:
                patience_s *= 2
                latest = submit()
            else:
                time.sleep(0.02)
    finally:
        client.cancel(submitted)


# Longer than the parts of most sweeps; what is computed twice costs time only.
PATIENCE_S = 120.0


def _itself(document: str) -> str:
    return document


_making = threading.Lock()


@lru_cache(maxsize=2)
def _made(document: str, cache: bool) -> _antinode.Sweep:
    return _antinode.Sweep.parse(document, cache)


def _part(index: int, document: str, cache: bool) -> bytes:
    """A part, on a worker; what parts share, devices and designs, is made once in its process."""
    with _making:
        core = _made(document, cache)
    return core.part(index)
