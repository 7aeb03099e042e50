"""Pictures of values: PNG for notebooks, drawn by the same charts as the reports."""

from __future__ import annotations

from typing import Any

from . import _antinode
from .errors import InputError

Style = _antinode.PictureStyle

_themes = ("light", "dark", "print")
_theme = "light"


def set_theme(theme: str) -> None:
    """Chooses how values show themselves in notebooks: 'light', 'dark' or 'print'."""
    global _theme
    if theme not in _themes:
        raise InputError(f"theme: is '{theme}'; allowed: 'light', 'dark', 'print'")
    _theme = theme


def style(width: int, height: int, scale: float, theme: str | None) -> Style:
    """The style of a picture; without a theme the one that was set."""
    return Style(width, height, scale, theme or _theme)


class Pictured:
    """A value that shows itself as a picture."""

    def _draw(self, style: Style) -> bytes:
        raise NotImplementedError

    def png(self, *, width: int = 760, height: int = 0, scale: float = 1.0, theme: str | None = None) -> bytes:
        """The picture as the bytes of a PNG file.

        Args:
            width, height: pixels at scale 1, 16 to 8192; a height of 0 follows from what is drawn.
            scale: pixels of the file for each of these, 0.25 to 8; 2 for dense screens.
            theme: 'light', 'dark' or 'print'; None: that of :func:`antinode.set_theme`.
        """
        return self._draw(style(width, height, scale, theme))

    def _repr_png_(self) -> bytes:
        return self.png()
