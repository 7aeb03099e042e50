#pragma once

namespace antinode
{
/** From SI units to thousandths: m to mm, s to ms, m/s to mm/s. */
inline constexpr double milli = 1000;
} // namespace antinode
