#include "PlateEditor.h"

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int usualWidth = 1040, usualHeight = 640, framesPerSecond = 30;
} // namespace

PlateEditor::PlateEditor (PlateProcessor& processorToShow)
    : AudioProcessorEditor (processorToShow), shown (processorToShow)
{
    addAndMakeVisible (shown);
    setResizable (true, true);
    setResizeLimits (PlateContent::minimumWidth / 2, PlateContent::minimumHeight / 2, usualWidth * 3, usualHeight * 3);
    setSize (usualWidth, usualHeight);
}

PlateEditor::~PlateEditor()
{
    stopTimer();
}

void PlateEditor::resized()
{
    const auto width = static_cast<double> (getWidth()), height = static_cast<double> (getHeight());
    const auto scale = std::min ({ 1.0, width / PlateContent::minimumWidth, height / PlateContent::minimumHeight });
    shown.setTransform (juce::AffineTransform::scale (static_cast<float> (scale)));
    shown.setBounds (0, 0, juce::roundToInt (width / scale), juce::roundToInt (height / scale));
}

void PlateEditor::parentHierarchyChanged()
{
    if (getPeer() == nullptr)
        stopTimer();
    else if (! isTimerRunning())
    {
        lastTime = juce::Time::getMillisecondCounterHiRes();
        startTimerHz (framesPerSecond);
    }
}

void PlateEditor::timerCallback()
{
    const auto now = juce::Time::getMillisecondCounterHiRes();
    shown.refresh ((now - lastTime) / 1000);
    lastTime = now;
}
} // namespace antinode
