#include "RoutingPanel.h"

#include "PanelParts.h"

#include <Editor/EditorLook.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr int nameWidth = 30, outputWidth = 66, voltsWidth = 60, polarityWidth = 30, identifyWidth = 66, gap = 6;
constexpr int noOutput = OutputRouting::maximumOutputs + 1; // identifiers of a choice cannot be 0

constexpr int headHeight = 22, levelMilliseconds = 50;
constexpr int noMonitor = OutputRouting::maximumOutputs + 1;
} // namespace

RoutingRow::RoutingRow (AudioHost& hostToUse, int ceramicToShow, int outputs)
    : host (hostToUse), ceramic (ceramicToShow)
{
    name.setText (juce::String (ceramic + 1), juce::dontSendNotification);
    outputChoice.addItem ("none", noOutput);

    for (int i = 0; i < outputs; ++i)
        outputChoice.addItem (juce::String (i + 1), i + 1);

    outputChoice.onChange = [this]
    {
        const auto chosen = outputChoice.getSelectedId();
        host.setRouting (
            withOutput (host.settings().routing, ceramic, chosen == noOutput ? OutputRouting::none : chosen - 1));
    };
    volts.setInputRestrictions (10, "0123456789.,V ");
    name.setFont (EditorLook::font (EditorLook::smallTextHeight));
    volts.setFont (EditorLook::font (EditorLook::smallTextHeight));
    volts.setJustification (juce::Justification::centredLeft);
    volts.setTooltip (
        "Voltage at the ceramic for a full-scale sample, V. Empty: the value of the device, shown in grey.");
    volts.setEscapeAndReturnKeysConsumed (false);
    volts.onReturnKey = volts.onFocusLost = [this] { changeChain(); };
    polarity.setClickingTogglesState (true);
    polarity.onClick = [this] { changeChain(); };
    polarity.setTooltip ("Polarity: minus for swapped wires");
    identify.setTooltip ("Plays soft bursts on this ceramic only, to identify it. Works only while armed.");
    level.setTooltip ("Peak of the output, from 60 dB below full scale. The lamp shows that samples beyond full "
                      "scale were clamped.");
    identify.onClick = [this]
    { host.router().identify (host.router().identified() == ceramic ? OutputRouting::none : ceramic); };

    for (auto* const child :
         std::initializer_list<juce::Component*> { &name, &outputChoice, &volts, &polarity, &identify, &level })
        addAndMakeVisible (child);

    update();
}

void RoutingRow::update()
{
    const auto isRouted = output() != OutputRouting::none;
    const auto& routing = host.settings().routing;
    const auto chain = isRouted ? routing.chains[static_cast<std::size_t> (output())] : OutputChain {};
    outputChoice.setSelectedId (isRouted ? output() + 1 : noOutput, juce::dontSendNotification);

    if (! volts.hasKeyboardFocus (true))
        volts.setText (chain.voltsPerFullScale > 0 ? juce::String (chain.voltsPerFullScale) : juce::String(), false);

    // Not that of the last block, which may be the device's before.
    const auto model = host.model();
    const auto fullScale = model != nullptr ? model->fullScaleVoltage : 0.0;
    volts.setTextToShowWhenEmpty (fullScale > 0 ? juce::String (fullScale) : juce::String(),
                                  EditorLook::findPalette (*this).mutedText);
    polarity.setToggleState (chain.polarity < 0, juce::dontSendNotification);
    polarity.setButtonText (chain.polarity < 0 ? juce::String::charToString (0x2212) : juce::String ("+"));
    volts.setEnabled (isRouted);
    polarity.setEnabled (isRouted);
}

void RoutingRow::updateLevel()
{
    const auto isArmed = host.arm().get();
    identify.setEnabled (isArmed && output() != OutputRouting::none);
    identify.setToggleState (host.router().identified() == ceramic, juce::dontSendNotification);

    if (output() == OutputRouting::none)
        return level.show (0, 0);

    const auto clamped = host.router().meters().clampedSamples (output());

    // What the device or the ceramic before had there is not meant.
    if (std::exchange (clampedOutput, output()) != output())
        clampedBefore = clamped;

    level.show (host.router().meters().takePeak (output()), clamped - clampedBefore);
}

