#include "HammerResponses.h"

#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace antinode
{
namespace
{
constexpr double weakestForce = 1e-3; // of the largest power: 30 dB

/** A usable hit of a recording. */
struct UsedHit
{
    const HammerRecording& recording;
    const HammerHit& hit;
};

std::vector<UsedHit> usedHitsOf (const std::vector<HammerRecording>& recordings, const HammerTest& test,
                                 const std::vector<std::size_t>& which)
{
    std::vector<UsedHit> used;

    for (const auto i : which)
        for (const auto& hit : test.hits[i])
            if (hit.fault.empty())
                used.push_back ({ recordings[i], hit });

    return used;
}

Eigen::ArrayXd exponentialWindow (const HammerTest& test, double sampleRate)
{
    return Eigen::ArrayXd::NullaryExpr (
        test.block,
        [&] (Eigen::Index n) { return std::exp (-test.windowDecay * static_cast<double> (n) / sampleRate); });
}

/** 1 while the tip touches, for as long again after it, and at least 2 ms; then faded out over the same time. */
Eigen::ArrayXd forceWindow (const Eigen::ArrayXd& force, const HammerTest& test, double sampleRate)
{
    constexpr double touching = 0.02, shortestTail = 2e-3; // of the peak; s
    Eigen::Index end = 0;
    const auto peak = force.abs().maxCoeff (&end);

    while (end < force.size() && std::abs (force[end]) > touching * peak)
        ++end;

    const auto tail = std::max (end - test.lead, static_cast<Eigen::Index> (shortestTail * sampleRate));
    Eigen::ArrayXd window = Eigen::ArrayXd::Zero (force.size());
    window.head (std::min (force.size(), end + tail)) = 1;

    for (Eigen::Index n = 0; n < tail && end + tail + n < force.size(); ++n)
        window[end + tail + n] =
            0.5 + 0.5 * std::cos (std::numbers::pi * static_cast<double> (n) / static_cast<double> (tail));

    return window;
}

Eigen::VectorXcd forceSpectrum (FourierTables& tables, const UsedHit& used, const HammerTest& test)
{
    const auto rate = used.recording.sampleRate;
    const auto force = hitBlock (used.recording.force, test, used.hit);
    return tables.forward ((force * forceWindow (force, test, rate) * exponentialWindow (test, rate)).matrix());
}
} // namespace

Eigen::VectorXd forceMagnitude (const std::vector<HammerRecording>& recordings, const HammerTest& test)
{
    std::vector<std::size_t> all (recordings.size());
    std::iota (all.begin(), all.end(), 0);
    const auto used = usedHitsOf (recordings, test, all);
    FourierTables tables;
    Eigen::ArrayXd power = Eigen::ArrayXd::Zero (test.block / 2 + 1);

    for (const auto& hit : used)
        power += forceSpectrum (tables, hit, test).array().abs2();

    return (power / static_cast<double> (used.size())).sqrt() / recordings.front().sampleRate;
}

HammerLines drivenLines (const std::vector<HammerRecording>& recordings, const HammerTest& test, double lowest,
                         double highest)
{
    const Eigen::ArrayXd power = forceMagnitude (recordings, test).array().square();
    const auto spacing = recordings.front().sampleRate / static_cast<double> (test.block);
    const auto largest = power.maxCoeff();
    HammerLines lines;
    lines.first = std::max<Eigen::Index> (1, static_cast<Eigen::Index> (std::ceil (lowest / spacing)));
    lines.last = lines.first - 1;

    while (lines.last + 1 < power.size()
           && (highest > 0 ? static_cast<double> (lines.last + 1) * spacing <= highest
                           : power[lines.last + 1] > weakestForce * largest))
        ++lines.last;

    if (lines.last - lines.first < 1)
        throw InputError ("hammer",
                          formatted ("drives less than two lines from %g Hz on; choose another band", lowest));

    const auto count = lines.last - lines.first + 1;
    lines.frequencies =
        spacing
        * Eigen::VectorXd::LinSpaced (count, static_cast<double> (lines.first), static_cast<double> (lines.last));
    return lines;
}

EstimatedResponses hammerResponses (const std::vector<HammerRecording>& recordings, const HammerTest& test,
                                    const HammerLines& lines, const std::vector<std::size_t>& which,
                                    ResponseEstimator estimator)
{
    const auto used = usedHitsOf (recordings, test, which);

    if (used.empty())
        throw InputError (recordings[which.front()].source, "has no usable hit");

    const auto hits = std::ssize (used), count = lines.frequencies.size();
    const auto sensors = used.front().recording.responses.rows();
    FourierTables tables;
    Eigen::MatrixXcd input (count, hits);

    for (Eigen::Index h = 0; h < hits; ++h)
        input.col (h) = forceSpectrum (tables, used[static_cast<std::size_t> (h)], test).segment (lines.first, count);

    const AveragedSpectra spectra (std::move (input));

    if (! spectra.drivesAllLines())
        throw InputError (used.front().recording.source, "has no force on a line of the band");

    EstimatedResponses result {
        Eigen::MatrixXcd (count, sensors), Eigen::MatrixXd (count, sensors), Eigen::MatrixXd (count, sensors), {}
    };

    for (Eigen::Index sensor = 0; sensor < sensors; ++sensor)
    {
        Eigen::MatrixXcd output (count, hits);

        for (Eigen::Index h = 0; h < hits; ++h)
        {
            const auto& [recording, hit] = used[static_cast<std::size_t> (h)];
            const auto motion = hitBlock (recording.responses.row (sensor), test, hit);
            output.col (h) = tables.forward ((motion * exponentialWindow (test, recording.sampleRate)).matrix())
                                 .segment (lines.first, count);
        }

        spectra.estimate (output, estimator, static_cast<double> (hits), sensor, result);
    }

    if (hits < 2)
        result.coherence = result.variances = {};

    return result;
}
} // namespace antinode
