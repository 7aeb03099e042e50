#include "PlayReports.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace antinode
{
/** Nobody asks for those without a request. */
void PlayReports::push (const PlayReport& report)
{
    if (report.request != 0 && ! reports.push (report))
        ++lostCount;
}

void PlayReports::begin (std::span<const BegunVoice> voices, std::int64_t offset, std::int64_t limitedBefore,
                         const LevelMeters& meters)
{
    for (const auto& voice : voices)
    {
        if (voice.plays && markCount < marks.size())
            marks[markCount++] = voice.focus + offset;

        const PlayReport report { voice.plays ? PlayReport::Kind::begun : PlayReport::Kind::empty, voice.request,
                                  voice.onset + offset, voice.focus + offset };
        push (report);

        if (! voice.plays)
            continue;

        finishUntil (report.onset, meters);

        // The player fades out its oldest voice for it.
        if (count == playing.size())
            finish (0, PlayReport::Kind::stopped, meters);

        playing[count++] = { report, voice.end + offset, limitedBefore };
    }
}

void PlayReports::finishUntil (std::int64_t end, const LevelMeters& meters)
{
    for (std::size_t i = 0; i < count;)
        if (playing[i].end <= end)
            finish (i, PlayReport::Kind::finished, meters);
        else
            ++i;
}

void PlayReports::finish (std::size_t index, PlayReport::Kind kind, const LevelMeters& meters)
{
    auto& ended = playing[index];
    ended.report.kind = kind;
    ended.report.limitedSamples = meters.allLimitedSamples() - ended.limitedBefore;
    push (ended.report);
    std::move (playing.begin() + static_cast<std::ptrdiff_t> (index) + 1,
               playing.begin() + static_cast<std::ptrdiff_t> (count),
               playing.begin() + static_cast<std::ptrdiff_t> (index));
    --count;
}

void PlayReports::endBlock (std::int64_t end, float peakVolts, const LevelMeters& meters)
{
    for (auto& each : std::span (playing).first (count))
        each.report.peakVolts = std::max (each.report.peakVolts, peakVolts);

    finishUntil (end, meters);
}

void PlayReports::stop (const LevelMeters& meters)
{
    while (count > 0)
        finish (0, PlayReport::Kind::stopped, meters);

    markCount = 0;
}

void PlayReports::writeMarker (float* to, int samples, std::int64_t begin, std::int64_t width)
{
    const auto end = begin + samples;
    std::fill_n (to, samples, 0.0F);

    for (const auto mark : std::span (marks).first (markCount))
        if (mark < end && mark + width > begin)
            std::fill (to + (std::max (mark, begin) - begin), to + (std::min (mark + width, end) - begin), 1.0F);

    const auto last = std::remove_if (marks.begin(), marks.begin() + static_cast<std::ptrdiff_t> (markCount),
                                      [&] (std::int64_t mark) { return mark + width <= end; });
    markCount = static_cast<std::size_t> (last - marks.begin());
}

void SampleClock::begin (std::int64_t first, int count, double sampleRate, Time time)
{
    const auto measured = std::chrono::duration<double> (time.time_since_epoch()).count();
    const auto nominal = 1 / sampleRate;
    // A device's block may come in parts, all of them at once: they say nothing of its time.
    const auto isPart = first == next && measured - std::exchange (lastCall, measured) < lastLength / 4;
    lastLength = count * nominal;
    constexpr double widest = 2, narrowest = 0.1; // Hz of the loop: it narrows as it settles
    constexpr double farOff = 0.25;               // s: the device has paused, the loop begins again

    if (const auto error = measured - now.seconds; first != next || sampleRate != rate || std::abs (error) > farOff)
    {
        now = { first, measured, nominal };
        begun = measured;
    }
    else if (isPart)
        now.sample = first;
    else
    {
        const auto bandwidth = std::clamp (1 / std::max (measured - begun, nominal), narrowest, widest);
        const auto turn = std::min (2 * std::numbers::pi * bandwidth * count * nominal, 0.5);
        now.sample = first;
        now.seconds += std::numbers::sqrt2 * turn * error;
        now.period = std::clamp (now.period + turn * turn * error / count, 0.99 * nominal, 1.01 * nominal);
    }

    version.fetch_add (1, std::memory_order_acq_rel);
    sample.store (now.sample, std::memory_order_relaxed);
    seconds.store (now.seconds, std::memory_order_relaxed);
    period.store (now.period, std::memory_order_relaxed);
    version.fetch_add (1, std::memory_order_release);
    rate = sampleRate;
    next = first + count;
    now.seconds += count * now.period; // That the next block is expected at.
}

std::optional<SampleClock::Line> SampleClock::line() const
{
    for (;;)
    {
        const auto before = version.load (std::memory_order_acquire);
        const Line read { sample.load (std::memory_order_relaxed), seconds.load (std::memory_order_relaxed),
                          period.load (std::memory_order_relaxed) };
        std::atomic_thread_fence (std::memory_order_acquire);

        if (before == 0)
            return {};

        if (before % 2 == 0 && version.load (std::memory_order_relaxed) == before)
            return read;
    }
}

std::optional<SampleClock::Time> SampleClock::timeOf (std::int64_t wanted) const
{
    const auto known = line();

    if (! known)
        return {};

    const std::chrono::duration<double> at (known->seconds
                                            + static_cast<double> (wanted - known->sample) * known->period);
    return Time (std::chrono::duration_cast<Time::duration> (at));
}

std::optional<std::int64_t> SampleClock::sampleAt (Time time) const
{
    const auto known = line();

    if (! known)
        return {};

    const auto at = std::chrono::duration<double> (time.time_since_epoch()).count();
    return known->sample + std::llround ((at - known->seconds) / known->period);
}
} // namespace antinode
