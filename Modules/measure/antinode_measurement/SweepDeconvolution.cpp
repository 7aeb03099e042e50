#include "SweepDeconvolution.h"

#include <antinode_base/InputError.h>
#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

namespace antinode
{
namespace
{
constexpr int highestHarmonic = 5;

double cosineStep (double place)
{
    return 0.5 - 0.5 * std::cos (std::numbers::pi * std::clamp (place, 0.0, 1.0));
}

/** 1 within the band, 0 beyond the sweep, and a fade between them. */
double bandGain (const RepeatedSweep& played, double frequency)
{
    const auto start = played.sweep.startFrequency, end = played.sweep.endFrequency;
    return cosineStep ((frequency - start) / (played.lowest - start))
           * cosineStep ((end - frequency) / (end - played.highest));
}

Eigen::VectorXd meanBlock (const Eigen::VectorXd& signal, Eigen::Index block)
{
    return Eigen::Map<const Eigen::MatrixXd> (signal.data(), block, signal.size() / block).rowwise().mean();
}

/** 1/X within the band. */
Eigen::VectorXcd invertSpectrum (const RepeatedSweep& played, const Eigen::VectorXd& input, Eigen::Index length)
{
    auto inverse = forwardFourier (meanBlock (input, played.block), length);

    for (Eigen::Index k = 0; k < inverse.size(); ++k)
    {
        const auto gain = bandGain (played, static_cast<double> (k) * played.sampleRate / static_cast<double> (length));

        if (gain > 0 && ! (std::abs (inverse[k]) > 0))
            throw InputError ("recording", "has no input signal on a line to be measured");

        inverse[k] = gain > 0 ? gain / inverse[k] : 0.0;
    }

    return inverse;
}

/** So many samples from a place on, which may lie before the beginning: the signal is a ring. */
Eigen::VectorXd around (const Eigen::VectorXd& ring, Eigen::Index first, Eigen::Index count)
{
    return Eigen::VectorXd::NullaryExpr (count, [&] (Eigen::Index n)
                                         { return ring[(first + n + 2 * ring.size()) % ring.size()]; });
}

/** The impulse response from before its lag 0 on, faded at its begin and end, with lag 0 on sample 0. What stands
   before it is folded to the end: on the lines of this length that changes nothing. */
Eigen::VectorXd cutOut (const Eigen::VectorXd& ring, Eigen::Index lead, Eigen::Index length)
{
    auto part = around (ring, -lead, lead + length);
    const auto fade = std::max<Eigen::Index> (1, lead / 2);

    for (Eigen::Index n = 0; n < fade; ++n)
    {
        const auto gain = cosineStep ((static_cast<double> (n) + 0.5) / static_cast<double> (fade));
        part[n] *= gain;
        part[part.size() - 1 - n] *= gain;
    }

    Eigen::VectorXd folded = part.tail (length);
    folded.tail (lead) += part.head (lead);
    return folded;
}

/** Where harmonic m stands before the linear response, samples. */
Eigen::Index harmonicLead (const RepeatedSweep& played, int harmonic)
{
    return static_cast<Eigen::Index> (
        std::lround (played.sweep.rise * std::log (static_cast<double> (harmonic)) * played.sampleRate));
}

/** What is kept before an impulse response begins, where its band's edges ring, and no harmonic. */
Eigen::Index leadSamples (const RepeatedSweep& played)
{
    return std::min (harmonicLead (played, 2) / 2, played.responseLength / 4);
}

/** Effective values of the harmonics over that of the linear response, each within the room that the closest two of
    them leave. */
std::vector<double> harmonicLevels (const RepeatedSweep& played, const Eigen::VectorXd& ring)
{
    const auto room = harmonicLead (played, highestHarmonic + 1) - harmonicLead (played, highestHarmonic);
    const auto lead = std::min (leadSamples (played), room / 4);
    const auto linear = around (ring, -lead, room).norm();
    std::vector<double> levels;

    for (int m = 2; m <= highestHarmonic && linear > 0; ++m)
        levels.push_back (around (ring, -harmonicLead (played, m) - lead, room).norm() / linear);

    return levels;
}

/** The linear responses of all repetitions (columns) to an input, and the harmonics of their mean. */
struct Deconvolution
{
    Eigen::MatrixXcd responses;
    NonlinearDistortion distortion;
};

Deconvolution deconvolve (const RepeatedSweep& played, const Eigen::VectorXcd& inverse, Eigen::Index length,
                          const Eigen::VectorXd& output)
{
    Deconvolution result;
    result.responses.resize (static_cast<Eigen::Index> (played.lines.size()), output.size() / played.block);
    Eigen::VectorXd mean = Eigen::VectorXd::Zero (length);

    for (Eigen::Index r = 0; r < result.responses.cols(); ++r)
    {
        const Eigen::VectorXd block = output.segment (r * played.block, played.block);
        const auto ring = inverseFourier (forwardFourier (block, length).cwiseProduct (inverse), length);
        result.responses.col (r) =
            forwardFourier (cutOut (ring, leadSamples (played), played.responseLength)) (played.lines);
        mean += ring;
    }

    result.distortion.harmonics = harmonicLevels (played, mean);
    return result;
}

void requireWholeBlocks (const RepeatedSweep& played, const Eigen::VectorXd& input, const Eigen::MatrixXd& outputs)
{
    if (outputs.cols() != input.size() || input.size() < played.block || input.size() % played.block != 0)
        throw InputError ("recording", "has " + std::to_string (outputs.cols())
                                           + " samples; allowed: a whole number of blocks of "
                                           + std::to_string (played.block));
}
} // namespace

EstimatedResponses deconvolveSweep (const RepeatedSweep& played, const Eigen::VectorXd& input,
                                    const Eigen::MatrixXd& outputs)
{
    requireWholeBlocks (played, input, outputs);
    // Harmonics, which stand before the linear response, must not fold onto its end.
    const auto length = quickLength (static_cast<double> (2 * played.block));
    const auto inverse = invertSpectrum (played, input, length);
    const auto lines = static_cast<Eigen::Index> (played.lines.size()), repetitions = input.size() / played.block;
    EstimatedResponses result;
    result.values.resize (lines, outputs.rows());
    Eigen::MatrixXd variances (lines, outputs.rows());

    for (Eigen::Index sensor = 0; sensor < outputs.rows(); ++sensor)
    {
        auto [responses, distortion] = deconvolve (played, inverse, length, outputs.row (sensor));
        result.distortion.push_back (std::move (distortion));
        result.values.col (sensor) = responses.rowwise().mean();
        responses.colwise() -= result.values.col (sensor);
        variances.col (sensor) = responses.rowwise().squaredNorm()
                                 / static_cast<double> (repetitions * std::max<Eigen::Index> (1, repetitions - 1));
    }

    if (repetitions > 1)
    {
        result.variances = averagedOverNeighbours (variances);
        const Eigen::ArrayXXd power = result.values.cwiseAbs2();
        result.coherence = power / (power + static_cast<double> (repetitions) * result.variances.array()).max (1e-300);
    }

    return result;
}
} // namespace antinode
