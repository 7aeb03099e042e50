#include "TouchContent.h"

#include "LatencyVolts.h"
#include "TouchSentences.h"

#include <antinode_base/Prefixes.h>
#include <antinode_felt/FeltMotion.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr int touchTop = 44, touchGap = 6, voltsHeight = 40, panelWidth = 330;
constexpr double feltFall = 20;        // dB per second
constexpr double waveformShown = 0.06; // s, beside each finger
} // namespace

TouchContent::TouchContent (TouchProcessor& processorToShow)
    : processor (processorToShow), device ([this] (auto chosen) { processor.load (std::move (chosen)); }),
      focus (processor), touchesButton (processor), surfaceView (processor), fingerPanel (processor.parameters()),
      drift (driftSource()), tooltips (this, 600)
{
    juce::LookAndFeel::setDefaultLookAndFeel (&fonts.get());
    setLookAndFeel (&look);
    setTitle ("Antinode Touch");
    device.setTooltip ("The device that the fingers rest on. Click to choose another.");
    theme.setButtonText (juce::String::fromUTF8 ("\xE2\x97\x90"));
    theme.setTitle ("Light or dark");
    theme.setTooltip ("Light or dark");
    theme.onClick = [this] { setDark (! isDark()); };
    driftChoice.setClickingTogglesState (true);
    driftChoice.setTooltip ("The sensor that follows the drift of the device, and what it says");
    driftChoice.onClick = [this]
    {
        drift.setVisible (driftChoice.getToggleState());
        motions.setVisible (! drift.isVisible());
    };
    surfaceView.onSelect = [this] (std::size_t finger) { fingerPanel.select (finger); };

    for (juce::Component* const child :
         std::initializer_list<juce::Component*> { &device, &focus, &touchesButton, &driftChoice, &theme, &surfaceView,
                                                   &fingerPanel, &motions, &voltages, &statusView })
        addAndMakeVisible (child);

    statusView.onHeight = [this] { resized(); };
    addChildComponent (drift);
    processor.session().setComparing (true);
    setDark (true);
    setSize (sizes.leastWidth, sizes.leastHeight);
    refresh (0);
}

TouchContent::~TouchContent()
{
    processor.session().setComparing (false);
    rest->stop();
    setLookAndFeel (nullptr);
}

void TouchContent::setDark (bool isDark)
{
    look.setPalette (isDark ? Palette::dark() : Palette::light());
    sendLookAndFeelChange();

    if (onTheme)
        onTheme();
}

void TouchContent::lookAndFeelChanged()
{
    for (juce::TextButton* const button :
         std::initializer_list<juce::TextButton*> { &device, &focus, &touchesButton, &driftChoice, &theme })
    {
        button->setColour (juce::TextButton::buttonColourId, look.palette().raised);
        button->setColour (juce::TextButton::textColourOffId, look.palette().text);
    }

    repaint();
}

void TouchContent::refresh (double seconds)
{
    takeSnapshot();
    surfaceView.refresh (snapshot, fingerPanel.selected());
    fingerPanel.refresh();
    focus.refresh();
    touchesButton.refresh();
    drift.refresh();
    showFingers (seconds);
    showVoltages (seconds);
    showStatus (seconds);
}

DriftPanelSource TouchContent::driftSource()
{
    auto& following = processor.session().following();
    return { following,
             [this] { return processor.session().snapshot()->model; },
             [&following] (const auto& wanted) { following.setSettings (wanted); },
             {} };
}

void TouchContent::takeSnapshot()
{
    if (auto now = processor.session().snapshot(); now != snapshot)
    {
        if (snapshot == nullptr || now->model != snapshot->model)
        {
            auto atRest = std::make_shared<PlateSnapshot>();
            atRest->model = now->model;
            rest->watch (std::move (atRest));
            voltages.forget();
            fingerPanel.refreshTexts (now->model != nullptr && now->model->surface.kind == SurfaceKind::line);
        }

        snapshot = std::move (now);
        device.setDevice (*processor.device());
    }

    if (auto newest = rest->picture(); newest != nullptr && newest != picture)
    {
        picture = std::move (newest);
        surfaceView.setPicture (picture);
    }
}

void TouchContent::showFingers (double seconds)
{
    const auto settings = processor.parameters().settings();
    const auto controls = processor.parameters().controls();
    auto& meters = processor.session().fingerMeters();
    std::vector<LevelRows::Row> rows;
    std::vector<double> values;
    std::array<AskedMotion, mostFingers> beside;

    for (int k = 0; k < processor.inputs(); ++k)
    {
        const auto finger = static_cast<std::size_t> (k);
        const auto amount = static_cast<double> (meters.felt.take (k));
        felt[finger] = std::max (sensationLevel (amount), felt[finger] - feltFall * seconds);
        values.push_back (micro * static_cast<double> (meters.displacements.take (k)));
        const auto text = settings.fingers[finger].presence == FingerPresence::absent   ? "absent"
                          : settings.fingers[finger].presence == FingerPresence::silent ? "silent"
                          : felt[finger] > 0 ? "felt " + juce::String (juce::roundToInt (felt[finger])) + " dB"
                                             : juce::String ("not felt");
        rows.push_back ({ juce::String (k + 1), text, micro * std::max (controls.levels[finger], 1e-9) });

        if (settings.fingers[finger].presence == FingerPresence::plays)
            beside[finger] = askedOf (meters, finger, controls.levels[finger]);
    }

    motions.setRows (std::move (rows));
    motions.refresh (values, seconds);
    surfaceView.show (std::move (beside));
}

