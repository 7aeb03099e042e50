"""Progress of long work: a function, a bar of tqdm where it is installed, or nothing."""

from __future__ import annotations

from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, Union

Progress = Union[None, bool, Callable[[str, float], object]]


@contextmanager
def shown(progress: Progress) -> Iterator[Optional[Callable[[str, float], object]]]:
    """What the compiled part calls, for as long as the work lasts.

    Args:
        progress: None or False: nothing; True: a bar; or a function of what is being done and its share, 0 to 1. An
            exception that it raises ends the work.
    """
    if progress is None or progress is False:
        yield None
    elif callable(progress):
        yield progress
    else:
        bar = _bar()
        try:
            yield bar.show
        finally:
            bar.close()


class _Plain:
    """Without tqdm nothing is drawn: a notebook would collect line after line."""

    def show(self, what: str, share: float) -> None:
        pass

    def close(self) -> None:
        pass


class _Bar:
    def __init__(self, tqdm: Any) -> None:
        self._bar = tqdm(total=1.0, bar_format="{desc} {percentage:3.0f}% |{bar}| {remaining} left")

    def show(self, what: str, share: float) -> None:
        self._bar.set_description(what, refresh=False)
        self._bar.n = share
        self._bar.refresh()

    def close(self) -> None:
        self._bar.close()


def _bar() -> Any:
    try:
        from tqdm.auto import tqdm  # type: ignore[import]
    except ImportError:
        return _Plain()
    return _Bar(tqdm)
