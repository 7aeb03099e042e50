#pragma once

namespace antinode
{
/** Standard deviations, relative, of what a real device differs by from its model. Docs/Theory.md, section 7. */
struct DetuningSpread
{
    double frequency = 0;     ///< Of each mode's frequency.
    double damping = 0;       ///< Of each mode's damping.
    double participation = 0; ///< Of each participation.
    double drift = 0;         ///< Of a factor that all frequencies share, as with temperature.
};

/** What a device whose modes have been measured and adopted still differs by. */
inline constexpr DetuningSpread usualSpread { 0.001, 0.1, 0.05, 0 };
} // namespace antinode
