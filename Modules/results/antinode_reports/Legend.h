#pragma once

#include "BarChart.h"
#include "LineChart.h"
#include "Theme.h"

#include <juce_graphics/juce_graphics.h>

#include <string>
#include <vector>

namespace antinode
{
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
} // namespace antinode
