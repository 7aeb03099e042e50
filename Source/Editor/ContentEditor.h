#pragma once

#include <juce_audio_processors/juce_audio_processors.h>

#include <algorithm>

namespace antinode
{
/** The window of a plug-in: its content, made smaller where there is too little room, and the clock that refreshes it.
   The clock runs only in a window. [message thread]
    @tparam Content  a component with refresh (seconds), minimumWidth and minimumHeight */
template <typename Content>
class ContentEditor : public juce::AudioProcessorEditor, private juce::Timer
{
public:
    template <typename Processor>
    explicit ContentEditor (Processor& processorToShow)
        : AudioProcessorEditor (processorToShow), shown (processorToShow)
    {
        addAndMakeVisible (shown);
        setResizable (true, true);
        setResizeLimits (Content::minimumWidth / 2, Content::minimumHeight / 2, usualWidth * 3, usualHeight * 3);
        setSize (usualWidth, usualHeight);
    }

    ~ContentEditor() override { stopTimer(); }

    Content& content() { return shown; }

    void resized() override
    {
        const auto width = static_cast<double> (getWidth()), height = static_cast<double> (getHeight());
        const auto scale = std::min ({ 1.0, width / Content::minimumWidth, height / Content::minimumHeight });
        shown.setTransform (juce::AffineTransform::scale (static_cast<float> (scale)));
        shown.setBounds (0, 0, juce::roundToInt (width / scale), juce::roundToInt (height / scale));
    }

    void parentHierarchyChanged() override
    {
        if (getPeer() == nullptr)
            stopTimer();
        else if (! isTimerRunning())
        {
            lastTime = juce::Time::getMillisecondCounterHiRes();
            startTimerHz (framesPerSecond);
        }
    }

private:
    static constexpr int usualWidth = 1040, usualHeight = 640, framesPerSecond = 30;

    void timerCallback() override
    {
        const auto now = juce::Time::getMillisecondCounterHiRes();
        shown.refresh ((now - lastTime) / 1000);
        lastTime = now;
    }

    Content shown;
    double lastTime = 0; ///< ms
};
} // namespace antinode
