#pragma once

#include "RoutingRow.h"

#include <memory>
#include <vector>

namespace antinode
{
/** Selects output and amplifier of each ceramic, and the monitor outputs. */
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

    AudioHost& host;
    juce::Label monitorName { {}, "Probe velocities on outputs" };
    juce::ComboBox monitor;
    juce::TextButton straight { "One to one" };
    juce::Viewport viewport;
    juce::Component list;
    std::vector<std::unique_ptr<RoutingRow>> rows;
    std::shared_ptr<const ModalModel> shownModel;
    int shownOutputs = -1;
};
} // namespace antinode
