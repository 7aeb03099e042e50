#pragma once

#include <antinode_reports/Chart.h>

#include <juce_gui_basics/juce_gui_basics.h>

#include <memory>

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
} // namespace antinode
