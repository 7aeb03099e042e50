#include "AudioEntry.h"

#include "NoteBank.h"

#include <algorithm>
#include <utility>

namespace antinode
{
bool TriggerQueue::push (const FocusEvent& event, std::uint64_t askedAt)
{
    const std::lock_guard lock (pushing);
    return waiting.push ({ event, askedAt });
}

TriggerQueue::Taken TriggerQueue::pop (std::span<FocusEvent> events)
{
    // First how many, then the stop: so none of them was asked for after a stop that is not seen yet.
    auto left = std::min (waiting.size(), events.size());
    Taken taken { 0, stops.now() };

    for (; left > 0; --left)
        if (const auto next = waiting.pop().value(); next.askedAt == taken.stop)
            events[taken.count++] = next.event;

    return taken;
}

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
