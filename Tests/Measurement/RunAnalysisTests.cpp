#include "MeasuredBeam.h"

#include <antinode_engine/PlateModel.h>
#include <antinode_measurement/RunAnalysis.h>
#include <antinode_numerics/Statistics.h>

#include <Support/ErrorText.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr double perfectCoherence = 300; // dB

SimulatedBenchSettings benchWith (double signalToNoise, double cubic = 0)
{
    SimulatedBenchSettings bench;
    bench.signalToNoise = signalToNoise;
    bench.cubic = cubic;
    return bench;
}

Eigen::VectorXcd rightValues (const Excitation& excitation, const ModalModel& model, Eigen::Index ceramic)
{
    return closedForm (model, shapesAt (model, listeningPlace, 0), ceramic, measuredFrequencies (excitation));
}

double responseError (const Excitation& excitation, const SimulatedBenchSettings& bench)
{
    const auto model = benchBeam();
    const auto measured = analyseRun (excitation, 1, recordRun (excitation, model, 1, bench)).responses;
    return errorInDecibels (measured.values.col (0), rightValues (excitation, model, 1));
}
} // namespace

TEST_CASE ("Every excitation gives the response of a resonator as the plate model steps it through time, with its sign")
{
    const auto signal = GENERATE (ExcitationSignal::multisine, ExcitationSignal::sweep, ExcitationSignal::noise);
    auto settings = shortSettings (signal, 1);
    settings.highestFrequency = 2000; // Where the plate model's interpolation is flat.
    settings.resolution = 0.5;
    const auto excitation = testExcitation (settings);
    const auto model = sineBeam (1, 1);

    // Not the simulated bench: it could share a wrong sign with the estimators.
    PlateModel plate (model, { Reconstruction::bandLimited, settings.sampleRate }, shapesAt (model, listeningPlace, 0));
    const Eigen::MatrixXd voltage = playedRun (excitation, 0, 1).topRows (1);
    RunRecording recording;
    recording.sensors.resize (1, voltage.cols());
    plate.process (voltage, recording.sensors);
    RunAnalysisSettings analysis;
    analysis.latency = plate.latencySamples();

    const auto measured = analyseRun (excitation, 0, recording, analysis).responses;
    const auto right = rightValues (excitation, model, 0);
    CHECK (errorInDecibels (measured.values.col (0), right) < (signal == ExcitationSignal::noise ? -18 : -65));
    CHECK (errorInDecibels (measured.values.col (0).conjugate(), right) > 0);
}

TEST_CASE ("Without noise a periodic multisine is exact, a sweep nearly so, and noise leaks")
{
    const auto errorBy = [] (ExcitationSignal signal)
    {
        auto settings = shortSettings (signal, 2);
        settings.settlingPeriods = 4; // Of the first mode 1e-10 is left.
        return responseError (testExcitation (settings), benchWith (perfectCoherence));
    };
    CHECK (errorBy (ExcitationSignal::multisine) < -150);
    CHECK (errorBy (ExcitationSignal::sweep) < -75);
    CHECK (errorBy (ExcitationSignal::noise) < -25);
    CHECK (errorBy (ExcitationSignal::noise) > -60);
}

TEST_CASE ("In eight seconds at 40 dB a multisine and a sweep err by less than -57 dB, and a multisine at 60 dB by "
           "less than -77")
{
    const auto errorBy = [] (ExcitationSignal signal, double signalToNoise)
    {
        auto settings = shortSettings (signal, 2);
        settings.sampleRate = 96000;
        settings.periods = signal == ExcitationSignal::sweep ? 2 : 7;
        settings.sweepDuration = 3;
        return responseError (testExcitation (settings), benchWith (signalToNoise));
    };
    CHECK (errorBy (ExcitationSignal::multisine, 40) < -57);
    CHECK (errorBy (ExcitationSignal::multisine, 60) < -77);
    CHECK (errorBy (ExcitationSignal::sweep, 40) < -57);
    CHECK (errorBy (ExcitationSignal::noise, 40) < -28);
}

TEST_CASE ("The stated variances of multisine and sweep are those of the errors")
{
    const auto signal = GENERATE (ExcitationSignal::multisine, ExcitationSignal::sweep);
    auto settings = shortSettings (signal, 2);
    settings.periods = 4;
    const auto excitation = testExcitation (settings);
    const auto model = benchBeam();
    const auto measured = analyseRun (excitation, 0, recordRun (excitation, model, 0, benchWith (30))).responses;
    const Eigen::ArrayXd errors = (measured.values.col (0) - rightValues (excitation, model, 0)).cwiseAbs2();
    const auto ratio = std::sqrt ((errors / measured.variances.col (0).array()).mean());
    CHECK (ratio > 0.9);
    CHECK (ratio < 1.15);
}

TEST_CASE ("Coherence is 1 without noise and falls where noise covers the response")
{
    const auto signal = GENERATE (ExcitationSignal::multisine, ExcitationSignal::sweep);
    const auto excitation = testExcitation (shortSettings (signal, 2));
    const auto coherenceAt = [&] (double signalToNoise)
    {
        return analyseRun (excitation, 0, recordRun (excitation, benchBeam(), 0, benchWith (signalToNoise)))
            .responses.coherence;
    };
    CHECK (coherenceAt (perfectCoherence).minCoeff() > 0.9999);
    CHECK (coherenceAt (0).minCoeff() < 0.2);
    CHECK (coherenceAt (0).maxCoeff() > 0.9);
}

