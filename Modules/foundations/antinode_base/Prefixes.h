#pragma once

namespace antinode
{
/** From SI units to thousandths: m to mm, s to ms, m/s to mm/s. */
inline constexpr double milli = 1e3;

/** To millionths: J to uJ, s to us. */
inline constexpr double micro = 1e6;

/** To billionths: F to nF. */
inline constexpr double nano = 1e9;
} // namespace antinode
