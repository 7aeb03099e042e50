#include "CeramicMeter.h"

#include "EditorLook.h"

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double lampSeconds = 1.5, fallPerSecond = 1.2, holdPerSecond = 0.25;
constexpr int steps = 200;          // resolution of a level
constexpr int roomyMeterWidth = 70; // from this width on the peak is shown next to the bar
constexpr double lowestLevel = -48; // dB below the limit

/** Of the bar's height. */
float limitShare (double volts, double limit)
{
    if (! (volts > 0) || ! (limit > 0))
        return 0;

    return static_cast<float> (std::clamp (1 - 20 * std::log10 (volts / limit) / lowestLevel, 0.0, 1.0));
}
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
                + " V. The bar shows the peak voltage, from 48 dB below this limit; the lamp above it shows that "
                + "the limiter has clamped samples.\nClick to mute.");
}

void CeramicMeter::refresh (float volts, bool isLimited, double seconds)
{
    const auto share = limitShare (static_cast<double> (volts), limitVolts);
    peakVolts = share >= hold ? static_cast<double> (volts) : peakVolts;
    level = std::max (share, level - static_cast<float> (fallPerSecond * seconds));
    hold = std::max (level, hold - static_cast<float> (holdPerSecond * seconds));
    limitedFor = isLimited ? lampSeconds : std::max (0.0, limitedFor - seconds);
    const auto pixels = juce::roundToInt (level * steps) + (steps + 1) * juce::roundToInt (hold * steps);
    const auto isLit = limitedFor > 0;

    if (std::exchange (shownPixels, pixels) != pixels || std::exchange (wasLimited, isLit) != isLit)
        repaint();
}

void CeramicMeter::paintButton (juce::Graphics& g, bool isOver, bool)
{
    const auto& palette = EditorLook::findPalette (*this);
    auto area = getLocalBounds().toFloat().reduced (2, 2);
    const auto isRoomy = getWidth() >= roomyMeterWidth;
    const auto label = isRoomy ? area.withTrimmedLeft (24) : area.removeFromBottom (13);
    const auto numberArea = isRoomy ? label.withTrimmedBottom (label.getHeight() / 2) : label;
    paintBar (g, isRoomy ? area.removeFromLeft (18) : area);

    if (isOver || hasKeyboardFocus (false))
    {
        g.setColour (hasKeyboardFocus (false) ? palette.accent : palette.mutedText);
        g.drawRect (getLocalBounds(), 1);
    }

    g.setFont (EditorLook::font (isRoomy ? EditorLook::smallTextHeight : 10, isMuted() || isRoomy));
    g.setColour (isMuted() ? palette.warning : isRoomy ? palette.text : palette.mutedText);
    g.drawText (isMuted() && ! isRoomy ? "M" : juce::String (channel), numberArea,
                isRoomy ? juce::Justification::centredLeft : juce::Justification::centred, false);

    if (! isRoomy)
        return;

    g.setFont (EditorLook::font (11));
    g.setColour (isMuted() ? palette.warning : palette.mutedText);
    g.drawText (isMuted() ? juce::String ("muted") : juce::String (peakVolts, 1) + " V",
                label.withTrimmedTop (label.getHeight() / 2), juce::Justification::centredLeft, false);
}

void CeramicMeter::paintBar (juce::Graphics& g, juce::Rectangle<float> area) const
{
    const auto& palette = EditorLook::findPalette (*this);
    g.setColour (limitedFor > 0 ? palette.warning : palette.raised);
    g.fillRect (area.removeFromTop (3));
    area.removeFromTop (2);
    g.setColour (palette.raised);
    g.fillRect (area);

    if (isMuted())
        return;

    g.setColour (level >= 0.99f ? palette.warning : palette.armed);
    g.fillRect (area.withTop (area.getBottom() - level * area.getHeight()));
    g.setColour (palette.text);

    if (hold > 0.005f)
        g.fillRect (area.withTop (area.getBottom() - hold * area.getHeight()).withHeight (1));
}
} // namespace antinode
