#pragma once

#include "Chart.h"
#include "Theme.h"

#include <juce_graphics/juce_graphics.h>

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
} // namespace antinode
