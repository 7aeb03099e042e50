#include "PanelParts.h"

#include <Editor/EditorLook.h>
#include <Editor/Meters.h>

#include <algorithm>

namespace antinode
{
namespace
{
constexpr float fall = 0.9F;     // a call
constexpr double quietest = -60; // dB
} // namespace

void LevelBar::show (float peak, std::int64_t clamped)
{
    const auto next = peak > 0 || level > 1e-4F ? std::max (peak, level * fall) : 0.0F;

    if (next == level && isClamped == (clamped > 0))
        return;

    level = next;
    isClamped = clamped > 0;
    repaint();
}

void LevelBar::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    auto area = getLocalBounds().toFloat().reduced (0, 7);
    const auto lamp = area.removeFromRight (area.getHeight());
    area.removeFromRight (4);
    const auto share = static_cast<float> (levelShare (static_cast<double> (level), 1, quietest));
    g.setColour (palette.raised);
    g.fillRoundedRectangle (area, 2);
    g.setColour (palette.accent);
    g.fillRoundedRectangle (area.withWidth (area.getWidth() * share), 2);
    g.setColour (isClamped ? palette.warning : palette.raised);
    g.fillEllipse (lamp);
}
} // namespace antinode
