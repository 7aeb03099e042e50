#include "LevelRows.h"

#include "EditorLook.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double lowestLevel = -60; // dB below a full bar
constexpr double fallPerSecond = 0.8, holdSeconds = 3;
constexpr int rowHeight = 22, titleHeight = 24, levelMargin = 8;
constexpr float columnGap = 20; // A value must not be read with the number of the row beside it.
} // namespace

double levelShare (double value, double full, double lowest)
{
    return value > 0 && full > 0 ? std::clamp (1 - 20 * std::log10 (value / full) / lowest, 0.0, 1.0) : 0.0;
}

LevelRows::LevelRows (const juce::String& title, const juce::String& unitToShow, int decimalsToShow)
    : unit (unitToShow), decimals (decimalsToShow)
{
    setTitle (title);
    setInterceptsMouseClicks (false, false);
}

void LevelRows::setRows (std::vector<Row> newRows)
{
    rows = std::move (newRows);
    levels.resize (rows.size());
    repaint();
}

void LevelRows::refresh (const std::vector<double>& values, double seconds)
{
    for (std::size_t i = 0; i < std::min (values.size(), rows.size()); ++i)
    {
        auto& level = levels[i];
        level.share =
            std::max (levelShare (values[i], rows[i].full, lowestLevel), level.share - fallPerSecond * seconds);
        level.heldFor -= seconds;

        if (values[i] >= level.held || level.heldFor < 0)
        {
            level.held = values[i];
            level.heldFor = holdSeconds;
        }
    }

    repaint();
}

void LevelRows::showVoltages (const ModalModel* model, LevelMeters& meters, double seconds)
{
    std::vector<Row> ceramics;
    std::vector<double> volts;
    volts.reserve (LevelMeters::ceramics);

    // All are taken: what one device has played is not the next one's.
    for (int i = 0; i < LevelMeters::ceramics; ++i)
        volts.push_back (static_cast<double> (meters.takePeak (i)));

    for (std::size_t i = 0; model != nullptr && i < model->ceramics.size(); ++i)
        ceramics.push_back ({ juce::String (i + 1), {}, voltageLimit (*model, i) });

    setRows (std::move (ceramics));
    refresh (volts, seconds);
}

void LevelRows::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);
    auto area = getLocalBounds().toFloat().reduced (levelMargin, 2);
    g.setColour (palette.mutedText);
    g.setFont (EditorLook::font (EditorLook::smallTextHeight));
    g.drawText (getTitle(), area.removeFromTop (titleHeight), juce::Justification::centredLeft);

    if (rows.empty())
        return;

    // As many columns as it takes to show all.
    const auto lines = std::max (1, static_cast<int> (area.getHeight()) / rowHeight);
    const auto count = static_cast<int> (rows.size());
    const auto columns = (count + lines - 1) / lines;
    const auto width = (area.getWidth() + columnGap) / static_cast<float> (columns);

    for (int i = 0; i < count; ++i)
    {
        const auto column = i / lines;
        const auto line = i % lines;
        paintRow (g,
                  { area.getX() + width * static_cast<float> (column),
                    area.getY() + static_cast<float> (rowHeight * line), width - columnGap, rowHeight },
                  rows[static_cast<std::size_t> (i)], levels[static_cast<std::size_t> (i)]);
    }
}

void LevelRows::paintRow (juce::Graphics& g, juce::Rectangle<float> area, const Row& row, const Level& level) const
{
    const auto& palette = EditorLook::findPalette (*this);
    const auto isRoomy = area.getWidth() > 150;
    g.setFont (EditorLook::font (EditorLook::smallTextHeight, true));
    g.setColour (palette.text);
    g.drawText (row.name, area.removeFromLeft (22), juce::Justification::centredLeft);
    g.setFont (EditorLook::font (EditorLook::smallTextHeight));
    g.setColour (palette.mutedText);

    if (row.place.isNotEmpty() && isRoomy)
        g.drawText (row.place, area.removeFromLeft (116), juce::Justification::centredLeft);

    if (isRoomy)
        g.drawText (juce::String (level.held, decimals) + " " + unit, area.removeFromRight (84),
                    juce::Justification::centredRight);

    const auto bar = area.reduced (4, 7);
    g.setColour (palette.raised);
    g.fillRect (bar);
    g.setColour (level.share >= 0.999 ? palette.warning : palette.armed);
    g.fillRect (bar.withWidth (bar.getWidth() * static_cast<float> (level.share)));
}
} // namespace antinode