void RoutingRow::changeChain()
{
    if (output() == OutputRouting::none)
        return;

    auto routing = host.settings().routing;
    auto& chain = routing.chains[static_cast<std::size_t> (output())];
    const auto text = volts.getText().trim().toStdString();
    chain = { text.empty() ? 0.0 : typedNumber (text, { "V" }).value_or (chain.voltsPerFullScale),
              polarity.getToggleState() ? -1 : 1 };
    host.setRouting (routing);
}

void RoutingRow::lookAndFeelChanged()
{
    volts.applyColourToAllText (EditorLook::findPalette (*this).text);
    update();
}

void RoutingRow::resized()
{
    auto area = getLocalBounds().reduced (0, 2);
    const auto take = [&] (int width)
    {
        const auto taken = area.removeFromLeft (width);
        area.removeFromLeft (gap);
        return taken;
    };
    name.setBounds (take (nameWidth));
    outputChoice.setBounds (take (outputWidth));
    volts.setBounds (take (voltsWidth));
    polarity.setBounds (take (polarityWidth));
    identify.setBounds (take (identifyWidth));
    level.setBounds (area);
}

void RoutingRow::paintHeadings (juce::Graphics& g, juce::Rectangle<int> area)
{
    g.setFont (EditorLook::font (EditorLook::smallTextHeight));
    const auto write = [&] (const char* text, int width)
    { g.drawText (text, area.removeFromLeft (width + gap), juce::Justification::centredLeft); };
    write ("C", nameWidth);
    write ("Output", outputWidth);
    write ("V at full scale", voltsWidth + polarityWidth + gap);
    write ("", identifyWidth);
    g.drawText ("Level", area, juce::Justification::centredLeft);
    g.drawText ("Clamped", area, juce::Justification::centredRight);
}

RoutingPanel::RoutingPanel (AudioHost& hostToUse) : host (hostToUse)
{
    monitorName.setFont (EditorLook::font (EditorLook::smallTextHeight));
    viewport.setViewedComponent (&list, false);
    viewport.setScrollBarsShown (true, false);
    straight.setTooltip ("Assigns every ceramic to the output of its number, without monitor");
    straight.onClick = [this] { host.setRouting (straightRouting()); };
    monitor.onChange = [this]
    {
        const auto chosen = monitor.getSelectedId();
        host.setRouting (withMonitor (host.settings().routing, chosen == noMonitor ? OutputRouting::none : chosen - 1));
    };

    markerName.setFont (EditorLook::font (EditorLook::smallTextHeight));
    markerOutput.onChange = [this] { changeMarker(); };
    markerLevel.setTooltip ("Height of the pulse, % of full scale");
    markerLength.setTooltip ("How long the pulse lasts, ms");

    for (auto* const editor : { &markerLevel, &markerLength })
    {
        editor->setFont (EditorLook::font (EditorLook::smallTextHeight));
        editor->setJustification (juce::Justification::centredLeft);
        editor->setInputRestrictions (8, "0123456789.,%ms ");
        editor->onReturnKey = editor->onFocusLost = [this] { changeMarker(); };
    }

    for (auto* const child : std::initializer_list<juce::Component*> {
             &viewport, &monitorName, &monitor, &straight, &markerName, &markerOutput, &markerLevel, &markerLength })
        addAndMakeVisible (child);

    // Fingers have no probes.
    monitorName.setVisible (host.playsFoci());
    monitor.setVisible (host.playsFoci());
    update();
    startTimer (levelMilliseconds);
}

void RoutingPanel::update()
{
    const auto model = host.model();
    const auto ceramics =
        model != nullptr ? std::min (static_cast<int> (model->actuators()), OutputRouting::maximumCeramics) : 0;
    auto* const device = host.devices().getCurrentAudioDevice();
    const auto channels = device != nullptr ? device->getOutputChannelNames().size() : 0;
    const auto& routing = host.settings().routing;
    const auto used = *std::max_element (routing.outputs.begin(), routing.outputs.begin() + std::max (1, ceramics)) + 1;
    const auto outputs = std::clamp (
        std::max ({ channels, ceramics, used, routing.monitor + OutputRouting::monitors, routing.marker.output + 1 }),
        0, OutputRouting::maximumOutputs);

    const auto isOtherDevice = std::exchange (shownModel, model) != model;

    if (isOtherDevice)
        forgetLevels();

    if (isOtherDevice || ceramics != static_cast<int> (rows.size()) || outputs != shownOutputs)
        makeRows (ceramics, outputs);

    for (auto& row : rows)
        row->update();

    monitor.setSelectedId (routing.monitor == OutputRouting::none ? noMonitor : routing.monitor + 1,
                           juce::dontSendNotification);
    updateMarker();
}

