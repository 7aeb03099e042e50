#include "AudioEntry.h"

#include "NoteBank.h"

#include <algorithm>

namespace antinode
{
void AudioEntry::prepare (double sampleRate)
{
    preparedRate = sampleRate;
    paths.reset();
}

int AudioEntry::eventPlace (const FocusEvent& event) const
{
    return bankPlaceOf (event.place, playsSpotOnly);
}

/** The events of the block with those that came from elsewhere before them; a note's place becomes the bank's. */
std::span<const FocusEvent> AudioEntry::gather (std::span<const FocusEvent> events)
{
    std::size_t waiting = 0;

    if (isStopRequested.exchange (false))
        blockEvents[waiting++] = { 0, FocusEventKind::stopAll, 0, 0 };

    waiting +=
        static_cast<std::size_t> (triggers.pop (std::span (blockEvents).subspan (waiting, blockEvents.size() / 2)));
    const auto count = std::min (events.size(), blockEvents.size() - waiting);
    std::copy_n (events.begin(), count, blockEvents.begin() + static_cast<std::ptrdiff_t> (waiting));

    for (auto& event : std::span (blockEvents).subspan (waiting, count))
        event.place = eventPlace (event);

    return { blockEvents.data(), waiting + count };
}

template <typename Sample>
void AudioEntry::process (const OutputBlock<Sample>& block, std::span<const FocusEvent> events,
                          const PlayControls& controls)
{
    if (auto* const current = paths.current (preparedRate, block.count))
    {
        auto now = controls;
        now.isArmed = controls.isArmed && ! paths.isLeaving();
        fullScale = current->model().fullScaleVoltage;
        current->process (block, gather (events), now, levels, trace);
        return;
    }

    for (auto* const channel : block.ceramics)
        std::fill_n (channel, block.count, Sample (0));

    for (auto* const channel : block.monitor)
        std::fill_n (channel, block.count, Sample (0));
}

template void AudioEntry::process (const OutputBlock<float>&, std::span<const FocusEvent>, const PlayControls&);
template void AudioEntry::process (const OutputBlock<double>&, std::span<const FocusEvent>, const PlayControls&);
} // namespace antinode
