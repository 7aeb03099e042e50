#pragma once

#include "AudioHost.h"
#include "PanelParts.h"

#include <juce_gui_basics/juce_gui_basics.h>

#include <memory>
#include <vector>

namespace antinode
{
/** One ceramic: its output, the amplifier behind it, its identify tone, its level. */
class RoutingRow final : public juce::Component
{
public:
    /** @param hostToUse  outlives this @param ceramicToShow  from 0 @param outputs  to choose from [message thread] */
    RoutingRow (AudioHost& hostToUse, int ceramicToShow, int outputs);

    /** Shows what the host's routing says. [message thread] */
    void update();

    /** Shows levels and the tone; a few times a second. [message thread] */
    void updateLevel();

    void lookAndFeelChanged() override;
    void resized() override;

    /** The headings of the columns in the colour that is set, above rows of the same width. [message thread] */
    static void paintHeadings (juce::Graphics&, juce::Rectangle<int>);

private:
    int output() const { return host.settings().routing.outputs[static_cast<std::size_t> (ceramic)]; }
    void changeChain();

    AudioHost& host;
    int ceramic;
    std::int64_t clampedBefore = 0; ///< Samples of its output, when it was last another one's.
    int clampedOutput = OutputRouting::none;
    juce::Label name;
    juce::ComboBox outputChoice;
    juce::TextEditor volts;
    juce::TextButton polarity, identify { "Identify" };
    LevelBar level;
};

/** Selects output and amplifier of each ceramic, the monitor outputs, and that of the marker. */
class RoutingPanel final : public juce::Component, private juce::Timer
{
public:
    /** @param hostToUse  outlives this [message thread] */
    explicit RoutingPanel (AudioHost& hostToUse);

    /** Shows the routing as it is now, for the device as it is now. [message thread] */
    void update();

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    void timerCallback() override;
    void makeRows (int ceramics, int outputs);
    void forgetLevels();
    void updateMarker();
    void changeMarker();

    AudioHost& host;
    juce::Label monitorName { {}, "Probe velocities on outputs" };
    juce::ComboBox monitor;
    juce::Label markerName { {}, "Pulse at each focus on output" };
    juce::ComboBox markerOutput;
    juce::TextEditor markerLevel, markerLength;
    juce::TextButton straight { "One to one" };
    juce::Viewport viewport;
    juce::Component list;
    std::vector<std::unique_ptr<RoutingRow>> rows;
    std::shared_ptr<const ModalModel> shownModel;
    int shownOutputs = -1;
};
} // namespace antinode
