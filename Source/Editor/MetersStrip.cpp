#include "MetersStrip.h"

#include "EditorLook.h"
#include "LevelRows.h"

#include <algorithm>

namespace antinode
{
namespace
{
constexpr double lampSeconds = 1.5, fallPerSecond = 1.2, holdPerSecond = 0.25;
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
