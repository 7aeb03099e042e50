#include "Support/SineBeam.h"

#include <antinode_focus/FreeSamples.h>
#include <antinode_focus/Prediction.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

using namespace antinode;

namespace
{
constexpr Playback fast { Reconstruction::bandLimited, 96000 };
}

TEST_CASE ("Rows of sparse samples are what the samples that are played for them leave in the modes", "[sparseSamples]")
{
    const auto model = test::sineBeam (12, 2);
    std::vector<int> modes (12);
    std::iota (modes.begin(), modes.end(), 0);
    FocusDescription focus;
    focus.focusTime = 0.012;

    for (const auto ratio : { SampleRatio {}, SampleRatio { 3, 2 }, SampleRatio { 2, 1 }, SampleRatio { 3, 1 } })
    {
        CAPTURE (ratio.played, ratio.free);
        const auto sparse = sparseSamples (focus, fast, modes.size(), ratio);
        const Eigen::MatrixXd samples = Eigen::MatrixXd::NullaryExpr (
            2, sparse.range.count,
            [] (Eigen::Index i, Eigen::Index n)
            { return std::sin (0.7 * static_cast<double> (n * n % 41) + static_cast<double> (i)); });
        const auto rows = velocityWeights (model, modes, sparse);
        const Eigen::VectorXd expected =
            (rows * samples.transpose()).cwiseProduct (model.participation).rowwise().sum();
        VoltageProgram program;
        program.allocation.resize (2, 0);
        program.voltageLimits = Eigen::VectorXd::Ones (2);
        program.focusTime = focus.focusTime;
        program.samples = playedSamples (samples, sparse, focus.focusTime);
        const auto played = modalVelocities (model, predictStates (model, program, focus.focusTime));
        CHECK ((played - expected).cwiseAbs().maxCoeff() < 1e-11 * expected.cwiseAbs().maxCoeff());
        CHECK (sparse.freeRate() == Approx (96000 / ratio.value()));
        CHECK (program.samples->firstTime >= -1e-12);

        // Free samples are played as they are where one lies at the same place.
        const auto first =
            static_cast<Eigen::Index> (std::llround ((focus.focusTime - program.samples->firstTime) * 96000));
        CHECK (program.samples->values (0, first) == Approx (samples (0, sparse.range.focus)).margin (1e-12));

        if (! ratio.isOne())
            CHECK (sparse.placeOf (first) == Approx (static_cast<double> (sparse.range.focus)));
    }
}

TEST_CASE ("Sparse samples have three times the highest frequency at least, and held ones are never sparse",
           "[sparseSamples]")
{
    const auto ratiosOf = [] (Playback playback, double frequency)
    {
        std::vector<double> values;

        for (const auto ratio : sparseRatios (playback, frequency))
            values.push_back (ratio.value());

        return values;
    };
    CHECK (ratiosOf (fast, 20000) == std::vector { 1.5, 1.0 });
    CHECK (ratiosOf (fast, 22000) == std::vector { 1.0 });
    CHECK (ratiosOf ({ Reconstruction::bandLimited, 192000 }, 20000) == std::vector { 3.0, 2.0, 1.5, 1.0 });
    CHECK (ratiosOf ({ Reconstruction::zeroOrderHold, 192000 }, 2000) == std::vector { 1.0 });
}
