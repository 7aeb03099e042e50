#include "AudioEntry.h"

#include "NoteBank.h"

#include <algorithm>
#include <utility>

namespace antinode
{
bool TriggerQueue::push (const Fired& trigger)
{
    const std::lock_guard lock (pushing);
    return waiting.push (trigger);
}

std::pair<std::size_t, std::uint64_t> TriggerQueue::pop (std::span<Fired> fired)
{
    // First how many, then the stop: so none of them was asked for after a stop that is not seen yet.
    const auto count = std::min (waiting.size(), fired.size());
    const auto stop = stops.now();
    std::generate_n (fired.begin(), count, [this] { return waiting.pop().value(); });
    return { count, stop };
}

void AudioEntry::prepare (double sampleRate)
{
    preparedRate = sampleRate;
    paths.reset();
    stopCount.stop();
    waiting.reset();
}

/** Those of the queue that are due in this block, and those that were scheduled earlier; void ones are told. A newer
    stop than the last one comes first. */
std::size_t AudioEntry::takeFired (std::span<FocusEvent> events, int count)
{
    const auto popped = triggers.pop (fired);
    const auto taken = popped.first;
    const auto stop = popped.second;
    std::size_t due = 0;

    if (std::exchange (playedStop, stop) != stop)
        events[due++] = { 0, FocusEventKind::stopAll, 0, 0 };

    const auto place = [&] (const TriggerQueue::Fired& each)
    {
        const auto isDue = each.due < position + count;

        if (each.askedAt != stop || (! isDue && scheduledCount == scheduled.size()))
            playReports.cancel (each.event);
        else if (isDue)
        {
            events[due] = each.event;
            events[due++].offset = static_cast<int> (std::max<std::int64_t> (0, each.due - position));
        }
        else
            scheduled[scheduledCount++] = each;
    };

    const auto earlier = std::exchange (scheduledCount, 0);

    // One that is kept moves to the front of where it was, never behind what is still to be looked at.
    for (std::size_t i = 0; i < earlier; ++i)
        place (scheduled[i]);

    std::for_each_n (fired.begin(), taken, place);
    return due;
}

/** The events of a block with those that came from elsewhere before them; a note becomes a place of the bank, as loud
   as the gain has it. Only stops are left where notes play nothing. */
std::span<const FocusEvent> AudioEntry::gather (std::span<const FocusEvent> events, int samples, double focusGain)
{
    const std::span all (blockEvents);
    const auto playedNotes = notes();
    const auto stop = std::find_if (events.begin(), events.end(), isStop);
    auto count = takeFired (all, samples);

    // They were asked for before the notes' stop, however late they are due.
    if (stop != events.end())
        count =
            static_cast<std::size_t> (std::remove_if (all.begin(), all.begin() + static_cast<std::ptrdiff_t> (count),
                                                      [&] (const FocusEvent& event)
                                                      {
                                                          const auto isVoid = event.offset > stop->offset;

                                                          if (isVoid)
                                                              playReports.cancel (event);

                                                          return isVoid;
                                                      })
                                      - all.begin());

    for (const auto& event : events.first (std::min (events.size(), EventDelay::mostPerBlock)))
        if (isStop (event))
        {
            playedStop = stopCount.stopByNote(); // Foci that are being designed were fired before it.
            all[count++] = event;
        }
        else if (playedNotes != NoteMeaning::nothing)
            all[count++] = { event.offset, event.kind, bankPlaceOf (event.place, playedNotes),
                             noteAmplitude (event.amplitude, noteLevel) * focusGain };

    const auto gathered = all.first (count);

    // Few, and nearly in order: what came earlier stays before what is for the same sample.
    for (auto next = gathered.begin(); next != gathered.end(); ++next)
        std::rotate (std::upper_bound (gathered.begin(), next, *next,
                                       [] (const auto& a, const auto& b) { return a.offset < b.offset; }),
                     next, next + 1);

    if (std::any_of (gathered.begin(), gathered.end(), isStop))
        playReports.stop (played.levels);

    return gathered;
}

template <typename Sample>
void AudioEntry::process (const AudioBlock<Sample>& block, const PlayControls& controls)
{
    sampleClock.begin (position, block.count, preparedRate, std::chrono::steady_clock::now());
    const auto limitedBefore = played.levels.allLimitedSamples();

    // Who arms again starts nothing that was asked for before.
    if (std::exchange (wasArmed, controls.isArmed) && ! controls.isArmed)
        std::for_each_n (scheduled.begin(), std::exchange (scheduledCount, 0),
                         [this] (const auto& each) { playReports.cancel (each.event); });

    if (auto* const current = paths.current (preparedRate, block.count))
    {
        auto now = controls;
        now.isArmed = controls.isArmed && ! paths.isLeaving();
        fullScale = current->model().fullScaleVoltage;
        current->process (block,
                          waiting.process (gather (block.events, block.count, controls.focusGain), block.count,
                                           current->noteDelay (controls), paths.isLeaving()),
                          now, played);
        auto& voices = current->voices();
        playReports.begin (voices.takeBegun(), position + block.count - voices.time() + current->lateSamples(),
                           limitedBefore, played.levels);

        if (paths.isLeaving())
            playReports.stop (played.levels);
    }
    else
        playSilence (block);

    position += block.count;
    playReports.endBlock (position, played.levels.takeBlockPeak(), played.levels);
}

/** Triggers wait for a path, but not beyond a stop. */
template <typename Sample>
void AudioEntry::playSilence (const AudioBlock<Sample>& block)
{
    if (std::any_of (block.events.begin(), block.events.end(), isStop))
        stopCount.stopByNote();

    playReports.stop (played.levels);
    block.silence();
}

template void AudioEntry::process (const AudioBlock<float>&, const PlayControls&);
template void AudioEntry::process (const AudioBlock<double>&, const PlayControls&);
} // namespace antinode
