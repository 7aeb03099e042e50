#include "HammerHits.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/Median.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace antinode
{
namespace
{
constexpr double leadTime = 10e-3;                    // s before the trigger: longer than the rise of the softest tip
constexpr double reboundTime = 0.25;                  // s: what follows so soon belongs to the same hit
constexpr double longestBlock = 4;                    // s, where nothing else says
constexpr double longestGivenBlock = 60;              // s
constexpr double lowestRate = 100, highestRate = 1e7; // Hz
constexpr double secondRise = 0.1;                    // of the peak: the same share as the trigger's usual one
constexpr double aboveNoise = 10;                     // of the largest force over the noise's standard deviation
constexpr double fullScaleShare = 0.999;
constexpr double restLeft = 1e-3;            // of the motion at the end of a block
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

    auto shortest = static_cast<Eigen::Index> (longestBlock * rate);

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

void refuseFaults (const HammerRecording& recording, const HammerTest& test, std::vector<HammerHit>& hits)
{
    const auto force = uprightForce (recording);
    const auto noise = noiseOf (force);
    std::vector<Eigen::VectorXd> channels { recording.force };

    for (const auto& response : recording.responses.rowwise())
        channels.emplace_back (response.transpose());

    for (auto& hit : hits)
    {
        const auto first = hit.trigger - test.lead;

        if (first < 0 || first + test.block > force.size())
        {
            hit.fault = "incomplete: the recording does not have all of its block";
            continue;
        }

        hit.fault = doubleHitFault (force, noise, recording.sampleRate, first, test.block, hit);

        for (std::size_t c = 0; c < channels.size() && hit.fault.empty(); ++c)
            if (OverloadedSamples (channels[c], recording.fullScales[static_cast<Eigen::Index> (c)])
                    .isIn (first, test.block))
                hit.fault = c == 0 ? "overload of the force" : "overload of response " + std::to_string (c);
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
    const auto length = test.block / parts, first = hit.trigger - test.lead;
    MotionShares shares;

    for (const auto& response : recording.responses.rowwise())
    {
        const auto offset = response.segment (first, test.quiet()).mean();
        const auto power = [&] (Eigen::Index begin, Eigen::Index count)
        { return (response.segment (begin, count).array() - offset).square().mean(); };
        double most = 0, last = 0;

        for (Eigen::Index part = 0; part < parts; ++part)
            most = std::max (most, last = power (first + part * length, length));

        if (most > 0)
        {
            shares.before = std::max (shares.before, std::sqrt (power (first, test.quiet()) / most));
            shares.atEnd = std::max (shares.atEnd, std::sqrt (last / most));
        }
    }

    return shares;
}

MotionShares largestShares (const std::vector<HammerRecording>& recordings, const HammerTest& test)
{
    MotionShares largest;

    for (std::size_t i = 0; i < recordings.size(); ++i)
        for (const auto& hit : test.hits[i])
            if (hit.fault.empty())
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
    HammerTest test;
    test.lead =
        std::max<Eigen::Index> (2, static_cast<Eigen::Index> (std::ceil (leadTime * recordings.front().sampleRate)));

    for (const auto& recording : recordings)
        test.hits.push_back (triggeredHits (recording, settings));

    test.block = chosenBlock (recordings, test, settings);

    if (test.block < 2 * test.lead)
        throw InputError ("hammer", "leaves less than 20 ms from hit to hit; --block-s gives the duration of a hit");

    if (test.block < fewestSamples)
        throw InputError (recordings.front().source,
                          formatted ("leaves %d samples for a hit; allowed: %d and more", static_cast<int> (test.block),
                                     static_cast<int> (fewestSamples)));

    for (std::size_t i = 0; i < recordings.size(); ++i)
        refuseFaults (recordings[i], test, test.hits[i]);

    if (test.usedHits() == 0)
        throw InputError (recordings.front().source, (recordings.size() > 1 ? "as all other recordings " : "")
                                                         + std::string ("has no usable hit; the first one: ")
                                                         + test.hits.front().front().fault);

    const auto shares = largestShares (recordings, test);
    test.motionBefore = shares.before;
    test.windowDecay = settings.windowDecay.value_or (
        chosenDecay (shares.atEnd, static_cast<double> (test.block) / recordings.front().sampleRate));
    return test;
}
} // namespace antinode
