#include <antinode_measurement/HammerResponses.h>

#include "SimulatedHits.h"

#include <Support/ErrorText.h>

#include <antinode_identification/Identification.h>
#include <antinode_identification/ImpulseResponses.h>
#include <antinode_responses/HammerMeasurement.h>
#include <antinode_responses/MeasurementReader.h>
#include <antinode_responses/UniversalFile.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

using namespace antinode;

namespace
{
/** Five hits, so far apart that of the motion 3e-4 is left, of which the second bounces and the fourth drives the first
    response to its end. */
const HammerRecording& fiveHits()
{
    static const auto recording = []
    {
        auto made = test::simulateHits ({ { 0.11, 40, 1e-3 },
                                          { 2.21, 35, 1.1e-3 },
                                          { 2.224, 9, 1.2e-3 },
                                          { 4.31, 50, 0.9e-3 },
                                          { 6.41, 160, 1e-3 },
                                          { 8.51, 45, 1e-3 } },
                                        10.7, 3);
        made.fullScales[1] = 0.6 * made.responses.row (0).cwiseAbs().maxCoeff();
        made.responses.row (0) = made.responses.row (0).cwiseMax (-made.fullScales[1]).cwiseMin (made.fullScales[1]);
        return made;
    }();
    return recording;
}

/** Effective error over effective value, dB, to the exact response of the windowed hits. */
double errorOf (const EstimatedResponses& responses, const HammerLines& lines, double decay, Eigen::Index sensor)
{
    Eigen::VectorXcd exact (lines.frequencies.size());

    for (Eigen::Index f = 0; f < exact.size(); ++f)
        exact[f] = test::exactResponse ({ decay, 2 * std::numbers::pi * lines.frequencies[f] },
                                        static_cast<std::size_t> (sensor));

    return 20 * std::log10 ((responses.values.col (sensor) - exact).norm() / exact.norm());
}
} // namespace

TEST_CASE ("a bounce and an overload are refused with their reasons, the other hits give the response", "[hammer]")
{
    const std::vector<HammerRecording> recordings { fiveHits() };
    const auto examined = examineHits (recordings, {});
    REQUIRE (examined.hits[0].size() == 5);
    CHECK (examined.usedHits() == 3);
    CHECK (examined.hits[0][1].fault.find ("double hit: 26 % of the force again 14.") == 0);
    CHECK (examined.hits[0][3].fault == "overload of response 1");

    for (const auto hit : { 0U, 2U, 4U })
        CHECK (examined.hits[0][hit].fault.empty());

    const auto lines = drivenLines (recordings, examined, 50, 1000);
    const auto responses = hammerResponses (recordings, examined, lines, { 0 }, ResponseEstimator::h1);
    // The noise is 60 dB below the peak of the strong fourth hit, 49 dB below those that are used: its energy in the
    // band, 2.1 s of it, over that of the motion is -40 dB with three hits.
    CHECK (errorOf (responses, lines, examined.windowDecay, 0) < -37);
    CHECK (errorOf (responses, lines, examined.windowDecay, 1) < -37);
    CHECK (responses.coherence.col (0).maxCoeff() <= 1);
    CHECK (responses.coherence.col (0).mean() > 0.95);
}

TEST_CASE ("what is left of the motion before a hit is told", "[hammer]")
{
    // The lowest mode, by 3.8 1/s the slowest, has fallen to 9 %.
    const auto soon = test::simulateHits ({ { 0.1, 40, 1e-3 }, { 0.745, 40, 1e-3 } }, 1.5, 4);
    CHECK (examineHits ({ soon }, {}).motionBefore > 0.03);
    CHECK (examineHits ({ soon }, {}).motionBefore < 0.2);
    CHECK (examineHits ({ fiveHits() }, {}).motionBefore < 0.02);
}

TEST_CASE ("with the bounced and the overloaded hit the response would be wrong", "[hammer]")
{
    const std::vector<HammerRecording> recordings { fiveHits() };
    auto examined = examineHits (recordings, {});

    for (auto& hit : examined.hits[0])
        hit.fault.clear();

    const auto lines = drivenLines (recordings, examined, 50, 1000);
    const auto responses = hammerResponses (recordings, examined, lines, { 0 }, ResponseEstimator::h1);
    CHECK (errorOf (responses, lines, examined.windowDecay, 0) > -20);
}

