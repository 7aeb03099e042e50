#include "MeasureAmplifiers.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_measurement/RunAnalysis.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace antinode
{
AmplifierMeasurement measureAmplifiers (Bench& bench, const Excitation& excitation, double latency,
                                        const std::function<void (Eigen::Index ceramic)>& before)
{
    const auto ceramics = excitation.ceramics(), monitors = std::min (bench.sensors(), ceramics);

    if (monitors != 1 && monitors != ceramics)
        throw InputError ("monitors", "are " + std::to_string (bench.sensors()) + "; allowed: 1 that is moved, or "
                                          + std::to_string (ceramics) + ", one per ceramic");

    RunAnalysisSettings analysis;
    analysis.latency = latency;
    AmplifierMeasurement measurement { measuredFrequencies (excitation), {}, {} };
    measurement.responses.resize (measurement.frequencies.size(), ceramics);

    for (Eigen::Index i = 0; i < ceramics; ++i)
    {
        checkWatch();
        before (i);
        const auto run = bench.play (excitation, i, 0, monitors);
        const auto responses = analyseRun (excitation, i, run, analysis).responses.values;
        measurement.responses.col (i) = responses.col (monitors == 1 ? 0 : i);
        measurement.amplifiers.push_back (fitAmplifier (measurement.frequencies, measurement.responses.col (i)));
    }

    return measurement;
}

SimulatedAmplifiers::SimulatedAmplifiers (std::vector<Amplifier> amplifiersToUse, double noiseToAdd, double delayToHave,
                                          std::uint64_t seedToUse)
    : amplifiers (std::move (amplifiersToUse)), noise (noiseToAdd), delay (delayToHave), seed (seedToUse)
{
}

double SimulatedAmplifiers::fullScaleVelocity() const
{
    return std::numeric_limits<double>::infinity();
}

RunRecording SimulatedAmplifiers::play (const Excitation& excitation, Eigen::Index ceramic, Eigen::Index,
                                        Eigen::Index points)
{
    const auto run = playedRun (excitation, ceramic, 1);
    return playTogether (run.topRows (run.rows() - 1), run.bottomRows (1).transpose(), excitation.settings.sampleRate,
                         points);
}

RunRecording SimulatedAmplifiers::playTogether (const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync,
                                                double sampleRate, Eigen::Index points)
{
    constexpr double silence = 0.1; // s, for what comes late
    const auto length = quickLength (static_cast<double> (voltages.cols()) + silence * sampleRate);
    const auto step = sampleRate / static_cast<double> (length);
    FourierTables tables;
    RandomNumbers random (seed++);
    const auto late = [&] (const Eigen::VectorXd& signal, const Amplifier& amplifier) -> Eigen::VectorXd
    {
        auto spectrum = tables.forward (signal, length);

        for (Eigen::Index k = 0; k < spectrum.size(); ++k)
        {
            const auto frequency = step * static_cast<double> (k);
            spectrum[k] *=
                responseOf (amplifier, frequency) * std::polar (1.0, -2 * std::numbers::pi * frequency * delay);
        }

        return tables.inverse (spectrum, length).head (signal.size());
    };
    RunRecording recording;
    recording.sync = late (sync, {});
    recording.sensors.resize (points, voltages.cols());

    for (Eigen::Index i = 0; i < points; ++i)
        recording.sensors.row (i) = (late (voltages.row (i).transpose(), amplifiers[static_cast<std::size_t> (i)])
                                     + noise * voltages.cwiseAbs().maxCoeff() * random.normal (voltages.cols()))
                                        .transpose();

    return recording;
}
} // namespace antinode