void RoutingPanel::updateMarker()
{
    const auto& marker = host.settings().routing.marker;
    markerOutput.setSelectedId (marker.output == OutputRouting::none ? noOutput : marker.output + 1,
                                juce::dontSendNotification);
    const auto show = [] (juce::TextEditor& editor, double value, const char* unit)
    {
        if (! editor.hasKeyboardFocus (true))
            editor.setText (juce::String (inWords (value)) + unit, false);
    };
    show (markerLevel, 100 * marker.level, " %");
    show (markerLength, milli * marker.seconds, " ms");
    markerLevel.setEnabled (marker.output != OutputRouting::none);
    markerLength.setEnabled (marker.output != OutputRouting::none);
}

/** What is out of range stays as it was. */
void RoutingPanel::changeMarker()
{
    constexpr double longest = 1; // s
    auto marker = host.settings().routing.marker;
    const auto typed = [] (const juce::TextEditor& editor, const char* unit, double scale, double most, double before)
    {
        const auto value = typedNumber (editor.getText().trim().toStdString(), { unit }).value_or (-1) / scale;
        return value > 0 && value <= most ? value : before;
    };
    marker.output = markerOutput.getSelectedId() == noOutput ? OutputRouting::none : markerOutput.getSelectedId() - 1;
    marker.level = typed (markerLevel, "%", 100, 1, marker.level);
    marker.seconds = typed (markerLength, "ms", milli, longest, marker.seconds);

    if (marker != host.settings().routing.marker)
        host.setRouting (withMarker (host.settings().routing, marker));
}

void RoutingPanel::makeRows (int ceramics, int outputs)
{
    shownOutputs = outputs;
    rows.clear();

    for (int k = 0; k < ceramics; ++k)
    {
        rows.push_back (std::make_unique<RoutingRow> (host, k, outputs));
        list.addAndMakeVisible (*rows.back());
    }

    monitor.clear (juce::dontSendNotification);
    monitor.addItem ("none", noMonitor);
    markerOutput.clear (juce::dontSendNotification);
    markerOutput.addItem ("none", noOutput);

    for (int i = 0; i + 1 < outputs; ++i)
        monitor.addItem (juce::String (i + 1) + " and " + juce::String (i + 2), i + 1);

    for (int i = 0; i < outputs; ++i)
        markerOutput.addItem (juce::String (i + 1), i + 1);

    resized();
}

/** What the device before played is none of this one's. */
void RoutingPanel::forgetLevels()
{
    for (int i = 0; i < OutputRouting::maximumOutputs; ++i)
        host.router().meters().takePeak (i);
}

void RoutingPanel::timerCallback()
{
    // Taken also while it is hidden: a peak of long ago is none.
    for (auto& row : rows)
        row->updateLevel();
}

void RoutingPanel::paint (juce::Graphics& g)
{
    g.setColour (EditorLook::findPalette (*this).mutedText);
    RoutingRow::paintHeadings (
        g, viewport.getBounds().translated (0, -headHeight).withHeight (headHeight).withWidth (list.getWidth()));
}

void RoutingPanel::resized()
{
    auto area = getLocalBounds().reduced (panelMargin);
    area.removeFromTop (headHeight);
    auto foot = area.removeFromBottom (panelRowHeight).reduced (0, 2);
    straight.setBounds (foot.removeFromRight (90));
    foot.removeFromRight (panelMargin);
    monitor.setBounds (foot.removeFromRight (110));
    monitorName.setBounds (foot);
    auto last = area.removeFromBottom (panelRowHeight).reduced (0, 2);
    markerLength.setBounds (last.removeFromRight (voltsWidth));
    last.removeFromRight (gap);
    markerLevel.setBounds (last.removeFromRight (voltsWidth));
    last.removeFromRight (gap);
    markerOutput.setBounds (last.removeFromRight (outputWidth));
    markerName.setBounds (last);
    area.removeFromBottom (panelMargin);
    viewport.setBounds (area);
    list.setSize (area.getWidth() - viewport.getScrollBarThickness() - panelMargin / 2,
                  panelRowHeight * static_cast<int> (rows.size()));

    for (int k = 0; k < static_cast<int> (rows.size()); ++k)
        rows[static_cast<std::size_t> (k)]->setBounds (0, k * panelRowHeight, list.getWidth(), panelRowHeight);
}
} // namespace antinode
