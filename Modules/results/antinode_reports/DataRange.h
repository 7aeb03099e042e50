#pragma once

#include "BarChart.h"
#include "LineChart.h"
#include "Ticks.h"

#include <Eigen/Core>

#include <optional>

namespace antinode
{
/** The finite values among these: the range with them included, nothing if there are none at all.
    @param positiveOnly  leaves out values that a logarithmic axis cannot show [any] */
std::optional<AxisRange> including (std::optional<AxisRange>, const Eigen::Ref<const Eigen::VectorXd>& values,
                                    bool positiveOnly = false);

/** The x range of the curves, or nothing. [any] */
std::optional<AxisRange> xDataRange (const LineChart&);

/** The y range of curves, limits and fillings, or nothing. [any] */
std::optional<AxisRange> yDataRange (const LineChart&);

/** The y range of bars and limits, or nothing. [any] */
std::optional<AxisRange> yDataRange (const BarChart&);

/** Both together. [any] */
std::optional<AxisRange> united (std::optional<AxisRange>, std::optional<AxisRange>);

/** A y range with nice ends; whole decades on a logarithmic axis. [any] */
AxisRange niceDataRange (std::optional<AxisRange>, bool logarithmic);

/** @throws InputError  where a series has not as many x as y [any] */
void requireMatchingSizes (const LineChart&);

/** @throws InputError  where a series has not one value for each category [any] */
void requireMatchingSizes (const BarChart&);
} // namespace antinode
