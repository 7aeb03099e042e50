#include "ExpectedSignals.h"

#include "SimulatedBench.h"

#include <antinode_numerics/Fourier.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
/** The largest slope of the band-limited waveform through samples, 1/s for a signal without a unit. */
double largestSlope (const Eigen::VectorXd& signal, double sampleRate)
{
    const auto length = quickLength (static_cast<double> (signal.size()));
    auto spectrum = forwardFourier (signal, length);

    for (Eigen::Index k = 0; k < spectrum.size(); ++k)
        spectrum[k] *= std::complex<double> (0, 2 * std::numbers::pi * static_cast<double> (k) * sampleRate
                                                    / static_cast<double> (length));

    return peakBetweenSamples (inverseFourier (spectrum, length));
}
} // namespace

std::vector<ExpectedSignal> expectedSignals (const ModalModel& model, const Eigen::RowVectorXd& shapes,
                                             const Excitation& excitation)
{
    SimulatedBenchSettings bench;
    bench.sampleRate = excitation.settings.sampleRate;
    bench.signalToNoise = 300; // No noise that could be seen in these numbers.
    bench.delay = 0;
    std::vector<ExpectedSignal> expected;

    for (Eigen::Index ceramic = 0; ceramic < excitation.ceramics(); ++ceramic)
    {
        const Eigen::MatrixXd played = playedRun (excitation, ceramic, 1);
        const Eigen::VectorXd velocity = simulateBench (model, shapes, played.topRows (excitation.ceramics()),
                                                        played.bottomRows (1).transpose(), bench)
                                             .sensors.row (0)
                                             .transpose();
        const auto sounding = velocity.head (excitation.signal.size());
        expected.push_back (
            { velocity.cwiseAbs().maxCoeff(), sounding.norm() / std::sqrt (static_cast<double> (sounding.size())) });
    }

    return expected;
}

double expectedResponse (const ModalModel& model, const Eigen::RowVectorXd& shapes, Eigen::Index ceramic,
                         double frequency)
{
    const std::complex<double> s (0, 2 * std::numbers::pi * frequency);
    std::complex<double> sum = 0;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const auto omega = model.angularFrequencies[k];
        sum += shapes[k] * model.participation (k, ceramic) * s
               / (s * s + 2 * model.dampingRatios[k] * omega * s + omega * omega);
    }

    return std::abs (sum);
}

std::vector<ExpectedResonance> strongestResonances (const ModalModel& model, const Eigen::RowVectorXd& shapes,
                                                    double lowestFrequency, double highestFrequency, std::size_t count)
{
    std::vector<ExpectedResonance> resonances;

    for (Eigen::Index k = 0; k < model.modes(); ++k)
        if (const auto frequency = model.frequencyHz (k); frequency >= lowestFrequency && frequency <= highestFrequency)
        {
            ExpectedResonance strongest { frequency, -1, 0 };

            for (Eigen::Index ceramic = 0; ceramic < model.actuators(); ++ceramic)
                if (const auto response = expectedResponse (model, shapes, ceramic, frequency);
                    response > strongest.response)
                    strongest = { frequency, response, ceramic };

            resonances.push_back (strongest);
        }

    std::sort (resonances.begin(), resonances.end(),
               [] (const auto& a, const auto& b) { return a.response > b.response; });
    resonances.resize (std::min (count, resonances.size()));
    return resonances;
}

std::vector<ExcitationLoad> excitationLoads (const ModalModel& model, const Excitation& excitation)
{
    const auto slope = largestSlope (excitation.signal, excitation.settings.sampleRate);
    std::vector<ExcitationLoad> loads;

    for (std::size_t i = 0; i < model.ceramics.size(); ++i)
    {
        const auto& ceramic = model.ceramics[i];
        const auto slew = slope * excitation.settings.levels[static_cast<Eigen::Index> (i)];
        loads.push_back ({ slew, ceramic.capacitance * slew, ceramic.slewLimit / slope });
    }

    return loads;
}
} // namespace antinode
