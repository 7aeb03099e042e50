#include "HammerHits.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace antinode
{
namespace
{
constexpr double leadTime = 10e-3;                  // s before the trigger: longer than the rise of the softest tip
constexpr double reboundTime = 0.25;                // s: what follows so soon belongs to the same hit
constexpr double longestBlock = 4;                  // s, where nothing else says
constexpr double longestGivenBlock = 600;           // s
constexpr double lowestRate = 1, highestRate = 1e7; // Hz: from buildings on
constexpr Eigen::Index fewestLeading = 8;           // samples before the trigger, at low rates longer than leadTime
constexpr double slowBlock = 4096;                  // samples: at low rates longer than longestBlock
constexpr double risen = 0.02;                      // of the peak: where a hit has begun
constexpr double secondRise = 0.1;                  // of the peak: the same share as the trigger's usual one
constexpr double aboveNoise = 10;                   // of the largest force over the noise's standard deviation
constexpr double fullScaleShare = 0.999;
constexpr double restLeft = 1e-3;            // of the motion at the end of a block
constexpr double mostRestLeft = 5e-3;        // of the motion of a hit at which its recording ends
constexpr double deviationOfMedian = 1.4826; // of normal noise: standard deviation over median magnitude

/** The force without offset, its hits upwards. */
Eigen::VectorXd uprightForce (const HammerRecording& recording)
{
    Eigen::VectorXd force = recording.force.array() - median ({ recording.force.begin(), recording.force.end() });
    Eigen::Index largest = 0;
    force.cwiseAbs().maxCoeff (&largest);
    return force[largest] < 0 ? Eigen::VectorXd (-force) : force;
}

double noiseOf (const Eigen::VectorXd& force)
{
    const Eigen::VectorXd magnitudes = force.cwiseAbs();
    return deviationOfMedian * median ({ magnitudes.begin(), magnitudes.end() });
}

std::vector<HammerHit> triggeredHits (const HammerRecording& recording, const HammerSettings& settings)
{
    const auto force = uprightForce (recording);
    const auto largest = force.maxCoeff(), noise = noiseOf (force);

    if (! (largest > aboveNoise * noise))
        throw InputError (recording.source,
                          formatted ("has no hit: its largest force is %.3g N with noise of %.3g N; is "
                                     "the force on another channel?",
                                     largest, noise));

    const auto apart =
        static_cast<Eigen::Index> (std::min (reboundTime, settings.block.value_or (1)) * recording.sampleRate);
    std::vector<HammerHit> hits;

    for (Eigen::Index n = 0; n < force.size(); ++n)
        if (force[n] > settings.trigger * largest && (hits.empty() || n - hits.back().trigger >= apart))
            hits.push_back ({ n, 0, {} });

    return hits;
}

/** Samples from hit to hit, or to the end of a recording of one hit, at most the longest block's. */
Eigen::Index chosenBlock (const std::vector<HammerRecording>& recordings, const HammerTest& test,
                          const HammerSettings& settings)
{
    const auto rate = recordings.front().sampleRate;

    if (settings.block)
        return quickLength (*settings.block * rate);

    auto shortest = static_cast<Eigen::Index> (std::max (longestBlock * rate, slowBlock));

    for (std::size_t i = 0; i < recordings.size(); ++i)
    {
        const auto& hits = test.hits[i];

        for (std::size_t h = 1; h < hits.size(); ++h)
            shortest = std::min (shortest, hits[h].trigger - hits[h - 1].trigger - test.lead);

        if (hits.size() == 1)
            shortest = std::min (shortest, recordings[i].force.size() - hits[0].trigger + test.lead);
    }

    // The largest quick length that is no longer: such lengths are close to each other.
    auto length = shortest;

    while (length > 0 && quickLength (static_cast<double> (length)) > shortest)
        --length;

    return quickLength (static_cast<double> (std::max<Eigen::Index> (1, length)));
}

/** Where a channel is overloaded, from its own samples. */
class OverloadedSamples
{
public:
    OverloadedSamples (const Eigen::VectorXd& channel, double fullScale) : samples (channel), end (fullScale)
    {
        const Eigen::VectorXd steps =
            (samples.tail (samples.size() - 1) - samples.head (samples.size() - 1)).cwiseAbs();
        const auto none = std::numeric_limits<double>::infinity();
        quantum = (steps.array() > 0).select (steps, none).minCoeff();
        largest = samples.cwiseAbs().maxCoeff();
    }

    bool isIn (Eigen::Index first, Eigen::Index count) const
    {
        const auto part = samples.segment (first, count);

        if (end > 0 && part.cwiseAbs().maxCoeff() >= fullScaleShare * end)
            return true;

        for (Eigen::Index n = first, run = 1; n + 1 < first + count; ++n)
        {
            run = samples[n + 1] == samples[n] ? run + 1 : 1;

            if (run == shortestRun && isPlateau (n + 2 - run))
                return true;
        }

        return false;
    }

private:
    static constexpr Eigen::Index shortestRun = 3, quantumSteps = 3;

    /** Whether the run that begins here is at the extreme and ends in steps that are larger than the resolution. */
    bool isPlateau (Eigen::Index begin) const
    {
        auto after = begin;

        while (after < samples.size() && samples[after] == samples[begin])
            ++after;

        const auto isStep = [this, begin] (Eigen::Index n)
        {
            return n < 0 || n >= samples.size()
                   || std::abs (samples[n] - samples[begin]) > static_cast<double> (quantumSteps) * quantum;
        };
        return largest > 0 && std::abs (samples[begin]) == largest && isStep (begin - 1) && isStep (after);
    }

    const Eigen::VectorXd& samples;
    double end, quantum = 0, largest = 0;
};

/** How far the force rises again after it has fallen, and when; from the peak in both directions. */
struct SecondRise
{
    double height = 0;      ///< N
    Eigen::Index after = 0; ///< Samples from the peak, negative before it.
};

SecondRise findSecondRise (const Eigen::VectorXd& force, Eigen::Index peak, Eigen::Index first, Eigen::Index end)
{
    SecondRise second;

    for (const auto step : { Eigen::Index { 1 }, Eigen::Index { -1 } })
    {
        auto lowest = force[peak];

        for (auto n = peak; n >= first && n < end; n += step)
        {
            // Below 0 the tip has left the surface; what swings there is the filter's.
            lowest = std::max (0.0, std::min (lowest, force[n]));

            if (force[n] - lowest > second.height)
                second = { force[n] - lowest, n - peak };
        }
    }

    return second;
}

std::string doubleHitFault (const Eigen::VectorXd& force, double noise, double sampleRate, Eigen::Index first,
                            Eigen::Index count, HammerHit& hit)
{
    Eigen::Index peak = 0;
    hit.peak = force.segment (first, count).maxCoeff (&peak);
    const auto second = findSecondRise (force, first + peak, first, first + count);

    if (second.height <= std::max (secondRise * hit.peak, aboveNoise * noise))
        return {};

    return formatted ("double hit: %.0f %% of the force again %.1f ms %s the peak", 100 * second.height / hit.peak,
                      1000 * std::abs (static_cast<double> (second.after)) / sampleRate,
                      second.after > 0 ? "after" : "before");
}

/** Samples of a block that a recording has. */
struct RecordedPart
{
    Eigen::Index first = 0, count = 0;
};

RecordedPart recordedPart (const HammerTest& test, const HammerHit& hit, Eigen::Index samples)
{
    const auto begin = hit.trigger - test.lead, first = std::max<Eigen::Index> (0, begin);
    return { first, std::min (begin + test.block, samples) - first };
}

/** Whether a recording goes on to the end of a hit's block. Before its beginning everything is at rest. */
bool isComplete (const HammerTest& test, const HammerHit& hit, Eigen::Index samples)
{
    return hit.trigger - test.lead + test.block <= samples;
}

constexpr std::string_view endsEarly = "incomplete: the recording ends before its motion has decayed";

void refuseFaults (const HammerRecording& recording, const HammerTest& test, std::vector<HammerHit>& hits)
{
    const auto force = uprightForce (recording);
    const auto noise = noiseOf (force);
    std::vector<Eigen::VectorXd> channels { recording.force };

    for (const auto& response : recording.responses.rowwise())
        channels.emplace_back (response.transpose());

    for (auto& hit : hits)
    {
        const auto [first, count] = recordedPart (test, hit, force.size());
        hit.fault = doubleHitFault (force, noise, recording.sampleRate, first, count, hit);

        if (hit.trigger < test.lead && force[0] > std::max (risen * hit.peak, aboveNoise * noise))
            hit.fault = "incomplete: the recording begins within the hit";

        for (std::size_t c = 0; c < channels.size() && hit.fault.empty(); ++c)
            if (OverloadedSamples (channels[c], recording.fullScales[static_cast<Eigen::Index> (c)])
                    .isIn (first, count))
                hit.fault = c == 0 ? "overload of the force" : "overload of response " + std::to_string (c);

        if (hit.fault.empty() && ! isComplete (test, hit, force.size()))
            hit.fault = endsEarly;
    }
}

/** Effective values of a hit's motion over that of the tenth of its block with most of it: the largest of all sensors.
 */
struct MotionShares
{
    double before = 0; ///< Until shortly before the hit.
    double atEnd = 0;  ///< In the last tenth.
};

MotionShares motionShares (const HammerRecording& recording, const HammerTest& test, const HammerHit& hit)
{
    constexpr Eigen::Index parts = 10;
    const auto part = recordedPart (test, hit, recording.force.size());
    const auto begin = part.first - (hit.trigger - test.lead); // Within the block.
    const auto length = std::max<Eigen::Index> (1, part.count / parts);
    MotionShares shares;

    for (const auto& response : recording.responses.rowwise())
    {
        const auto block = hitBlock (response.transpose(), test, hit);
        const auto power = [&] (Eigen::Index first, Eigen::Index count)
        { return block.segment (first, count).square().mean(); };
        double most = 0, last = 0;

        for (auto first = begin; first + length <= begin + part.count; first += length)
            most = std::max (most, last = power (first, length));

        if (most > 0)
        {
            shares.before = std::max (shares.before, std::sqrt (power (0, test.quiet()) / most));
            shares.atEnd = std::max (shares.atEnd, std::sqrt (last / most));
        }
    }

    return shares;
}

/** The largest shares of all hits without a fault, or with this one. */
MotionShares largestShares (const std::vector<HammerRecording>& recordings, const HammerTest& test,
                            std::string_view fault)
{
    MotionShares largest;

    for (std::size_t i = 0; i < recordings.size(); ++i)
        for (const auto& hit : test.hits[i])
            if (hit.fault == fault)
            {
                const auto shares = motionShares (recordings[i], test, hit);
                largest = { std::max (largest.before, shares.before), std::max (largest.atEnd, shares.atEnd) };
            }

    return largest;
}

double chosenDecay (double atEnd, double seconds)
{
    return atEnd > restLeft ? std::log (atEnd / restLeft) / seconds : 0;
}

/** Takes the hits back whose recording ends early, but when so little of their motion is left under the window as at
   the end of the others, or next to nothing. At least half of the block is needed. */
void takeDecayedHits (const std::vector<HammerRecording>& recordings, HammerTest& test, double mostLeft)
{
    for (std::size_t i = 0; i < recordings.size(); ++i)
        for (auto& hit : test.hits[i])
        {
            const auto count = hit.fault == endsEarly ? recordedPart (test, hit, recordings[i].force.size()).count : 0;
            const auto seconds = static_cast<double> (count) / recordings[i].sampleRate;

            if (2 * count >= test.block
                && motionShares (recordings[i], test, hit).atEnd * std::exp (-test.windowDecay * seconds) <= mostLeft)
                hit.fault.clear();
        }
}

/** The exponential window, and which hits of recordings that end early are used with it. */
void chooseWindow (const std::vector<HammerRecording>& recordings, const HammerSettings& settings, HammerTest& test)
{
    const auto seconds = static_cast<double> (test.block) / recordings.front().sampleRate;
    const auto areComplete = test.usedHits() > 0;
    const auto shares = largestShares (recordings, test, areComplete ? std::string_view {} : endsEarly);
    test.motionBefore = shares.before;
    test.windowDecay = settings.windowDecay.value_or (chosenDecay (shares.atEnd, seconds));
    takeDecayedHits (
        recordings, test,
        std::max (mostRestLeft, areComplete ? 2 * shares.atEnd * std::exp (-test.windowDecay * seconds) : 0));
}

void requireUsable (const std::vector<HammerRecording>& recordings, const HammerSettings& settings)
{
    if (recordings.empty())
        throw InputError ("hammer", "has no recording");

    for (const auto& recording : recordings)
    {
        if (recording.sampleRate != recordings.front().sampleRate)
            throw InputError (recording.source, "has another sample rate than '" + recordings.front().source
                                                    + "'; allowed: recordings at one rate");

        if (recording.force.size() < 2 || recording.responses.cols() != recording.force.size()
            || recording.fullScales.size() != recording.responses.rows() + 1 || ! recording.force.allFinite()
            || ! recording.responses.allFinite())
            throw InputError (recording.source, "has channels of different lengths, or samples that are not finite");
    }

    if (const auto rate = recordings.front().sampleRate; ! (rate >= lowestRate && rate <= highestRate))
        throw InputError (recordings.front().source, formatted ("has a sample rate of %g Hz; allowed: %g to %g Hz",
                                                                rate, lowestRate, highestRate));

    if (settings.block && ! (*settings.block > 0 && *settings.block <= longestGivenBlock))
        throw InputError ("duration of a hit",
                          formatted ("is %g s; allowed: above 0 to %g s", *settings.block, longestGivenBlock));

    if (! (settings.trigger > 0 && settings.trigger < 1))
        throw InputError ("trigger",
                          formatted ("is %g of the largest force; allowed: above 0 to below 1", settings.trigger));
}
} // namespace

Eigen::Index HammerTest::usedHits() const
{
    Eigen::Index used = 0;

    for (const auto& each : hits)
        used += std::count_if (each.begin(), each.end(), [] (const auto& hit) { return hit.fault.empty(); });

    return used;
}

HammerTest examineHits (const std::vector<HammerRecording>& recordings, const HammerSettings& settings)
{
    requireUsable (recordings, settings);
    constexpr Eigen::Index fewestSamples = 64;
    constexpr double milli = 1e3;
    const auto rate = recordings.front().sampleRate;
    HammerTest test;
    test.lead = std::max (fewestLeading, static_cast<Eigen::Index> (std::ceil (leadTime * rate)));

    for (const auto& recording : recordings)
        test.hits.push_back (triggeredHits (recording, settings));

    test.block = chosenBlock (recordings, test, settings);

    if (test.block < 2 * test.lead)
        throw InputError ("hammer",
                          formatted ("leaves less than %.0f ms from hit to hit; --block-s gives the duration of a hit",
                                     milli * static_cast<double> (2 * test.lead) / rate));

    if (test.block < fewestSamples)
        throw InputError (recordings.front().source,
                          formatted ("leaves %d samples for a hit; allowed: %d and more", static_cast<int> (test.block),
                                     static_cast<int> (fewestSamples)));

    for (std::size_t i = 0; i < recordings.size(); ++i)
        refuseFaults (recordings[i], test, test.hits[i]);

    chooseWindow (recordings, settings, test);

    if (test.usedHits() == 0)
        throw InputError (recordings.front().source, (recordings.size() > 1 ? "as all other recordings " : "")
                                                         + std::string ("has no usable hit; the first one: ")
                                                         + test.hits.front().front().fault);

    return test;
}

Eigen::ArrayXd hitBlock (const Eigen::VectorXd& channel, const HammerTest& test, const HammerHit& hit)
{
    const auto begin = hit.trigger - test.lead;
    const auto part = recordedPart (test, hit, channel.size());
    const auto quiet = std::max<Eigen::Index> (1, begin < 0 ? std::min (test.quiet(), hit.trigger / 2) : test.quiet());
    Eigen::ArrayXd block = Eigen::ArrayXd::Zero (test.block);
    block.segment (part.first - begin, part.count) =
        channel.segment (part.first, part.count).array() - channel.segment (part.first, quiet).mean();
    return block;
}
} // namespace antinode
