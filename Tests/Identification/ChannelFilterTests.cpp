#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Responses through low-passes of first order, noise behind them. @param timeConstants  points x references, s */
FrequencyResponses throughLowPasses (const KnownStructure& truth, const Eigen::VectorXd& frequencies,
                                     const Eigen::MatrixXd& timeConstants, bool statesVariances = false)
{
    auto responses = idealResponses (truth, frequencies);

    for (Eigen::Index i = 0; i < timeConstants.cols(); ++i)
        for (Eigen::Index p = 0; p < timeConstants.rows(); ++p)
            for (Eigen::Index f = 0; f < frequencies.size(); ++f)
                responses.values[static_cast<std::size_t> (i)](f, p) /=
                    std::complex<double> (1, 2 * std::numbers::pi * frequencies[f] * timeConstants (p, i));

    const auto noise = addNoise (responses, 45, 3);

    if (statesVariances)
        responses.variances.assign (
            responses.values.size(),
            Eigen::MatrixXd::Constant (frequencies.size(), timeConstants.rows(), noise * noise));

    return responses;
}

std::string allWarnings (const IdentifiedModes& modes)
{
    std::string text;

    for (const auto& warning : modes.warnings)
        text += warning + '\n';

    return text;
}

double timeConstant (double corner)
{
    return 1 / (2 * std::numbers::pi * corner);
}
} // namespace

TEST_CASE ("Low-passes of first order are identified, and modes are right again", "[identification]")
{
    const auto truth = lowestModes (knownBeam (7, 8, 3), 5);
    Eigen::MatrixXd timeConstants = Eigen::MatrixXd::Constant (8, 3, timeConstant (2000));
    std::string said = "a low-pass of first order at";

    SECTION ("one for all") {}

    SECTION ("one of each amplifier")
    {
        timeConstants.col (1).setConstant (timeConstant (4000));
        timeConstants.col (2).setConstant (timeConstant (1000));
        said = "driver C1 at 2";
    }

    SECTION ("one of each sensor")
    {
        for (Eigen::Index p = 0; p < 8; ++p)
            timeConstants.row (p).setConstant (timeConstant (1500 + 300 * static_cast<double> (p)));

        said = "point 2 at 1";
    }

    const auto responses = throughLowPasses (truth, lines (200, 3500, 2), timeConstants);
    const auto modes = identify (responses, {});
    CAPTURE (allWarnings (modes));
    CHECK_THAT (allWarnings (modes), Catch::Contains (said));
    CHECK (modes.complexShapes.size() == 0);
    const auto result = score (modes, truth);
    CHECK (result.found == 5);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.frequency, 1) < 10e-6);
    CHECK (quantile (result.damping, 1) < 0.2e-2);
    REQUIRE (modes.lowPasses.size() == timeConstants.size());
    // The last point is a node of all modes and holds noise alone.
    const Eigen::ArrayXXd ratios = modes.lowPasses.topRows (7).cwiseQuotient (timeConstants.topRows (7));
    CHECK ((ratios - 1).abs().maxCoeff() < 0.01);

    // What is synthesised is what was measured.
    const auto given = synthesise (modes, responses.frequencies);
    double error = 0, energy = 0;

    for (std::size_t i = 0; i < responses.values.size(); ++i)
    {
        error += (given.values[i] - responses.values[i]).squaredNorm();
        energy += responses.values[i].squaredNorm();
    }

    CHECK (10 * std::log10 (error / energy) < -44);
}

TEST_CASE ("Low-passes are found by the variances that are given", "[identification]")
{
    const Eigen::MatrixXd timeConstants = Eigen::MatrixXd::Constant (8, 3, timeConstant (2000));
    const auto modes = identify (
        throughLowPasses (lowestModes (knownBeam (7, 8, 3), 5), lines (200, 3500, 2), timeConstants, true), {});
    CHECK_THAT (allWarnings (modes), Catch::Contains ("a low-pass of first order at 20"));
    REQUIRE (modes.lowPasses.size() == timeConstants.size());
    CHECK ((modes.lowPasses.array() / timeConstants.array() - 1).abs().maxCoeff() < 0.01);
}

TEST_CASE ("Low-passes of points are named so where there are as many drivers", "[identification]")
{
    Eigen::MatrixXd timeConstants (5, 5);

    for (Eigen::Index p = 0; p < 5; ++p)
        timeConstants.row (p).setConstant (timeConstant (1500 + 300 * static_cast<double> (p)));

    const auto modes =
        identify (throughLowPasses (lowestModes (knownBeam (7, 5, 5), 5), lines (200, 3500, 2), timeConstants), {});
    CHECK_THAT (allWarnings (modes), Catch::Contains ("from the responses: point 1 at 1"));
}

TEST_CASE ("A low-pass of many modes is not taken for complex modes", "[identification]")
{
    const auto truth = knownPlate (2, 24);
    const auto frequencies = lines (200, 8500, 6);
    const auto modes =
        identify (throughLowPasses (
                      truth, frequencies,
                      Eigen::MatrixXd::Constant (truth.points.rows(), truth.participation.cols(), timeConstant (6000))),
                  {});
    CHECK (modes.complexShapes.size() == 0);
    CHECK_THAT (allWarnings (modes), Catch::Contains ("a low-pass of first order at"));
    REQUIRE (modes.lowPasses.size() > 0);
    CHECK (modes.lowPasses.maxCoeff() == Approx (timeConstant (6000)).epsilon (0.002));
    const auto result = score (modes, truth);
    CHECK (result.found == 24);
    CHECK (quantile (result.frequency, 0.5) < 2e-6);
}

TEST_CASE ("Where there is no low-pass none is taken off", "[identification]")
{
    const auto truth = lowestModes (knownBeam (7, 8, 3), 5);
    auto responses = idealResponses (truth, lines (200, 3500, 2));
    addNoise (responses, 45, 3);
    CHECK (identify (responses, {}).lowPasses.size() == 0);
}
