#pragma once

#include <antinode_session/AudioPath.h>

#include <juce_audio_processors/juce_audio_processors.h>

#include <array>
#include <optional>
#include <vector>

namespace antinode
{
/** The channels of ceramics, monitor and sensor in a host's buffer. */
class BufferChannels
{
public:
    static constexpr int maximumCeramics = 64, maximumMonitors = 2;

    /** Room for what a block points to. */
    template <typename Sample>
    struct Pointers
    {
        std::array<Sample*, maximumCeramics> ceramics {};
        std::array<Sample*, maximumMonitors> monitor {};
    };

    /** Takes the layout that the host has chosen. @param wrapper  decides how channels are laid on wires
        [worker] nothing may be processing */
    void lay (const juce::AudioProcessor&, juce::AudioProcessor::WrapperType wrapper);

    /** A block on the channels of a buffer; those beyond are cleared. None if the buffer has fewer than the host asked
       for. [audio thread] */
    template <typename Sample>
    std::optional<OutputBlock<Sample>> makeBlock (juce::AudioBuffer<Sample>&, Pointers<Sample>&) const;

private:
    std::vector<int> ceramicOrder; ///< Buffer channel of ceramic k.
    int firstMonitor = 0, monitors = 0;
    bool hasSensor = false; ///< In the buffer's first channel, where a ceramic is written later.
};
} // namespace antinode
