#pragma once

#include "Chart.h"
#include "Theme.h"
#include "Ticks.h"

#include <Eigen/Core>
#include <juce_graphics/juce_graphics.h>

#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** A mark on an axis. */
struct AxisTick
{
    double value = 0;
    std::string label;
};

/** One axis of a plot. */
struct ChartAxis
{
    std::string label;
    AxisRange range;
    bool logarithmic = false;
    std::vector<AxisTick>
        ticks; ///< Chosen at layout where empty; those that are given are thinned out until labels fit.
    bool grid = true;

    /** The position of a value: 0 at the minimum, 1 at the maximum, never beyond +-20; NaN for values without a
       position. [any] */
    float fraction (double value) const;
};

/** Room round a plot for what stands outside of it, in pixels at scale 1. */
struct PlotMargins
{
    float above = 0, right = 0;
};

/** The area of a plot and the mapping of values to pixels. */
struct PlotFrame
{
    juce::Rectangle<float> plot;
    ChartAxis x, y;

    float xAt (double value) const { return plot.getX() + x.fraction (value) * plot.getWidth(); }
    float yAt (double value) const { return plot.getBottom() - y.fraction (value) * plot.getHeight(); }
    juce::Point<float> at (double xValue, double yValue) const { return { xAt (xValue), yAt (yValue) }; }
};

/** A range of positive values for a logarithmic axis, whatever came in. [any] */
AxisRange positiveRange (AxisRange);

/** Gives axes, tick labels and margins their room and chooses ticks whose labels do not touch. [any] */
PlotFrame layOutPlot (juce::Rectangle<float> area, ChartAxis x, ChartAxis y, PlotMargins, const Theme&);

/** The plot made smaller, in the middle of its place, so that one unit is as long in x as in y. [any] */
PlotFrame withEqualAspect (PlotFrame);

/** The ticks of an axis of the given number of pixels, and in its label the power of ten that the tick labels leave
    out. [any] */
ChartAxis withTicks (ChartAxis, float length, float spacing);

/** Background and grid: below the data. [any] */
void drawGrid (juce::Graphics&, const PlotFrame&, const Theme&);

/** Axes with their labels: above the data. [any] */
void drawAxes (juce::Graphics&, const PlotFrame&, const Theme&);

/** Shows in the middle of the plot that there is no data. [any] */
void drawNoData (juce::Graphics&, const PlotFrame&, const Theme&);

/** Fills the chart's background and draws its title; gives what remains of the area. [any] */
juce::Rectangle<float> drawTitle (juce::Graphics&, juce::Rectangle<float> area, const std::string& title, const Theme&);

/** A straight line along whole pixels. [any] */
void drawHorizontal (juce::Graphics&, float y, float fromX, float toX, float thickness = 1);
void drawVertical (juce::Graphics&, float x, float fromY, float toY, float thickness = 1);

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
