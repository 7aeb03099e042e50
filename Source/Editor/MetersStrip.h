#pragma once

#include "CeramicMeter.h"
#include "History.h"

#include <antinode_model/ModalModel.h>

#include <array>
#include <memory>
#include <vector>

namespace antinode
{
/** The meters of all ceramics of the device, side by side. [message thread] */
class MetersStrip final : public juce::Component
{
public:
    MetersStrip (AntinodeProcessor&, History&);

    void setModel (const std::shared_ptr<const ModalModel>&);

    /** @param seconds  since the last call */
    void refresh (double seconds);

    void paint (juce::Graphics&) override;
    void resized() override;

private:
    void mute (std::size_t index);

    AntinodeProcessor& processor;
    History& history;
    std::vector<std::unique_ptr<CeramicMeter>> meters;
    std::array<std::int64_t, LevelMeters::ceramics> limited {};
    std::uint64_t shownMutes = 0;
};
} // namespace antinode
