"""Refuses what the options of the command line refuse."""

from __future__ import annotations

from typing import Optional, Sequence

from .errors import InputError


def within(name: str, value: Optional[float], lowest: float, highest: float) -> None:
    """Raises InputError for a number, where there is one, that is not within these bounds."""
    if value is not None and not lowest <= value <= highest:
        raise InputError(f"{name}: is {value:g}; allowed: {lowest:g} to {highest:g}")


def word(name: str, value: Optional[str], allowed: Sequence[str]) -> None:
    """Raises InputError for a text, where there is one, that is none of the allowed."""
    if value is not None and value not in allowed:
        raise InputError(f"{name}: is '{value}'; allowed: {', '.join(allowed)}")
