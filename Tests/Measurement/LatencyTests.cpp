#include "MeasuredBeam.h"

#include <antinode_measurement/RunAnalysis.h>
#include <antinode_numerics/Statistics.h>

#include <Support/ErrorText.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

TEST_CASE ("Latency is found to a thousandth of a sample, at any gain and sign of the loop, in noise")
{
    const auto signal = GENERATE (ExcitationSignal::multisine, ExcitationSignal::sweep, ExcitationSignal::noise);
    const auto late = GENERATE (0.0, 0.5, 117.0, 1234.567, 4799.999); // samples
    const auto excitation = testExcitation (shortSettings (signal, 1));
    const auto model = sineBeam (1, 1);
    SimulatedBenchSettings bench;
    bench.delay = late / excitation.settings.sampleRate;
    auto sync = recordRun (excitation, model, 0, bench).sync;

    CHECK (estimateLatency (excitation, sync) == Approx (late).margin (1e-6));
    const auto noise = RandomNumbers (5).normal (sync.size());
    CHECK (estimateLatency (excitation, -0.03 * sync + 1e-4 * noise) == Approx (late).margin (1e-3));
}

TEST_CASE ("A sync channel without the excitation says so")
{
    const auto excitation = testExcitation (shortSettings (ExcitationSignal::multisine, 1));
    const auto silent = [&] { estimateLatency (excitation, Eigen::VectorXd::Zero (excitation.runLength)); };
    const auto noise = [&] { estimateLatency (excitation, RandomNumbers (1).normal (excitation.runLength)); };
    const auto tooShort = [&] { estimateLatency (excitation, Eigen::VectorXd::Zero (100)); };
    CHECK_THAT (errorText (silent), Catch::Contains ("does not contain the excitation signal"));
    CHECK_THAT (errorText (noise), Catch::Contains ("does not contain the excitation signal"));
    CHECK_THAT (errorText (tooShort), Catch::Contains ("has 100 samples"));
}
