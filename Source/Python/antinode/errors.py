"""What the package raises: the sentences of the command line, with their numbers."""

from __future__ import annotations

from typing import Optional

__all__ = ["InputError", "LimitError"]


class InputError(ValueError):
    """An argument is not allowed.

    The text is one sentence: where, what is wrong, what is allowed, as ``antinode`` prints it.
    """


class LimitError(InputError):
    """A focus or tracks that cannot be reached within the limits of the device.

    The numbers that the sentence gives are attributes; those that do not apply are None.

    Attributes:
        minimum_peak_voltage_V: the lowest voltage that the drives of the focus need, V.
        reachable_velocity_m_s: the peak velocity that the limit allows, m/s.
        reachable_share: of tracks, the share of the wanted levels that the limits allow.
        bound_share: of tracks, no voltages of any form reach that share with less than this share of the limits.
    """

    def __init__(
        self,
        sentence: str,
        *,
        minimum_peak_voltage_V: Optional[float] = None,
        reachable_velocity_m_s: Optional[float] = None,
        reachable_share: Optional[float] = None,
        bound_share: Optional[float] = None,
    ) -> None:
        super().__init__(sentence)
        self.minimum_peak_voltage_V = minimum_peak_voltage_V
        self.reachable_velocity_m_s = reachable_velocity_m_s
        self.reachable_share = reachable_share
        self.bound_share = bound_share
