#include "DriveGrid.h"

#include <antinode_base/Watch.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
/** The instants of the grid: the last one is exact, whatever the others' rounding. */
struct SampleTimes
{
    double last, duration, steps;

    double at (Eigen::Index n) const { return last - duration * (1 - static_cast<double> (n) / steps); }
    double interval() const { return duration / steps; }
};

/** A phasor rotated from sample to sample, and recomputed often enough to limit rounding. */
void addSamples (Eigen::Ref<Eigen::RowVectorXd, 0, Eigen::InnerStride<>> samples, const Oscillation& oscillation,
                 const SampleTimes& times)
{
    constexpr Eigen::Index renewal = 64;
    const auto turn = std::exp (oscillation.exponent() * times.interval());
    std::complex<double> phasor;
    Eigen::Index turned = renewal;

    for (Eigen::Index n = 0; n < samples.size(); ++n)
    {
        const auto time = times.at (n);

        if (time < oscillation.start || time >= oscillation.end)
            continue;

        phasor = turned < renewal
                     ? phasor * turn
                     : oscillation.phasor() * std::exp (oscillation.exponent() * (time - oscillation.start));
        turned = turned < renewal ? turned + 1 : 1;
        samples[n] += phasor.real();
    }
}

/** Memory that is touched for the first time takes long: the watch is looked at between pieces. */
Eigen::MatrixXd makeZeros (Eigen::Index rows, Eigen::Index columns)
{
    constexpr Eigen::Index piece = 2048;
    Eigen::MatrixXd zeros (rows, columns);

    for (Eigen::Index first = 0; first < columns; first += piece)
    {
        checkWatch();
        zeros.middleCols (first, std::min (piece, columns - first)).setZero();
    }

    return zeros;
}

/** The oscillation whose value is the slope of the given one. */
Oscillation differentiated (Oscillation oscillation)
{
    const auto phasor = oscillation.exponent() * oscillation.phasor();
    oscillation.inPhase = -phasor.imag();
    oscillation.quadrature = phasor.real();
    return oscillation;
}
} // namespace

double gridLimitMargin (int samplesPerCycle)
{
    return std::cos (std::numbers::pi / samplesPerCycle);
}

Eigen::MatrixXd sampleSlopes (const std::vector<std::vector<Oscillation>>& drives, double first, double last,
                              int samplesPerCycle)
{
    auto slopes = drives;

    for (auto& drive : slopes)
        for (auto& oscillation : drive)
            oscillation = differentiated (oscillation);

    return sampleDrives (slopes, first, last, samplesPerCycle);
}

Eigen::MatrixXd sampleDrives (const std::vector<std::vector<Oscillation>>& drives, double first, double last,
                              int samplesPerCycle)
{
    double highest = 0;

    for (const auto& drive : drives)
        for (const auto& oscillation : drive)
            highest = std::max (highest, std::abs (oscillation.exponent()) / (2 * std::numbers::pi));

    const auto steps = std::max (2.0, std::ceil ((last - first) * highest * samplesPerCycle));
    auto samples = makeZeros (static_cast<Eigen::Index> (drives.size()), static_cast<Eigen::Index> (steps) + 1);

    const SampleTimes times { last, last - first, steps };

    for (Eigen::Index l = 0; l < samples.rows(); ++l)
        for (const auto& oscillation : drives[static_cast<std::size_t> (l)])
        {
            checkWatch();
            addSamples (samples.row (l), oscillation, times);
        }

    return samples;
}
} // namespace antinode