TEST_CASE ("the exponential window makes a cut-off hit exact: the response at i omega plus the decay rate", "[hammer]")
{
    // A third of a second, in which the lowest mode only falls to 28 %.
    const std::vector<HammerRecording> recordings { test::simulateHits ({ { 0.02, 40, 1e-3 } }, 0.36, 5),
                                                    test::simulateHits ({ { 0.02, 30, 1e-3 } }, 0.36, 6) };
    const auto examined = examineHits (recordings, {});
    CHECK (examined.windowDecay > 10);
    CHECK (examined.windowDecay < 25);
    const auto lines = drivenLines (recordings, examined, 50, 1000);
    const auto responses = hammerResponses (recordings, examined, lines, { 0, 1 }, ResponseEstimator::h1);
    CHECK (errorOf (responses, lines, examined.windowDecay, 0) < -50);

    HammerSettings unwindowed;
    unwindowed.windowDecay = 0;
    const auto leaking = examineHits (recordings, unwindowed);
    CHECK (errorOf (hammerResponses (recordings, leaking, lines, { 0, 1 }, ResponseEstimator::h1), lines, 0, 0) > -15);
}

TEST_CASE ("a record may begin a few milliseconds before its hit, but not within it", "[hammer]")
{
    const auto whole = test::simulateHits ({ { 0.02, 40, 1e-3 } }, 0.36, 5);
    const auto cutBy = [&whole] (double seconds)
    {
        const auto left = whole.force.size() - static_cast<Eigen::Index> (seconds * test::hammerRate);
        return HammerRecording { "hits.wav", test::hammerRate, whole.force.tail (left),
                                 whole.responses.rightCols (left), whole.fullScales };
    };

    for (const auto lead : { 5e-3, 2e-3, 1e-3 })
    {
        const std::vector<HammerRecording> recordings { cutBy (0.02 - lead) };
        const auto examined = examineHits (recordings, {});
        const auto lines = drivenLines (recordings, examined, 50, 1000);
        const auto responses = hammerResponses (recordings, examined, lines, { 0 }, ResponseEstimator::h1);
        // Noise of one hit 60 dB below the largest sample; the offsets come from fewer samples.
        CHECK (errorOf (responses, lines, examined.windowDecay, 0) < -44);
    }

    CHECK (errorText ([&] { examineHits ({ cutBy (0.0205) }, {}); })
               .ends_with ("incomplete: the recording begins within the hit"));
}

TEST_CASE ("the last hit of a record counts where its motion has decayed", "[hammer]")
{
    const std::vector<test::Pulse> pulses { { 0.11, 40, 1e-3 }, { 2.21, 35, 1e-3 } };
    const auto usedOf = [&pulses] (double seconds)
    { return examineHits ({ test::simulateHits (pulses, seconds, 3) }, {}).usedHits(); };
    CHECK (usedOf (4.4) == 2);
    CHECK (usedOf (4.1) == 2); // 1.9 s of 2.1 s: a thousandth is left.
    CHECK (usedOf (2.9) == 1); // 0.7 s: 7 % is left, less than half of the block is there.
}

TEST_CASE ("hits of a slow structure are found at 20 Hz", "[hammer]")
{
    constexpr double rate = 20, frequency = 1.5, decay = 0.1;
    HammerRecording recording { "floor", rate, Eigen::VectorXd::Zero (1200), Eigen::MatrixXd::Zero (1, 1200),
                                Eigen::VectorXd::Zero (2) };
    recording.force.segment (100, 3) << 300, 1000, 400;

    for (Eigen::Index n = 101; n < 1200; ++n)
        recording.responses (0, n) =
            std::exp (-decay * static_cast<double> (n - 101) / rate)
            * std::sin (2 * std::numbers::pi * frequency * static_cast<double> (n - 101) / rate);

    const auto examined = examineHits ({ recording }, {});
    CHECK (examined.usedHits() == 1);
    const auto lines = drivenLines ({ recording }, examined, 0.5, 5);
    const auto responses = hammerResponses ({ recording }, examined, lines, { 0 }, ResponseEstimator::h1);
    Eigen::Index largest = 0;
    responses.values.col (0).cwiseAbs().maxCoeff (&largest);
    CHECK (std::abs (lines.frequencies[largest] - frequency) < rate / static_cast<double> (examined.block));
}

TEST_CASE ("H2 lies above H1 by the coherence, Hv between them", "[hammer]")
{
    const std::vector<HammerRecording> recordings { fiveHits() };
    const auto examined = examineHits (recordings, {});
    const auto lines = drivenLines (recordings, examined, 50, 1000);
    const auto h1 = hammerResponses (recordings, examined, lines, { 0 }, ResponseEstimator::h1),
               h2 = hammerResponses (recordings, examined, lines, { 0 }, ResponseEstimator::h2),
               hv = hammerResponses (recordings, examined, lines, { 0 }, ResponseEstimator::hv);
    const Eigen::ArrayXXd ratio = h1.values.cwiseAbs().array() / h2.values.cwiseAbs().array();
    CHECK ((ratio - h1.coherence.array()).abs().maxCoeff() < 1e-9);
    CHECK ((hv.values.cwiseAbs2().array() / h1.values.cwiseAbs().array() / h2.values.cwiseAbs().array() - 1)
               .abs()
               .maxCoeff()
           < 1e-9);
}

