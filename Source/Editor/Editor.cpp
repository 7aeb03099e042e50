#include "Editor.h"

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int usualWidth = 1280, usualHeight = 800;
constexpr double roomyWidth = 1700, roomyHeight = 1000; // from here on everything grows with the window
constexpr int framesPerSecond = 60;
} // namespace

Editor::Editor (AntinodeProcessor& processorToShow) : AudioProcessorEditor (processorToShow), shown (processorToShow)
{
    addAndMakeVisible (shown);
    setResizable (true, true);
    setResizeLimits (usualWidth / 2, usualHeight / 2, usualWidth * 3, usualHeight * 3);
    setSize (usualWidth, usualHeight);
}

Editor::~Editor()
{
    stopTimer();
}

void Editor::resized()
{
    const auto width = static_cast<double> (getWidth()), height = static_cast<double> (getHeight());
    const auto shrunk = std::min ({ 1.0, width / EditorContent::minimumWidth, height / EditorContent::minimumHeight });
    const auto scale = shrunk < 1 ? shrunk : std::max (1.0, std::min (width / roomyWidth, height / roomyHeight));
    shown.setTransform (juce::AffineTransform::scale (static_cast<float> (scale)));
    shown.setBounds (0, 0, juce::roundToInt (width / scale), juce::roundToInt (height / scale));
}

void Editor::parentHierarchyChanged()
{
    if (getPeer() == nullptr)
        stopTimer();
    else if (! isTimerRunning())
    {
        lastTime = juce::Time::getMillisecondCounterHiRes();
        startTimerHz (framesPerSecond);
    }
}

void Editor::timerCallback()
{
    const auto now = juce::Time::getMillisecondCounterHiRes();
    shown.refresh ((now - lastTime) / 1000);
    lastTime = now;
}
} // namespace antinode
