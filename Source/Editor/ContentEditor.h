#pragma once

#include "EditorPreferences.h"
#include "WindowScale.h"

#include <juce_audio_processors/juce_audio_processors.h>

#include <memory>

namespace antinode
{
/** The window of a plug-in: its content, larger or smaller, and the clock that refreshes it. The clock runs only in a
   window: before, a VST3 is made, measured and perhaps freed again on the host's thread, while messages run on one of
   JUCE's own. [message thread]
    @tparam Content  a component with refresh (seconds), sizes, usualWidth, usualHeight and framesPerSecond */
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
        setResizeLimits (Content::sizes.leastWidth / 2, Content::sizes.leastHeight / 2, Content::usualWidth * 3,
                         Content::usualHeight * 3);
        setSize (Content::usualWidth, Content::usualHeight);
    }

    ~ContentEditor() override { stopTimer(); }

    Content& content() { return shown; }

    /** @param wanted  0: as large as suits the window */
    void setContentScale (double wanted)
    {
        wantedScale = wanted;
        resized();
    }

    void resized() override
    {
        const auto scale = windowScale (getWidth(), getHeight(), Content::sizes, wantedScale);
        shown.setTransform (juce::AffineTransform::scale (static_cast<float> (scale)));
        shown.setBounds (0, 0, juce::roundToInt (getWidth() / scale), juce::roundToInt (getHeight() / scale));
    }

    void parentHierarchyChanged() override
    {
        if (getPeer() == nullptr)
            stopTimer();
        else if (! isTimerRunning())
        {
            lastTime = juce::Time::getMillisecondCounterHiRes();
            startTimerHz (Content::framesPerSecond);
        }
    }

private:
    void timerCallback() override
    {
        const auto now = juce::Time::getMillisecondCounterHiRes();
        shown.refresh ((now - lastTime) / 1000);
        lastTime = now;
    }

    Content shown;
    double wantedScale = 0;
    double lastTime = 0; ///< ms
};

/** A window as dark or light, and as large, as the last one was left; how it is left is kept. [message thread] */
template <typename Content, typename Processor>
std::unique_ptr<ContentEditor<Content>> editorAsLeft (Processor& processor)
{
    auto editor = std::make_unique<ContentEditor<Content>> (processor);
    auto& content = editor->content();
    const auto preferences = readPreferences();
    content.setDark (preferences.isDark);
    editor->setContentScale (preferences.scale);
    content.onTheme = [&content] { keepPreferences ({ content.isDark(), readPreferences().scale }); };
    return editor;
}
} // namespace antinode