/** The last waveform of a finger with what it comes to; nothing while it is asked for nothing. */
AskedMotion TouchContent::askedOf (const FingerMeters& meters, std::size_t finger, double level) const
{
    const auto count = static_cast<std::size_t> (std::lround (waveformShown * meters.traceRate));

    if (count < 2 || ! (level > 0))
        return {};

    AskedMotion motion { meters.traces[finger].newest (std::min (count, FingerTrace::length)), level, {} };
    const auto peak = static_cast<double> (*std::max_element (
        motion.waveform.begin(), motion.waveform.end(), [] (float a, float b) { return std::abs (a) < std::abs (b); }));

    if (std::abs (peak) < 1e-3 * level)
        return {};

    motion.words = juce::String (micro * std::abs (peak), 1) + juce::String::fromUTF8 (" \xC2\xB5m, ")
                   + (felt[finger] > 0 ? "felt " + juce::String (juce::roundToInt (felt[finger])) + " dB"
                                       : juce::String ("not felt"));
    return motion;
}

void TouchContent::showVoltages (double seconds)
{
    std::vector<LevelRows::Row> rows;
    std::vector<double> values;

    for (int i = 0; snapshot->model != nullptr && i < static_cast<int> (snapshot->model->actuators()); ++i)
    {
        rows.push_back ({ juce::String (i + 1), {}, voltageLimit (*snapshot->model, static_cast<std::size_t> (i)) });
        values.push_back (static_cast<double> (processor.session().meters().takePeak (i)));
    }

    voltages.setRows (std::move (rows));
    voltages.refresh (values, seconds);
}

void TouchContent::showStatus (double seconds)
{
    auto messages = touchSentences (processor, *snapshot);

    for (const auto& error : { device.error(), focus.error(), touchesButton.error() })
        addMessage (messages, Urgency::warning, error.toStdString());

    for (auto& message : moreMessages ? moreMessages() : std::vector<UserMessage>())
        messages.push_back (std::move (message));

    statusView.show (std::move (messages), {}, seconds);

    if (const auto volts = latencyVoltsText (*snapshot, processor.parameters().controls());
        std::exchange (voltsText, volts) != volts)
        repaint();
}

void TouchContent::paint (juce::Graphics& g)
{
    const auto& palette = look.palette();
    g.fillAll (palette.window);
    auto area = getLocalBounds();
    g.setColour (palette.panel);
    g.fillRect (area.removeFromTop (touchTop));
    g.setFont (EditorLook::font (EditorLook::smallTextHeight));
    auto box = fingerPanel.getBounds().withY (fingerPanel.getBottom()).withHeight (voltsHeight);
    g.setColour (palette.panel);
    g.fillRect (box);
    box = box.reduced (10, 2);
    g.setColour (palette.mutedText);
    g.drawText ("Noise at these levels costs, by latency:", box.removeFromTop (box.getHeight() / 2),
                juce::Justification::centredLeft);
    g.setColour (palette.text);
    g.drawText (voltsText, box, juce::Justification::centredLeft);
}

void TouchContent::resized()
{
    auto area = getLocalBounds();
    auto top = area.removeFromTop (touchTop).reduced (8, 6);
    statusView.setBounds (area.removeFromBottom (statusView.wantedHeight()));
    device.setBounds (top.removeFromLeft (210));
    top.removeFromLeft (touchGap);
    focus.setBounds (top.removeFromLeft (190));
    theme.setBounds (top.removeFromRight (34));
    top.removeFromRight (touchGap);
    driftChoice.setBounds (top.removeFromRight (60));
    top.removeFromRight (touchGap);
    touchesButton.setBounds (top.removeFromRight (std::min (260, top.getWidth() - touchGap)));
    area = area.reduced (touchGap);
    auto right = area.removeFromRight (panelWidth);
    area.removeFromRight (touchGap);
    fingerPanel.setBounds (right.removeFromTop (FingerPanel::height()));
    right.removeFromTop (voltsHeight + touchGap);
    motions.setBounds (right);
    drift.setBounds (right);
    voltages.setBounds (area.removeFromBottom (std::min (130, area.getHeight() / 4)));
    area.removeFromBottom (touchGap);
    surfaceView.setBounds (area);
}
} // namespace antinode
