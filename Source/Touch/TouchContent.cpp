#include "TouchContent.h"

#include <Editor/EditorLook.h>
#include <Eigen/Core>
#include <antinode_base/InputError.h>
#include <antinode_base/Prefixes.h>
#include <antinode_fingers/Sensation.h>
#include <antinode_session/UserMessages.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr int firstOsc = 9000, firstTuio = 3333, pairs = 4; // as many instances can listen at once
constexpr auto here = "127.0.0.1", everywhere = "0.0.0.0";

juce::String portsText (const TouchPorts& ports)
{
    return "OSC " + juce::String (ports.oscPort) + ", TUIO " + juce::String (ports.tuioPort);
}
} // namespace

TouchesButton::TouchesButton (TouchProcessor& processorToSet) : processor (processorToSet)
{
    setTooltip ("Touches by OSC and TUIO put fingers down, move and lift them. Click to open ports for them.");
    onClick = [this] { showMenu(); };
    refresh();
}

void TouchesButton::refresh()
{
    const auto ports = processor.network().ports();
    const auto isOpen = ports.oscPort != 0 || ports.tuioPort != 0;
    const auto& touches = processor.network().touches();
    auto text = isOpen ? portsText (ports) + ": " + juce::String (touches.resting()) + " down"
                       : juce::String ("OSC, TUIO: off");

    if (const auto waiting = touches.waiting(); waiting > 0)
        text << ", " << juce::String (waiting) << " wait";

    setButtonText (text);
}

void TouchesButton::open (const TouchPorts& ports)
{
    try
    {
        failure.clear();
        processor.network().open (ports);
    }
    catch (const InputError& error)
    {
        failure = juce::String::fromUTF8 (error.what());
    }

    refresh();
}

void TouchesButton::showMenu()
{
    const auto now = processor.network().ports();
    juce::PopupMenu menu;
    menu.addItem ("Off", true, now.oscPort == 0 && now.tuioPort == 0, [this] { open ({ 0, 0, here }); });

    for (const auto* const address : { here, everywhere })
    {
        menu.addSectionHeader (juce::String (address) == here ? "From this computer" : "From the network");

        for (int i = 0; i < pairs; ++i)
        {
            const TouchPorts ports { firstOsc + i, firstTuio + i, address };
            const auto isOpen =
                ports.oscPort == now.oscPort && ports.tuioPort == now.tuioPort && ports.address == now.address;
            menu.addItem (portsText (ports), true, isOpen, [this, ports] { open (ports); });
        }
    }

    menu.setLookAndFeel (&getLookAndFeel());
    menu.showMenuAsync (juce::PopupMenu::Options().withTargetComponent (*this).withDeletionCheck (*this));
}

namespace
{
constexpr int voltsHeight = 40, panelWidth = 330;
constexpr double feltFall = 20;        // dB per second
constexpr double waveformShown = 0.06; // s, beside each finger
} // namespace

TouchContent::TouchContent (TouchProcessor& processorToShow)
    : WindowContent ("Antinode Touch", { { 760, 560, 1300, 860 }, 1040, 640, 30, 44 }), processor (processorToShow),
      device (LibraryKind::device, "device",
              [this] (const auto& json, const auto& source)
              { processor.load (std::make_shared<const DeviceDocument> (readDeviceDocument (json, source))); }),
      focus (
          LibraryKind::focus, "focus",
          [this] (const auto& json, const auto& source)
          { processor.loadFocus (std::make_shared<const FocusDocument> (readFocusDocument (json, source))); },
          [this] { processor.loadFocus (nullptr); }),
      touchesButton (processor), surfaceView (processor), fingerPanel (processor.parameters()), drift (driftSource())
{
    device.setTooltip ("The device that the fingers rest on. Click to choose another.");
    focus.setTooltip (
        "The focus that MIDI notes play on top of the tracks: middle C at its own place, the others spread over "
        "the surface. Click to choose another, or none.");
    driftChoice.setClickingTogglesState (true);
    driftChoice.setTooltip ("The sensor that follows the drift of the device, and what it says");
    driftChoice.onClick = [this]
    {
        drift.setVisible (driftChoice.getToggleState());
        motions.setVisible (! drift.isVisible());
    };
    surfaceView.onSelect = [this] (std::size_t finger) { fingerPanel.select (finger); };
    bar.addLeft (device, 210);
    bar.addLeft (focus, 190);
    bar.addLeft (touchesButton, 260);
    bar.addRight (bar.theme, 34);
    bar.addRight (driftChoice, 60);

    for (juce::Component* const child :
         std::initializer_list<juce::Component*> { &surfaceView, &fingerPanel, &motions, &voltages })
        addAndMakeVisible (child);

    addChildComponent (drift);
    processor.session().setComparing (true);
    begin();
}

TouchContent::~TouchContent()
{
    processor.session().setComparing (false);
}

void TouchContent::refresh (double seconds)
{
    takeSnapshot();
    surfaceView.refresh (snapshot, fingerPanel.selected());
    fingerPanel.refresh();
    touchesButton.refresh();
    drift.refresh();
    showFingers (seconds);
    voltages.showVoltages (snapshot->model.get(), processor.session().meters(), seconds);
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
        device.setButtonText ("Device: " + fromUtf8 (processor.device()->description.name));
    }

    const auto notes = processor.focus();
    focus.setButtonText ("Notes: "
                         + (notes != nullptr ? fromUtf8 (notes->description.name) : juce::String ("nothing")));

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

