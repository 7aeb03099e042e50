#include "Meters.h"

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

namespace
{
constexpr double lampSeconds = 1.5, stripFallPerSecond = 1.2, holdPerSecond = 0.25;
constexpr int steps = 200;          // resolution of a level
constexpr int roomyMeterWidth = 70; // from this width on the peak is shown next to the bar
constexpr double lowestVolts = -48; // dB below the limit

constexpr int widest = 112, margin = 8, captionWidth = 66;
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
    const auto share = static_cast<float> (levelShare (static_cast<double> (volts), limitVolts, lowestVolts));
    peakVolts = share >= hold ? static_cast<double> (volts) : peakVolts;
    level = std::max (share, level - static_cast<float> (stripFallPerSecond * seconds));
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

MetersStrip::MetersStrip (AntinodeProcessor& processorToShow, History& historyToKeep)
    : processor (processorToShow), history (historyToKeep)
{
    setTitle ("Ceramics");
    setFocusContainerType (FocusContainerType::focusContainer);
}

void MetersStrip::setModel (const std::shared_ptr<const ModalModel>& model)
{
    meters.clear();
    const auto count = model == nullptr ? 0 : std::min<Eigen::Index> (model->actuators(), LevelMeters::ceramics);

    for (int i = 0; i < count; ++i)
    {
        const auto& ceramic = model->ceramics[static_cast<std::size_t> (i)];
        auto meter = std::make_unique<CeramicMeter> (i + 1);
        meter->setCeramic (juce::String::fromUTF8 (ceramic.name.c_str()),
                           voltageLimit (*model, static_cast<std::size_t> (i)));
        meter->setToggleState (((processor.mutes() >> i) & 1U) != 0, juce::dontSendNotification);
        meter->onClick = [this, i] { mute (static_cast<std::size_t> (i)); };
        addAndMakeVisible (*meter);
        meters.push_back (std::move (meter));
        processor.session().meters().takePeak (i); // What was played before is not this device's.
        limited[static_cast<std::size_t> (i)] = processor.session().meters().limitedSamples (i);
    }

    shownMutes = processor.mutes();
    resized();
    repaint();
}

void MetersStrip::mute (std::size_t index)
{
    const auto bit = std::uint64_t (1) << index;
    const auto isMuted = meters[index]->getToggleState();
    history.record ([&] { processor.setMutes (isMuted ? processor.mutes() | bit : processor.mutes() & ~bit); });
    shownMutes = processor.mutes();
}

void MetersStrip::refresh (double seconds)
{
    auto& levels = processor.session().meters();
    const auto mutes = processor.mutes();

    for (std::size_t i = 0; i < meters.size(); ++i)
    {
        const auto samples = levels.limitedSamples (static_cast<int> (i));
        meters[i]->refresh (levels.takePeak (static_cast<int> (i)), samples > std::exchange (limited[i], samples),
                            seconds);

        if (mutes != shownMutes)
            meters[i]->setToggleState (((mutes >> i) & 1U) != 0, juce::dontSendNotification);
    }

    shownMutes = mutes;
}

void MetersStrip::paint (juce::Graphics& g)
{
    const auto& palette = EditorLook::findPalette (*this);
    g.fillAll (palette.panel);
    g.setColour (palette.mutedText);
    g.setFont (EditorLook::font (EditorLook::smallTextHeight));
    g.drawText ("Ceramics", getLocalBounds().withTrimmedLeft (margin).withWidth (captionWidth),
                juce::Justification::centredLeft);
}

void MetersStrip::resized()
{
    if (meters.empty())
        return;

    auto area = getLocalBounds().reduced (margin, 4).withTrimmedLeft (captionWidth);
    const auto count = static_cast<int> (meters.size());
    const auto left = area.getX();
    const auto width = std::min (widest * count, area.getWidth());

    for (int i = 0; i < count; ++i)
    {
        const auto from = left + i * width / count, to = left + (i + 1) * width / count;
        meters[static_cast<std::size_t> (i)]->setBounds (from, area.getY(), to - from - (width / count > 8 ? 1 : 0),
                                                         area.getHeight());
    }
}
} // namespace antinode
