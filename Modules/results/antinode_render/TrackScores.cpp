#include "TrackScores.h"

#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double leastRatio = 1e-10; // -200 dB

double decibels (double ratio)
{
    return 20 * std::log10 (std::max (ratio, leastRatio));
}

/** The root of the mean square of what a signal has between two frequencies. */
double rmsWithin (const Eigen::VectorXd& signal, double sampleRate, TrackBand band)
{
    const auto length = quickLength (2 * static_cast<double> (signal.size()));
    const auto spectrum = forwardFourier (signal, length);
    double energy = 0;

    for (Eigen::Index k = 1; k < spectrum.size(); ++k)
        if (const auto frequency = static_cast<double> (k) * sampleRate / static_cast<double> (length);
            frequency >= band.lower && frequency <= band.upper)
            energy += 2 * std::norm (spectrum[k]);

    return std::sqrt (energy / static_cast<double> (length) / static_cast<double> (signal.size()));
}
} // namespace

double TrackScores::suppression (std::size_t finger) const
{
    return decibels (fingers[finger].errorRms / strongestRms);
}

double TrackScores::wideSuppression (std::size_t finger) const
{
    return decibels (fingers[finger].wideErrorRms / strongestRms);
}

double TrackScores::normalisedError (std::size_t finger) const
{
    return std::pow (fingers[finger].errorRms / fingers[finger].wantedRms, 2);
}

TrackScores scoreTracks (const PlayedTracks& played, const Eigen::MatrixXd& wanted, TrackBand band)
{
    TrackScores scores;

    for (Eigen::Index p = 0; p < wanted.cols(); ++p)
    {
        const Eigen::VectorXd reached = played.displacements.row (p).transpose();
        Eigen::VectorXd asked = Eigen::VectorXd::Zero (reached.size());
        const auto begin = std::min<Eigen::Index> (played.trigger, asked.size());
        const auto count = std::min (wanted.rows(), asked.size() - begin);
        asked.segment (begin, count) = wanted.col (p).head (count);
        const Eigen::VectorXd error = reached - asked;
        FingerScore score;
        score.wantedPeak = asked.cwiseAbs().maxCoeff();
        score.reachedPeak = reached.cwiseAbs().maxCoeff();
        score.wantedRms = rmsWithin (asked, played.sampleRate, band);
        score.errorRms = rmsWithin (error, played.sampleRate, band);
        score.wideErrorRms = error.norm() / std::sqrt (static_cast<double> (error.size()));
        scores.strongestRms = std::max (scores.strongestRms, score.wantedRms);
        scores.fingers.push_back (score);
    }

    return scores;
}
} // namespace antinode
