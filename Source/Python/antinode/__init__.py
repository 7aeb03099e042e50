"""Antinode: the voltages that focus the vibration of a surface at a chosen place and instant.

>>> import antinode as an
>>> focus = an.focus("demonstrator", x_mm=-24)
>>> render = an.render(focus, "staple")
>>> render.scores["v_score"]
>>> render.save("moved")

The functions do what the commands of the same names do, on values, with the same results to the bit. Arguments carry
their units as files do. Errors are InputError (a ValueError) and LimitError. Values show themselves in notebooks, and
plot() gives a figure of Matplotlib.

Documents:  device, focus, waveforms: from a name, a file or a dict; names lists the embedded ones.
Foci:       design, render (a design that is played), tolerance, tradeoff, map; perform: a waveform per finger.
Cases:      sweep, sampled (plans that cover the ranges evenly), sobol_indices.
Devices:    device(...).modes(), compare, place (ceramics), import_device (finite elements).
Playing:    Player (prepared places, on the standalone program or on the model).
Benches:    excite, frf, measure (simulated), identify, retune, sensors, learn, follow.
Trials:     experiment: what people feel; detection, discrimination, localisation.

Manual: Docs/Manual/python.md; all keys of files: Docs/FileFormats.md; formulas: Docs/Theory.md.
"""

import inspect as _inspect
from typing import Any as _Any

from . import experiment as experiment
from ._antinode import version as __version__
from ._antinode import (
    Compared,
    Design,
    Estimated,
    Excitation,
    Followed,
    Identified,
    Imported,
    Learnt,
    Mapped,
    Measured,
    Modes,
    Performed,
    Placed,
    Rendered,
    Retuned,
    Sensors,
    Swept,
    Tolerance,
    Tradeoff,
    compare,
    design,
    excite,
    follow,
    frf,
    identify,
    import_device,
    learn,
    map,
    measure,
    perform,
    place,
    render,
    retune,
    sensors,
    tolerance,
    tradeoff,
)
from ._documents import Device, Focus, Waveforms, device, focus, names, waveforms
from ._pictures import set_theme
from ._player import Played, Player, Prepared
from ._sampling import sampled, sobol_indices
from ._sweeps import sweep
from .errors import InputError, LimitError

__all__ = [
    "Compared",
    "Design",
    "Device",
    "Estimated",
    "Excitation",
    "Focus",
    "Followed",
    "Identified",
    "Imported",
    "InputError",
    "Learnt",
    "LimitError",
    "Mapped",
    "Measured",
    "Modes",
    "Performed",
    "Placed",
    "Played",
    "Player",
    "Prepared",
    "Rendered",
    "Retuned",
    "Sensors",
    "Swept",
    "Tolerance",
    "Tradeoff",
    "Waveforms",
    "compare",
    "design",
    "device",
    "excite",
    "focus",
    "follow",
    "frf",
    "identify",
    "import_device",
    "learn",
    "map",
    "measure",
    "names",
    "perform",
    "place",
    "render",
    "retune",
    "sampled",
    "sensors",
    "set_theme",
    "sobol_indices",
    "sweep",
    "tolerance",
    "tradeoff",
    "waveforms",
]


def _named(compiled: _Any) -> _Any:
    """A compiled function as one of the package, so that others can pickle it by its name."""

    def call(*arguments: _Any, **keywords: _Any) -> _Any:
        return compiled(*arguments, **keywords)

    call.__name__ = call.__qualname__ = compiled.__name__
    call.__doc__ = compiled.__doc__
    setattr(call, "__signature__", _inspect.signature(compiled))
    return call


# Users know them by the package.
for _name in __all__:
    if _inspect.isbuiltin(globals()[_name]):
        globals()[_name] = _named(globals()[_name])
    globals()[_name].__module__ = __name__