void TouchContent::showStatus (double seconds)
{
    auto messages = touchSentences (processor, *snapshot);

    for (const auto& error : { device.error(), focus.error(), touchesButton.error() })
        addMessage (messages, Urgency::warning, error.toStdString());

    for (auto& message : messagesBeside())
        messages.push_back (std::move (message));

    status.show (std::move (messages), {}, seconds);

    if (const auto volts = latencyVoltsText (*snapshot, processor.parameters().controls());
        std::exchange (voltsText, volts) != volts)
        repaint();
}

void TouchContent::paint (juce::Graphics& g)
{
    WindowContent::paint (g);
    const auto& palette = look.palette();
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

void TouchContent::layOut (juce::Rectangle<int> area)
{
    area = area.reduced (gap);
    auto right = area.removeFromRight (panelWidth);
    area.removeFromRight (gap);
    fingerPanel.setBounds (right.removeFromTop (FingerPanel::height()));
    right.removeFromTop (voltsHeight + gap);
    motions.setBounds (right);
    drift.setBounds (right);
    voltages.setBounds (area.removeFromBottom (std::min (130, area.getHeight() / 4)));
    area.removeFromBottom (gap);
    surfaceView.setBounds (area);
}

namespace
{
std::string wholeNumber (double value)
{
    return std::to_string (std::lround (value));
}

/** What goes on. */
std::string progressSentence (TouchProcessor& processor, const TouchSnapshot& snapshot)
{
    const auto foci = processor.session().focusProgress();

    if (snapshot.isSolving)
        return "Solving the device.";

    if (snapshot.isDesigning)
        return "Designing the filters: " + wholeNumber (100 * snapshot.progress) + " %.";

    if (! foci.isDone())
        return std::string ("Designing the foci of notes")
               + (processor.session().fociUnderFingers() == FociUnderFingers::designing ? " for the fingers that rest: "
                                                                                        : ": ")
               + std::to_string (foci.designed) + " of " + std::to_string (foci.wanted) + ".";

    return {};
}

/** What the fingers' levels need more than there is. */
std::string loudSentence (TouchProcessor& processor, const TouchSnapshot& snapshot)
{
    const auto& parameters = processor.parameters();
    const auto volts = noiseVolts (snapshot, parameters.controls(), parameters.settings().latency);

    if (snapshot.model == nullptr || ! volts || *volts <= voltageLimits (*snapshot.model).minCoeff())
        return {};

    return "Loud: noise at these levels needs " + wholeNumber (*volts) + " V of "
           + wholeNumber (voltageLimits (*snapshot.model).minCoeff())
           + " V; what is beyond is cut, and then also felt elsewhere.";
}

std::string fociSentence (FociUnderFingers foci)
{
    return foci == FociUnderFingers::known      ? "The foci of notes know the fingers that rest."
           : foci == FociUnderFingers::outdated ? "Fingers have moved: the foci of notes are those from before, "
                                                  "until the fingers rest."
                                                : "";
}
} // namespace

std::optional<double> noiseVolts (const TouchSnapshot& snapshot, const PlayControls& controls, std::size_t latency)
{
    const auto& design = snapshot.designs[latency];

    if (design == nullptr)
        return {};

    // Noises of different inputs add by their powers; three times their RMS cancels against the inputs'.
    const Eigen::Map<const Eigen::ArrayXd> levels (controls.levels.data(), mostFingers);
    const Eigen::VectorXd powers = design->noiseGains.array().square().matrix() * levels.square().matrix();
    return std::sqrt (powers.maxCoeff());
}

juce::String latencyVoltsText (const TouchSnapshot& snapshot, const PlayControls& controls)
{
    juce::StringArray parts;

    for (std::size_t i = 0; i < touchLatencies.size(); ++i)
        if (const auto volts = noiseVolts (snapshot, controls, i))
            parts.add (juce::String (juce::roundToInt (1000 * touchLatencies[i])) + " ms: "
                       + (*volts < 10 ? juce::String (*volts, 1) : juce::String (juce::roundToInt (*volts))) + " V");

    return parts.joinIntoString (",  ");
}
std::vector<UserMessage> touchSentences (TouchProcessor& processor, const TouchSnapshot& snapshot)
{
    auto messages = processor.messages();

    if (auto progress = progressSentence (processor, snapshot); ! progress.empty())
    {
        addMessage (messages, Urgency::calm, progress);
        return messages;
    }

    if (! processor.parameters().arm().get())
        addMessage (messages, Urgency::calm, "Disarmed: all voltages are 0 V.");
    else
        addMessage (messages, Urgency::caution, loudSentence (processor, snapshot));

    const auto unplayable = unplayableNotesMessage (processor.session().focusProgress(), processor.getSampleRate());
    addMessage (messages, unplayable.urgency, unplayable.text);
    addMessage (messages, Urgency::calm, fociSentence (processor.session().fociUnderFingers()));
    return messages;
}
} // namespace antinode
