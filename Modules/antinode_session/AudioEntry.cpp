#include "AudioEntry.h"

#include "NoteBank.h"

#include <algorithm>
#include <utility>

namespace antinode
{
void AudioEntry::prepare (double sampleRate)
{
    preparedRate = sampleRate;
    paths.reset();
    stopCount.stop();
    held.reset();
}

int AudioEntry::eventPlace (const FocusEvent& event) const
{
    return bankPlaceOf (event.place, playsSpotOnly);
}

/** The events of the block with those that came from elsewhere before them; a note's place becomes the bank's. */
std::span<const FocusEvent> AudioEntry::gather (std::span<const FocusEvent> events)
{
    const std::span all (blockEvents);
    const auto [waiting, stop] = triggers.pop (all.subspan (1, TriggerQueue::capacity));
    const auto isStopped = std::exchange (playedStop, stop) != stop;
    all.front() = { 0, FocusEventKind::stopAll, 0, 0 };
    const auto own = all.subspan (1 + waiting, std::min (events.size(), mostOfBlock));
    std::copy_n (events.begin(), own.size(), own.begin());

    for (auto& event : own)
        if (isStop (event))
            playedStop = stopCount.stopByNote(); // Touches that are being designed were asked for before it.
        else
            event.place = eventPlace (event);

    return all.subspan (isStopped ? 0 : 1, own.size() + waiting + (isStopped ? 1 : 0));
}

template <typename Sample>
void AudioEntry::process (const AudioBlock<Sample>& block, const PlayControls& controls)
{
    if (auto* const current = paths.current (preparedRate, block.count))
    {
        auto now = controls;
        now.isArmed = controls.isArmed && ! paths.isLeaving();
        fullScale = current->model().fullScaleVoltage;
        current->process (block, held.process (gather (block.events), block.count, 0, paths.isLeaving()), now, levels,
                          trace);
        return;
    }

    // Triggers wait for a path, but not beyond a stop.
    if (std::any_of (block.events.begin(), block.events.end(), isStop))
        stopCount.stopByNote();

    block.silence();
}

template void AudioEntry::process (const AudioBlock<float>&, const PlayControls&);
template void AudioEntry::process (const AudioBlock<double>&, const PlayControls&);
} // namespace antinode
