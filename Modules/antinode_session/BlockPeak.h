#pragma once

namespace antinode
{
/** The largest absolute value of a block. [audio thread] */
double absolutePeak (const double* samples, int count);
} // namespace antinode
