#pragma once

#include "ChartView.h"

#include <antinode_reports/PlotFrame.h>
#include <antinode_session/ProbeTrace.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <vector>

namespace antinode
{
/** The live velocity at the first probe over the last half second. [message thread] */
class LiveTrace : public juce::Component
{
public:
    explicit LiveTrace (const ProbeTrace&);

    /** Reads the newest values; draws where there are any. */
    void refresh();

    void paint (juce::Graphics&) override;
    void resized() override { axes = {}; }
    void lookAndFeelChanged() override;

private:
    void drawAxesOnce (float scale);

    const ProbeTrace& trace;
    std::vector<ProbeTrace::Entry> entries;
    std::uint64_t shown = 0;
    double range = 0; ///< mm/s, of the axis to either side.
    juce::Image axes;
    PlotFrame plot;
};

/** The velocity at the probe: as designed, and live below. [message thread] */
class ProbePanel final : public juce::Component
{
public:
    explicit ProbePanel (const ProbeTrace&);

    ChartView& designed() { return chart; }
    void refresh()
    {
        if (isVisible())
            live.refresh();
    }

    void resized() override;

private:
    ChartView chart;
    LiveTrace live;
};
} // namespace antinode