TEST_CASE ("lines end where the force does, and one hit alone tells no coherence", "[hammer]")
{
    const std::vector<HammerRecording> recordings { test::simulateHits ({ { 0.1, 40, 4e-3 } }, 1, 7) };
    const auto examined = examineHits (recordings, {});
    const auto lines = drivenLines (recordings, examined, 0, 0);
    // Of a squared sine over 4 ms |sinc / (1 - (f T)^2)| is -30 dB at 463 Hz, the main lobe ends at 500 Hz.
    CHECK (lines.frequencies[lines.frequencies.size() - 1] == Approx (463).margin (8));
    CHECK (hammerResponses (recordings, examined, lines, { 0 }, ResponseEstimator::h1).coherence.size() == 0);
}

TEST_CASE ("flat tops are overloads whatever the full scale, slow quantised waves are none", "[hammer]")
{
    auto clipped = test::simulateHits ({ { 0.1, 40, 2e-3 } }, 0.8, 9);
    const auto limit = 0.7 * clipped.force.maxCoeff();
    clipped.force = clipped.force.cwiseMin (limit);
    CHECK (errorText ([&] { examineHits ({ clipped }, {}); }).find ("overload of the force") != std::string::npos);

    auto quantised = test::simulateHits ({ { 0.1, 40, 1e-3 } }, 0.8, 9);
    const auto step = quantised.responses.cwiseAbs().maxCoeff() / 20; // A few bits: tops of several equal samples.
    quantised.responses = (quantised.responses / step).array().round() * step;
    CHECK (examineHits ({ quantised }, {}).usedHits() == 1);
}

TEST_CASE ("a recording without a hit, and one that ends too early, say so", "[hammer]")
{
    auto silent = test::simulateHits ({}, 0.5, 1);
    std::mt19937 generator (1);
    std::normal_distribution<double> normal;

    for (auto& sample : silent.force)
        sample = normal (generator);

    CHECK (errorText ([&] { examineHits ({ silent }, {}); }).find ("hits.wav: has no hit") == 0);

    HammerSettings longer;
    longer.block = 2;
    CHECK (errorText (
               [&] {
                   examineHits ({ test::simulateHits ({ { 0.1, 40, 1e-3 } }, 0.8, 9) }, longer);
               })
               .find ("incomplete")
           != std::string::npos);

    HammerRecording coarse { "hits.wav", 100, Eigen::VectorXd::Zero (40), Eigen::MatrixXd::Zero (1, 40),
                             Eigen::VectorXd::Zero (2) };
    coarse.force[5] = 1;
    CHECK (errorText ([&] { examineHits ({ coarse }, {}); })
           == "hits.wav: leaves 40 samples for a hit; allowed: 64 and more");
}

TEST_CASE ("the damping that identify finds is the surface's: the window's is taken off", "[hammer]")
{
    RecordingFile file;

    for (const auto seed : { 11U, 12U, 13U })
    {
        const auto made = test::simulateHits ({ { 0.02, 40, 1e-3 } }, 0.36, seed);
        RecordedSignals recording { "hit", made.sampleRate, {}, {} };
        recording.signals.push_back ({ true, "1", 3, { {}, 1, DriveQuantity::force }, 0, made.force });

        for (Eigen::Index sensor = 0; sensor < 2; ++sensor)
            recording.signals.push_back ({ false,
                                           std::to_string (sensor + 1),
                                           3,
                                           { ResponseQuantity::velocity, 1, {} },
                                           0,
                                           made.responses.row (sensor).transpose() });

        file.recordings.push_back (std::move (recording));
    }

    HammerOptions options;
    options.lowestFrequency = 50;
    options.highestFrequency = 1000;
    const auto bytes = encodeUniversalFile (hammerSets (measureByHammer ({ file }, options)));
    const auto measurement = mergedResponses ({ decodeMeasurement (bytes, "h.uff", CsvForm::byHeadings) }, {});
    REQUIRE (measurement.windowDecay > 10); // The lowest mode decays by 3.8 1/s.
    const RecordEffects effects { 0, measurement.windowDecay };
    const auto found =
        withoutRecordEffects (identify (withModalNumerators (measurement.responses, effects), {}), effects);
    REQUIRE (found.modes() == 3);

    for (Eigen::Index k = 0; k < 3; ++k)
    {
        const auto& mode = test::hammeredModes[static_cast<std::size_t> (k)];
        CHECK (found.angularFrequencies[k] == Approx (2 * std::numbers::pi * mode.frequency).epsilon (1e-4));
        CHECK (found.dampingRatios[k] == Approx (mode.damping).epsilon (0.01));
    }
}
