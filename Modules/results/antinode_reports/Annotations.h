#pragma once

#include <string>

namespace antinode
{
/** A horizontal line at a value that must not, or should, be reached; its label stands outside the plot. */
struct LimitLine
{
    double value = 0; ///< In the unit of the y axis.
    std::string label;
};

/** A vertical line at an instant or a place; its label stands above the plot. */
struct Marker
{
    double position = 0; ///< In the unit of the x axis.
    std::string label;
};

/** A shaded part of the x axis, for example where a ceramic lies; its label stands above the plot. */
struct Span
{
    double from = 0, to = 0; ///< In the unit of the x axis.
    std::string label;
};

/** The position of the legend: never over data. */
enum class LegendPlace
{
    top,
    right,
    none
};

/** The style of a line. */
enum class LineStyle
{
    solid,
    dashed,
    dotted
};

/** A series' colour is an index into Theme::series, or one of these. */
namespace series_colour
{
constexpr int byOrder = -1; ///< The next of the theme's colours.
constexpr int neutral = -2; ///< The colour of text: for what others are compared with.
} // namespace series_colour
} // namespace antinode
