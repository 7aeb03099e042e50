#include "MetersStrip.h"

#include "EditorLook.h"

#include <algorithm>

namespace antinode
{
namespace
{
constexpr int widest = 112, margin = 8, captionWidth = 66;
} // namespace

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
