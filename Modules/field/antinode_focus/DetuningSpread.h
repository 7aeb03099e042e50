#pragma once

namespace antinode
{
/** Relative standard deviations of a real device from its model. Docs/Theory.md, section 7. */
struct DetuningSpread
{
    double frequency = 0;     ///< Of each mode's frequency.
    double damping = 0;       ///< Of each mode's damping.
    double participation = 0; ///< Of each participation.
    double drift = 0;         ///< Of a factor that all frequencies share, as with temperature.
};

/** The remaining spread of a device after its modes have been measured and adopted. */
inline constexpr DetuningSpread usualSpread { 0.001, 0.1, 0.05, 0 };
} // namespace antinode
