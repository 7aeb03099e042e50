"""Refuses what the options of the command line refuse."""

from __future__ import annotations

import difflib
from typing import Iterable, Optional, Sequence

from .errors import InputError


def within(name: str, value: Optional[float], lowest: float, highest: float) -> None:
    """Raises InputError for a number, where there is one, that is not within these bounds."""
    if value is not None and not lowest <= value <= highest:
        raise InputError(f"{name}: is {value:g}; allowed: {lowest:g} to {highest:g}")


def word(name: str, value: Optional[str], allowed: Sequence[str]) -> None:
    """Raises InputError for a text, where there is one, that is none of the allowed."""
    if value is not None and value not in allowed:
        raise InputError(f"{name}: is '{value}'; allowed: {', '.join(allowed)}")


def with_suggestion(error: InputError, keys: Iterable[str], arguments: Sequence[str]) -> InputError:
    """The error with the argument that was meant, where it is about one of these keys and an argument is near to it."""
    for key in keys:
        place = f"/{key}: is an unknown key;"
        units = [key + unit for unit in ("_mm", "_ms", "_mm_s", "_V") if key + unit in arguments]
        near = units or difflib.get_close_matches(key, arguments, 1, 0.8)
        if near and place in str(error):
            return InputError(str(error).replace(place, f"{place[:-1]} (did you mean '{near[0]}'?);"))
    return error
