#include "ContentEditor.h"

#include <utility>

namespace antinode
{
ContentEditor::ContentEditor (juce::AudioProcessor& processorToShow, std::unique_ptr<WindowContent> content)
    : AudioProcessorEditor (processorToShow), shown (std::move (content))
{
    const auto& shape = shown->shape();
    addAndMakeVisible (*shown);
    setResizable (true, true);
    setResizeLimits (shape.sizes.leastWidth / 2, shape.sizes.leastHeight / 2, shape.usualWidth * 3,
                     shape.usualHeight * 3);
    setSize (shape.usualWidth, shape.usualHeight);
}

void ContentEditor::setContentScale (double wanted)
{
    wantedScale = wanted;
    resized();
}

void ContentEditor::resized()
{
    const auto scale = windowScale (getWidth(), getHeight(), shown->shape().sizes, wantedScale);
    shown->setTransform (juce::AffineTransform::scale (static_cast<float> (scale)));
    shown->setBounds (0, 0, juce::roundToInt (getWidth() / scale), juce::roundToInt (getHeight() / scale));
}

void ContentEditor::parentHierarchyChanged()
{
    if (getPeer() == nullptr)
        stopTimer();
    else if (! isTimerRunning())
    {
        lastTime = juce::Time::getMillisecondCounterHiRes();
        startTimerHz (shown->shape().framesPerSecond);
    }
}

void ContentEditor::timerCallback()
{
    const auto now = juce::Time::getMillisecondCounterHiRes();
    shown->refresh ((now - lastTime) / 1000);
    lastTime = now;
}

void showAsLeft (ContentEditor& editor)
{
    auto& content = editor.content();
    const auto preferences = readPreferences();
    content.setDark (preferences.isDark);
    editor.setContentScale (preferences.scale);
    content.onTheme = [&content] { keepPreferences ({ content.isDark(), readPreferences().scale }); };
}
} // namespace antinode