TEST_CASE ("A cubic nonlinearity shows as odd distortion on an odd grid and not as even")
{
    auto settings = shortSettings (ExcitationSignal::multisine, 2);
    settings.hasOddGrid = true;
    const auto excitation = testExcitation (settings);
    const auto computeDistortion = [&] (double cubic)
    {
        return analyseRun (excitation, 0, recordRun (excitation, benchBeam(), 0, benchWith (80, cubic)))
            .responses.distortion.at (0);
    };
    CHECK (computeDistortion (0).odd < 1e-4);
    CHECK (computeDistortion (0.01).odd > 1e-3);
    CHECK (computeDistortion (0.01).odd < 1e-2);
    CHECK (computeDistortion (0.01).even < 1e-4);
}

TEST_CASE ("A sweep tells the harmonics of a cubic nonlinearity from the linear response")
{
    // Without a surface in the way: cos^3 = 3/4 cos + 1/4 cos 3.
    const auto excitation = testExcitation (shortSettings (ExcitationSignal::sweep, 1));
    constexpr double cubic = 0.04;
    const Eigen::ArrayXd voltage = excitation.signal.array();
    RunRecording recording;
    recording.sensors = Eigen::MatrixXd::Zero (1, excitation.runLength);
    recording.sensors.leftCols (voltage.size()) = (voltage * (1 + cubic * voltage.square())).matrix().transpose();
    const auto measured = analyseRun (excitation, 0, recording).responses;
    const auto& harmonics = measured.distortion.at (0).harmonics;
    REQUIRE (harmonics.size() == 4);
    CHECK (harmonics[1] == Approx (cubic / 4 / (1 + 0.75 * cubic)).epsilon (0.15));
    CHECK (harmonics[0] < 0.1 * harmonics[1]);
    CHECK (harmonics[2] < 0.1 * harmonics[1]);
    const Eigen::ArrayXd gains = measured.values.col (0).cwiseAbs() * excitation.settings.levels[0];
    CHECK (gains.mean() == Approx (1 + 0.75 * cubic).epsilon (0.003));
}

TEST_CASE ("Noise at the input biases H1 downwards and H2 not at all, noise at the output the other way round")
{
    auto settings = shortSettings (ExcitationSignal::noise, 1);
    settings.resolution = 20;
    settings.periods = 200;
    const auto excitation = testExcitation (settings);
    const Eigen::VectorXd signal = excitation.signal;
    const auto deviation = signal.norm() / std::sqrt (static_cast<double> (signal.size()));
    const auto share =
        std::sqrt (0.5); // A power of one half within the whole band, of a quarter of it within the excited half.
    const Eigen::VectorXd noise = share * deviation * RandomNumbers (9).normal (signal.size());
    const auto meanGain = [&] (ResponseEstimator estimator, bool atInput)
    {
        RunRecording recording;
        recording.reference = atInput ? Eigen::VectorXd (signal + noise) : signal;
        recording.sensors = (atInput ? signal : Eigen::VectorXd (signal + noise)).transpose();
        RunAnalysisSettings analysis;
        analysis.estimator = estimator;
        return analyseRun (excitation, 0, recording, analysis).responses.values.col (0).cwiseAbs().mean();
    };
    const auto noiseToSignal = 0.5 * (settings.highestFrequency - settings.lowestFrequency) / (settings.sampleRate / 2);
    CHECK (meanGain (ResponseEstimator::h1, false) == Approx (1).epsilon (0.01));
    CHECK (meanGain (ResponseEstimator::h2, false) == Approx (1 + noiseToSignal).epsilon (0.03));
    CHECK (meanGain (ResponseEstimator::h1, true) == Approx (1 / (1 + noiseToSignal)).epsilon (0.03));
    CHECK (meanGain (ResponseEstimator::h2, true) == Approx (1).epsilon (0.01));
    CHECK (meanGain (ResponseEstimator::hv, false) == Approx (std::sqrt (1 + noiseToSignal)).epsilon (0.03));
}

TEST_CASE ("A measured reference takes gain and delay of an amplifier out of the responses")
{
    const auto excitation = testExcitation (shortSettings (ExcitationSignal::multisine, 2));
    const auto model = benchBeam();
    auto recording = recordRun (excitation, model, 0, benchWith (perfectCoherence));
    // The loop has the same delay; the amplifier has less gain than thought.
    recording.reference = recording.sync * (20 / syncLevel) * 0.8;
    const auto measured = analyseRun (excitation, 0, recording).responses;
    CHECK (errorInDecibels (measured.values.col (0) * 0.8, rightValues (excitation, model, 0)) < -95);
}

TEST_CASE ("Recordings that cannot be analysed say why")
{
    const auto excitation = testExcitation (shortSettings (ExcitationSignal::multisine, 2));
    RunRecording recording;
    recording.sensors = Eigen::MatrixXd::Zero (1, 50);
    CHECK_THAT (errorText ([&] { analyseRun (excitation, 0, recording); }),
                Catch::Contains ("has 50 samples in a run; allowed: at least "));
    recording.sensors = Eigen::MatrixXd::Zero (1, excitation.runLength);
    recording.sensors (0, 7) = std::numeric_limits<double>::infinity();
    CHECK_THAT (errorText ([&] { analyseRun (excitation, 0, recording); }), Catch::Contains ("not finite"));
}
