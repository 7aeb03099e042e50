#include "RoutingPanel.h"

#include "PanelSizes.h"

#include <Editor/EditorLook.h>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr int headHeight = 22, levelMilliseconds = 50;
constexpr int noMonitor = OutputRouting::maximumOutputs + 1;
} // namespace

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

    for (auto* const child : std::initializer_list<juce::Component*> { &viewport, &monitorName, &monitor, &straight })
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
    const auto outputs = std::clamp (std::max ({ channels, ceramics, used, routing.monitor + OutputRouting::monitors }),
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

    for (int i = 0; i + 1 < outputs; ++i)
        monitor.addItem (juce::String (i + 1) + " and " + juce::String (i + 2), i + 1);

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
    area.removeFromBottom (panelMargin);
    viewport.setBounds (area);
    list.setSize (area.getWidth() - viewport.getScrollBarThickness() - panelMargin / 2,
                  panelRowHeight * static_cast<int> (rows.size()));

    for (int k = 0; k < static_cast<int> (rows.size()); ++k)
        rows[static_cast<std::size_t> (k)]->setBounds (0, k * panelRowHeight, list.getWidth(), panelRowHeight);
}
} // namespace antinode
