"""Places of a surface."""

from __future__ import annotations

from typing import Any, Iterable, Sequence, Union

from .errors import InputError

Probe = Union[float, Sequence[float]]


def place_pairs(name: str, places: Iterable[Probe]) -> list[tuple[float, float]]:
    """x and y of places that are given as x, or as x and y, mm; numbers and rows of NumPy's arrays too."""
    pairs = []
    for place in places:
        given: Any = place
        try:
            x, y = (float(number) for number in (given if hasattr(given, "__len__") else (given, 0.0)))
        except (TypeError, ValueError):
            raise InputError(f"{name}: {place!r} is no place; allowed: x, or x and y, mm") from None
        pairs.append((x, y))
    return pairs
