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
    waiting.reset();
}

/** The events of a block with those that came from elsewhere before them; a note becomes a place of the bank, as loud
   as the gain has it. Only stops are left where notes play nothing. */
std::span<const FocusEvent> AudioEntry::gather (std::span<const FocusEvent> events, double focusGain)
{
    const std::span all (blockEvents);
    const auto [fired, stop] = triggers.pop (all.subspan (1, TriggerQueue::capacity));
    const auto isStopped = std::exchange (playedStop, stop) != stop;
    const auto playedNotes = notes();
    auto count = 1 + fired;
    all.front() = { 0, FocusEventKind::stopAll, 0, 0 };

    for (const auto& event : events.first (std::min (events.size(), EventDelay::mostPerBlock)))
        if (isStop (event))
        {
            playedStop = stopCount.stopByNote(); // Foci that are being designed were fired before it.
            all[count++] = event;
        }
        else if (playedNotes != NoteMeaning::nothing)
            all[count++] = { event.offset, event.kind, bankPlaceOf (event.place, playedNotes),
                             event.amplitude * focusGain };

    return all.first (count).subspan (isStopped ? 0 : 1);
}

template <typename Sample>
void AudioEntry::process (const AudioBlock<Sample>& block, const PlayControls& controls)
{
    if (auto* const current = paths.current (preparedRate, block.count))
    {
        auto now = controls;
        now.isArmed = controls.isArmed && ! paths.isLeaving();
        fullScale = current->model().fullScaleVoltage;
        current->process (block,
                          waiting.process (gather (block.events, controls.focusGain), block.count,
                                           current->noteDelay (controls), paths.isLeaving()),
                          now, played);
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
