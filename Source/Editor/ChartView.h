#pragma once

#include <antinode_reports/Chart.h>
#include <antinode_reports/PlotFrame.h>
#include <antinode_session/InstrumentMeters.h>
#include <juce_gui_basics/juce_gui_basics.h>

#include <memory>
#include <vector>

namespace antinode
{
/** A chart, drawn once and kept until it, its size or the theme changes. [message thread] */
class ChartView final : public juce::Component
{
public:
    explicit ChartView (const juce::String& title);

    /** @param wording  the text without a chart */
    void setChart (std::shared_ptr<const Chart>, const juce::String& wording);

    void paint (juce::Graphics&) override;
    void resized() override { image = {}; }
    void lookAndFeelChanged() override;

private:
    void drawImage (float scale);

    juce::String waiting;
    std::shared_ptr<const Chart> chart;
    juce::Image image;
    float imageScale = 0;
};

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
