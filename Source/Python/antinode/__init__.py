"""Antinode: the voltages that focus the vibration of a surface at a chosen place and instant.

>>> import antinode as an
>>> focus = an.focus("demonstrator", x_mm=-24)
>>> render = an.render(focus, "staple")
>>> render.scores["v_score"]
>>> render.save("moved")

The functions do what the commands of the same names do, on values, with the same results to the bit. Arguments carry
their units as files do. Errors are InputError (a ValueError) and LimitError.

Documents: Docs/Manual/python.md; Docs/FileFormats.md for all keys.
"""

from ._antinode import version as __version__
from ._designs import Design, Rendered, design, render
from ._documents import Device, Focus, Waveforms, device, focus, names, waveforms
from ._measured import Identified, Measured, Placed, identify, measure, place
from ._modes import Modes
from ._pictures import set_theme
from ._sweeps import Swept, sweep
from ._tracks import Performed, perform
from .errors import InputError, LimitError

__all__ = [
    "Design",
    "Device",
    "Focus",
    "Identified",
    "InputError",
    "LimitError",
    "Measured",
    "Modes",
    "Performed",
    "Placed",
    "Rendered",
    "Swept",
    "Waveforms",
    "design",
    "device",
    "focus",
    "identify",
    "measure",
    "names",
    "perform",
    "place",
    "render",
    "set_theme",
    "sweep",
    "waveforms",
]

# Users know them by the package.
for _name in __all__:
    globals()[_name].__module__ = __name__
