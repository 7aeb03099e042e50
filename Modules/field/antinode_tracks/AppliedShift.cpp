#include "AppliedShift.h"

#include "TrackSolver.h"

#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace antinode
{
namespace
{
constexpr auto softness = 1e4; // of the voltages that make up for an error: what they cannot bring is left

/** 1 in the band, 0 below half of it and above twice of it; in between as a raised cosine of the octave. */
double shareInBand (double frequency, TrackBand band)
{
    if (frequency <= band.lower / 2 || frequency >= 2 * band.upper)
        return 0;

    const auto octaves = std::max (std::log2 (band.lower / frequency), std::log2 (frequency / band.upper));
    return octaves > 0 ? 0.5 + 0.5 * std::cos (std::numbers::pi * octaves) : 1;
}

/** Recorded signals at the samples of a design, without what lies beyond a band, where there is one. */
Eigen::MatrixXd atDesignRate (const TrackWork& work, const TrackShift& shift, const Eigen::MatrixXd& signals,
                              std::optional<TrackBand> band)
{
    const auto& span = work.span;
    const Eigen::Index first = std::llround (shift.firstTime * work.sampleRate) + span.lead * span.factor;
    const auto begin = std::max<Eigen::Index> (0, -first);
    const auto count = std::min (signals.rows(), span.length * span.factor - first) - begin;
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero (span.length, signals.cols());

    for (Eigen::Index p = 0; p < signals.cols() && count > 0; ++p)
    {
        Eigen::VectorXd whole = Eigen::VectorXd::Zero (span.length * span.factor);
        whole.segment (first + begin, count) = signals.col (p).segment (begin, count);
        Eigen::VectorXcd lines = forwardFourier (whole).head (span.length / 2 + 1);

        for (Eigen::Index k = 0; band && k < lines.size(); ++k)
            lines[k] *= shareInBand (static_cast<double> (k) * span.rate / static_cast<double> (span.length), *band);

        result.col (p) = inverseFourier (lines, span.length) / static_cast<double> (span.factor);
    }

    return result;
}
} // namespace

void applyShift (TrackWork& work, const TrackShift& shift, TrackBand band)
{
    if (shift.missing.cols() == 0)
        return;

    const auto compliance = work.responses.compliance();
    work.responses.setCompliance (softness * compliance);
    const auto change = solveTracks (work.responses, atDesignRate (work, shift, shift.missing, band)).voltages;
    work.responses.setCompliance (compliance);
    work.wanted = atDesignRate (work, shift, shift.predicted, {}) + work.responses.motion (change);
}
} // namespace antinode
