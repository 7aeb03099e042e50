#include "SimulatedBench.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_model/ModalRecursion.h>
#include <antinode_numerics/DenseKernels.h>
#include <antinode_numerics/Fourier.h>
#include <antinode_numerics/ParallelFor.h>
#include <antinode_numerics/Statistics.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace antinode
{
namespace
{
constexpr double restShare = 1e-8;  // of the slowest mode's motion, when a response counts as over
constexpr double longestRest = 10;  // s
constexpr double silentLine = 1e-9; // of the strongest line: others are left out
constexpr Eigen::Index linesAtOnce = 2048;

/** How long a transform must be for the response to end before it begins again. */
Eigen::Index transformLength (const ModalModel& model, Eigen::Index samples, const SimulatedBenchSettings& settings)
{
    const auto rest = std::min (longestRest, -std::log (restShare) / decayRates (model).minCoeff());
    return quickLength (static_cast<double> (samples) + (rest + settings.delay) * settings.sampleRate);
}

/** The cubed voltage at twice the rate: what it has above the band would fold back into it. */
Eigen::VectorXcd drivenSpectrum (const Eigen::VectorXd& voltage, Eigen::Index length, double cubic)
{
    auto spectrum = forwardFourier (voltage, length);

    if (cubic == 0)
        return spectrum;

    Eigen::VectorXcd wide = Eigen::VectorXcd::Zero (length + 1);
    wide.head (spectrum.size()) = 2 * spectrum;
    const auto between = inverseFourier (wide, 2 * length);
    const auto largest = between.cwiseAbs().maxCoeff();
    const Eigen::VectorXd driven = between.array() * (1 + cubic * (between.array() / largest).square());
    return forwardFourier (driven).head (spectrum.size()) / 2;
}

/** Sensors' velocities on lines first .. first + count - 1 under modal forces: shapes times i omega psi / (omega_k^2 -
    omega^2 + 2 i xi omega_k omega). */
Eigen::MatrixXcd velocityLines (const ModalModel& model, const Eigen::MatrixXd& shapes, const Eigen::VectorXd& omegas,
                                const Eigen::MatrixXcd& forces)
{
    const Eigen::ArrayXd squares = model.angularFrequencies.array().square();
    const Eigen::ArrayXd dampings = 2 * decayRates (model).array();
    Eigen::MatrixXd real (model.modes(), omegas.size()), imaginary (model.modes(), omegas.size());

    for (Eigen::Index f = 0; f < omegas.size(); ++f)
    {
        // i omega (F + i G) (d - i e) / (d^2 + e^2): products of real numbers, which are many at once.
        const auto omega = omegas[f];
        const Eigen::ArrayXd d = squares - omega * omega, e = dampings * omega;
        const Eigen::ArrayXd share = omega / (d.square() + e.square());
        const Eigen::ArrayXd forceReal = forces.col (f).real().array(), forceImaginary = forces.col (f).imag().array();
        real.col (f) = (share * (forceReal * e - forceImaginary * d)).matrix();
        imaginary.col (f) = (share * (forceReal * d + forceImaginary * e)).matrix();
    }

    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero (shapes.rows(), 2 * omegas.size());
    addProduct (sums.leftCols (omegas.size()), 1, shapes, real);
    addProduct (sums.rightCols (omegas.size()), 1, shapes, imaginary);
    Eigen::MatrixXcd result (shapes.rows(), omegas.size());
    result.real() = sums.leftCols (omegas.size());
    result.imag() = sums.rightCols (omegas.size());
    return result;
}

/** Spectra of all ceramics that play: lines x as many. */
struct Drives
{
    Eigen::MatrixXcd spectra;
    std::vector<Eigen::Index> ceramics;
};

Drives makeDrives (const Eigen::MatrixXd& voltages, Eigen::Index length, double cubic)
{
    Drives drives;

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
        if ((voltages.row (i).array() != 0).any())
            drives.ceramics.push_back (i);

    drives.spectra.resize (length / 2 + 1, static_cast<Eigen::Index> (drives.ceramics.size()));

    for (Eigen::Index column = 0; column < drives.spectra.cols(); ++column)
        drives.spectra.col (column) =
            drivenSpectrum (voltages.row (drives.ceramics[static_cast<std::size_t> (column)]), length, cubic);

    return drives;
}

/** The lines on which something plays. */
std::vector<Eigen::Index> soundingLines (const Eigen::MatrixXcd& spectra)
{
    const Eigen::ArrayXd power = spectra.rowwise().squaredNorm().array();
    const auto minimum = power.maxCoeff() * silentLine * silentLine;
    std::vector<Eigen::Index> lines;

    for (Eigen::Index k = 1; k < power.size(); ++k)
        if (power[k] > minimum)
            lines.push_back (k);

    return lines;
}

/** Spectra of the sensors' velocities: lines x N. */
Eigen::MatrixXcd sensorSpectra (const ModalModel& model, const Eigen::MatrixXd& shapes, const Drives& drives,
                                Eigen::Index length, const SimulatedBenchSettings& settings)
{
    const auto lines = soundingLines (drives.spectra);
    const Eigen::MatrixXd participation = model.participation (Eigen::all, drives.ceramics);
    const auto perLine = 2 * std::numbers::pi * settings.sampleRate / static_cast<double> (length);
    Eigen::MatrixXcd spectra = Eigen::MatrixXcd::Zero (length / 2 + 1, shapes.rows());

    const auto fillPart = [&] (std::size_t part)
    {
        const auto first = part * static_cast<std::size_t> (linesAtOnce);
        const auto last = std::min (lines.size(), first + static_cast<std::size_t> (linesAtOnce));
        const std::vector<Eigen::Index> some (lines.begin() + static_cast<std::ptrdiff_t> (first),
                                              lines.begin() + static_cast<std::ptrdiff_t> (last));
        const Eigen::VectorXd omegas = Eigen::Map<const Eigen::Matrix<Eigen::Index, Eigen::Dynamic, 1>> (
                                           some.data(), static_cast<Eigen::Index> (some.size()))
                                           .cast<double>()
                                       * perLine;
        const Eigen::MatrixXcd forces = participation * drives.spectra (some, Eigen::all).transpose();
        spectra (some, Eigen::all) = velocityLines (model, shapes, omegas, forces).transpose();
    };

    parallelFor ((lines.size() + linesAtOnce - 1) / linesAtOnce, fillPart);
    return spectra;
}

/** What a delay does to each line. */
Eigen::VectorXcd turns (Eigen::Index length, double samples)
{
    const auto turn = 2 * std::numbers::pi * samples / static_cast<double> (length);
    return Eigen::VectorXcd::NullaryExpr (length / 2 + 1, [turn] (Eigen::Index k)
                                          { return std::polar (1.0, -turn * static_cast<double> (k)); });
}

/** Sensors' recordings, their noise in their order, by as many threads as there are, each with its own tables. */
void recordSensors (const Eigen::MatrixXcd& spectra, const Eigen::VectorXcd& delay, Eigen::Index length,
                    const SimulatedBenchSettings& settings, Eigen::MatrixXd& recorded)
{
    const auto noiseShare = std::pow (10.0, -settings.signalToNoise / 20);
    const auto samples = recorded.cols();
    const auto parts = std::min<Eigen::Index> (spectra.cols(), static_cast<Eigen::Index> (processorThreads()));

    parallelFor (static_cast<std::size_t> (parts),
                 [&] (std::size_t part)
                 {
                     FourierTables tables;
                     RandomNumbers random (settings.seed);
                     const auto first = static_cast<Eigen::Index> (part) * spectra.cols() / parts;
                     const auto end = (static_cast<Eigen::Index> (part) + 1) * spectra.cols() / parts;
                     random.skipNormal (samples, first);

                     for (auto sensor = first; sensor < end; ++sensor)
                     {
                         checkWatch();
                         const Eigen::VectorXd clean =
                             tables.inverse (spectra.col (sensor).cwiseProduct (delay), length).head (samples);
                         const auto deviation = noiseShare * clean.norm() / std::sqrt (static_cast<double> (samples));
                         recorded.row (sensor) = (clean + deviation * random.normal (samples)).transpose();
                     }
                 });
}

void requireUsable (const ModalModel& model, const Eigen::MatrixXd& voltages, const Eigen::VectorXd& sync,
                    const SimulatedBenchSettings& settings)
{
    const auto isUsable = [] (double value, double minimum, double maximum)
    { return value >= minimum && value <= maximum; };

    if (model.modes() == 0 || voltages.rows() != model.actuators() || sync.size() != voltages.cols()
        || sync.size() == 0)
        throw InputError ("simulated bench", "needs a device with modes and the voltages of all its ceramics");

    if (! voltages.allFinite() || ! sync.allFinite())
        throw InputError ("simulated bench", "has a voltage that is not finite");

    if (! isUsable (settings.signalToNoise, -20, 300))
        throw InputError ("simulated bench", "signal-to-noise ratio is out of range; allowed: -20 to 300 dB");

    if (! isUsable (settings.delay, 0, 0.2))
        throw InputError ("simulated bench", "delay is out of range; allowed: 0 to 200 ms");

    if (! isUsable (settings.cubic, -0.2, 0.2))
        throw InputError ("simulated bench", "cubic distortion is out of range; allowed: -20 to 20 %");
}
} // namespace

RunRecording simulateBench (const ModalModel& model, const Eigen::MatrixXd& shapes, const Eigen::MatrixXd& voltages,
                            const Eigen::VectorXd& sync, const SimulatedBenchSettings& settings)
{
    requireRealModes (model, "simulated measurements");
    requirePlayable (model, shapes);
    requireUsable (model, voltages, sync, settings);
    const auto samples = voltages.cols();
    const auto length = transformLength (model, samples, settings);
    const auto late = settings.delay * settings.sampleRate;
    const auto spectra = sensorSpectra (model, shapes, makeDrives (voltages, length, settings.cubic), length, settings);
    const auto delay = turns (length, late);
    RunRecording recording;
    recording.sensors.resize (shapes.rows(), samples);
    recording.sync = inverseFourier (forwardFourier (sync, length).cwiseProduct (delay), length).head (samples);
    recordSensors (spectra, delay, length, settings, recording.sensors);
    return recording;
}

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
