#pragma once

#include "Chart.h"
#include "Theme.h"

#include <juce_graphics/juce_graphics.h>

#include <string>
#include <vector>

namespace antinode
{
/** Draws a chart into an area, background included. Nothing but the Graphics is touched: any number of threads may
   draw, each on its own. Data that is empty or not finite is drawn as what it is: a gap, or "no data".
    @throws InputError  where parts of a chart that belong together differ in size [any] */
void draw (juce::Graphics&, juce::Rectangle<float> area, const LineChart&, const Theme&);
void draw (juce::Graphics&, juce::Rectangle<float> area, const BarChart&, const Theme&);
void draw (juce::Graphics&, juce::Rectangle<float> area, const HeatMap&, const Theme&);
void draw (juce::Graphics&, juce::Rectangle<float> area, const StackedTraces&, const Theme&);
void draw (juce::Graphics&, juce::Rectangle<float> area, const PlanView&, const Theme&);
void draw (juce::Graphics&, juce::Rectangle<float> area, const ChartGrid&, const Theme&);
void draw (juce::Graphics&, juce::Rectangle<float> area, const Chart&, const Theme&);

/** A name and how what it names looks. */
struct LegendEntry
{
    std::string name;
    juce::Colour colour;
    LineStyle line = LineStyle::solid;
    bool isBar = false;
};

/** The named series of a chart. [any] */
std::vector<LegendEntry> legendEntries (const LineChart&, const Theme&);
std::vector<LegendEntry> legendEntries (const BarChart&, const Theme&);

/** Draws the entries above or at the right, in as many rows as they need; gives what remains of the area. [any] */
juce::Rectangle<float> drawLegend (juce::Graphics&, juce::Rectangle<float> area, const std::vector<LegendEntry>&,
                                   LegendPlace, const Theme&);

/** An image to draw a picture in, all of one colour: where the size times the scale is no whole number, drawings cover
   the last row and column only in part.
    @param width, height  before the scale
    @return               at least one pixel each way
    [any] */
juce::Image blankImage (int width, int height, float scale, juce::Colour);
} // namespace antinode
