#include "Support/DisturbedStructure.h"
#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
bool isDoubted (const ModeQuality& quality, const std::string& part)
{
    return std::any_of (quality.warnings.begin(), quality.warnings.end(),
                        [&part] (const auto& warning) { return warning.find (part) != std::string::npos; });
}
} // namespace

TEST_CASE ("Noise alone makes no mode doubtful that is known well", "[identification]")
{
    // 30 modes of a plate, some closer than their widths: free residues are far noisier than the fit.
    const auto truth = knownPlate (2, 30);
    auto responses = idealResponses (truth, lines (200, 11000, 8));
    addNoise (responses, 10, 6);
    const auto modes = identify (responses, {});
    CHECK (score (modes, truth).found == 30);

    for (const auto& quality : modes.quality)
    {
        CAPTURE (quality.signalToNoise);
        CHECK (quality.warnings.empty());
    }
}

TEST_CASE ("Resonances that differ from point to point are one mode each, and that is said", "[identification]")
{
    const auto truth = lowestModes (knownBeam (5, 16, 3), 6);
    // So much would split most resonances.
    const auto modes = identify (disturbedResponses (truth, lines (200, 4000, 2), { 500e-6, 0 }, 3), {});
    CHECK (modes.modes() == truth.frequencies.size());
    CHECK (std::any_of (modes.warnings.begin(), modes.warnings.end(),
                        [] (const auto& warning)
                        { return warning.find ("ppm from point to point") != std::string::npos; }));
}

TEST_CASE ("A fit that stops at rounding has converged, one that stops early has not", "[identification]")
{
    const auto warns = [] (const IdentifiedModes& modes)
    {
        return std::any_of (modes.warnings.begin(), modes.warnings.end(),
                            [] (const auto& warning)
                            { return warning.find ("did not converge") != std::string::npos; });
    };
    const auto beam = lowestModes (knownBeam (5, 8, 2), 5);

    for (const auto decibels : { 40.0, 60.0, 80.0, 120.0 })
    {
        CAPTURE (decibels);
        auto responses = idealResponses (beam, lines (200, 3500, 2));
        addNoise (responses, decibels, 3);
        CHECK (! warns (identify (responses, {})));
    }

    // Of accelerations that are said to be velocities poles wander without end.
    auto responses = idealResponses (beam, lines (200, 3500, 2));
    addNoise (responses, 50, 3);

    for (auto& values : responses.values)
        for (Eigen::Index f = 0; f < values.rows(); ++f)
            values.row (f) *= std::complex<double> (0, 2 * std::numbers::pi * responses.frequencies[f]);

    CHECK (warns (identify (responses, {})));
}

TEST_CASE ("What is known badly is named with its uncertainty", "[identification]")
{
    // One mode that a tenth of the others' drive excites, in a quarter of their energy as noise.
    auto truth = lowestModes (knownBeam (4, 12, 2), 4);
    truth.participation.row (2) *= 0.02;
    auto responses = idealResponses (truth, lines (200, 3000, 2));
    addNoise (responses, 6, 4);
    IdentificationOptions options;
    options.complexModes = false;
    const auto modes = identify (responses, options);
    REQUIRE (modes.modes() >= 3);

    for (Eigen::Index k = 0; k < modes.modes(); ++k)
    {
        const auto& deviations = modes.deviations;
        const auto worst =
            std::max ({ deviations.dampingRatios[k] / modes.dampingRatios[k],
                        deviations.angularFrequencies[k] / (modes.dampingRatios[k] * modes.angularFrequencies[k]),
                        deviations.shapes.col (k).norm() / modes.shapes.col (k).norm(),
                        deviations.participation.row (k).norm() / modes.participation.row (k).norm() });
        CHECK (isDoubted (modes.quality[std::size_t (k)], "is uncertain by") == (worst > 0.1));
    }
}

TEST_CASE ("A range is chosen on points spread over all", "[identification]")
{
    FrequencyResponses responses;
    responses.frequencies = lines (1, 8, 1);
    responses.points.setZero (165, 2);
    responses.references = { { "C1", {} } };
    responses.values = { Eigen::RowVectorXcd::LinSpaced (165, 0, 164).replicate (8, 1) };
    const auto points = samplePoints (responses);
    REQUIRE (points.size() == 24);
    CHECK (points.front() < 7);
    CHECK (points.back() > 157);

    for (std::size_t n = 1; n < points.size(); ++n)
        CHECK (points[n] - points[n - 1] >= 6);

    const auto sample = atPoints (responses, points);
    CHECK (sample.points.rows() == 24);
    CHECK (sample.values[0](5, 3).real() == static_cast<double> (points[3]));

    IdentificationOptions options;
    options.pointMasses = Eigen::VectorXd::LinSpaced (165, 0, 164);
    CHECK (atPoints (options, points).pointMasses[3] == static_cast<double> (points[3]));

    responses.points.setZero (5, 2);
    CHECK (samplePoints (responses) == std::vector<Eigen::Index> { 0, 1, 2, 3, 4 });
}
