#include "CeramicMeter.h"

#include "EditorLook.h"

#include <cmath>

namespace antinode
{
namespace
{
constexpr double lampSeconds = 1.5, fallPerSecond = 1.2, holdPerSecond = 0.25;
constexpr int steps = 200; // that a level is told apart in
} // namespace

CeramicMeter::CeramicMeter (int number) : Button ("Ceramic " + juce::String (number)), channel (number)
{
    setClickingTogglesState (true);
    setTitle (getName());
}

void CeramicMeter::setCeramic (const juce::String& name, double limit)
{
    limitVolts = limit;
    setTitle ("Mute ceramic " + juce::String (channel) + (name.isEmpty() ? juce::String() : ", " + name));
    setTooltip ("Ceramic " + juce::String (channel) + (name.isEmpty() ? juce::String() : " (" + name + ")") + ": limit "
                + juce::String (limit, 1)
                + " V. The bar is the peak of its voltage as a share of this; the lamp says that the "
                + "limiter acted.\nClick to mute it.");
}

void CeramicMeter::refresh (float volts, bool isLimited, double seconds)
{
    const auto share = limitVolts > 0 ? static_cast<float> (static_cast<double> (volts) / limitVolts) : 0.0f;
    level = std::max (std::min (share, 1.0f), level - static_cast<float> (fallPerSecond * seconds));
    hold = std::max (level, hold - static_cast<float> (holdPerSecond * seconds));
    limitedFor = isLimited ? lampSeconds : std::max (0.0, limitedFor - seconds);
    const auto pixels = juce::roundToInt (level * steps) + (steps + 1) * juce::roundToInt (hold * steps);
    const auto isLit = limitedFor > 0;

    if (std::exchange (shownPixels, pixels) != pixels || std::exchange (wasLimited, isLit) != isLit)
        repaint();
}

void CeramicMeter::paintButton (juce::Graphics& g, bool isOver, bool)
{
    const auto& palette = EditorLook::paletteOf (*this);
    auto area = getLocalBounds().toFloat().reduced (1, 1);
    const auto isMuted = getToggleState();
    const auto label = area.removeFromBottom (14);
    const auto lamp = area.removeFromTop (3);
    area.removeFromTop (2);
    g.setColour (limitedFor > 0 ? palette.warning : palette.raised);
    g.fillRect (lamp);
    g.setColour (palette.raised);
    g.fillRect (area);

    if (! isMuted)
    {
        g.setColour (level >= 0.98f ? palette.warning : palette.armed);
        g.fillRect (area.withTop (area.getBottom() - level * area.getHeight()));
        g.setColour (palette.text);

        if (hold > 0.005f)
            g.fillRect (area.withTop (area.getBottom() - hold * area.getHeight()).withHeight (1));
    }

    if (isOver || hasKeyboardFocus (false))
    {
        g.setColour (hasKeyboardFocus (false) ? palette.accent : palette.mutedText);
        g.drawRect (getLocalBounds(), 1);
    }

    g.setFont (EditorLook::font (10, isMuted));
    g.setColour (isMuted ? palette.warning : palette.mutedText);
    g.drawText (isMuted ? "M" : juce::String (channel), label, juce::Justification::centred, false);
}
} // namespace antinode
