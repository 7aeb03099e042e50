#include "Support/MeasuredStructure.h"

#include <antinode_identification/FitDiagram.h>
#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <numbers>

using namespace antinode;
using namespace antinode::test;

namespace
{
IdentifiedModes bandOf (double minimum, double maximum)
{
    IdentifiedModes modes;
    modes.minimumFrequency = minimum;
    modes.maximumFrequency = maximum;
    return modes;
}
} // namespace

TEST_CASE ("The mode indicator has the singular values of a matrix of known ones", "[identification]")
{
    // U diag (3, 2) V^H with U of two orthonormal columns and V a rotation: the factors are known.
    Eigen::MatrixXcd left (3, 2), right (2, 2);
    left << std::complex<double> (0, 0.6), 0.8, std::complex<double> (0, 0.8), -0.6, 0, 0;
    right << 0.8, -0.6, 0.6, 0.8;
    const Eigen::MatrixXcd table = left * Eigen::Vector2cd (3, 2).asDiagonal() * right.adjoint();
    FrequencyResponses responses;
    responses.frequencies = Eigen::VectorXd::LinSpaced (2, 10, 20);
    responses.points = Eigen::MatrixX2d::Zero (3, 2);
    responses.references = { { "A", {} }, { "B", {} } };

    for (Eigen::Index i = 0; i < 2; ++i)
    {
        Eigen::MatrixXcd values (2, 3);
        values.row (0) = table.col (i).transpose();
        values.row (1).setConstant (std::numeric_limits<double>::quiet_NaN());
        responses.values.push_back (values);
    }

    const auto indicator = modeIndicator (responses);
    REQUIRE (indicator.cols() == 2);
    CHECK (indicator (0, 0) == Approx (3).epsilon (1e-12));
    CHECK (indicator (0, 1) == Approx (2).epsilon (1e-12));
    CHECK (indicator.row (1).isZero());
}

TEST_CASE ("The error of a diagram is the noise, and its lines are those of the band", "[identification]")
{
    const auto truth = knownBeam (3, 20, 2);
    auto responses = idealResponses (truth, lines (200, 30000, 10));
    const auto noise = addNoise (responses, 50, 3);
    IdentificationOptions options;
    options.minimumFrequency = 250;
    options.maximumFrequency = 29500;
    const auto modes = identify (responses, options);
    const auto diagram = fitDiagram (responses, modes, 1 << 24);
    CHECK (diagram.measured.frequencies[0] == 250);
    CHECK (diagram.measured.frequencies[diagram.measured.frequencies.size() - 1] == 29500);
    CHECK (diagram.usedLines == 2926);
    CHECK (diagram.measured.frequencies.size() == 2926);
    CHECK (diagram.indicator.rows() == 2926);
    // 2926 lines of 40 values each: their mean square varies by 0.3 %; the fit takes some of it.
    CHECK (std::sqrt (diagram.errorSize.squaredNorm() / 2926) == Approx (noise).epsilon (0.05));
}

TEST_CASE ("Where lines are left out a resonance keeps its form", "[identification]")
{
    auto modes = bandOf (1, 10000);
    modes.angularFrequencies = Eigen::VectorXd::Constant (1, 2 * std::numbers::pi * 500);
    modes.dampingRatios = Eigen::VectorXd::Constant (1, 0.01); // A half width of 5 Hz.
    FrequencyResponses responses;
    responses.frequencies = lines (1, 10000, 1);
    const auto used = usedLines (responses, modes);
    REQUIRE (used.size() == 10000);
    const auto thinned = thinnedLines (used, responses, modes, 200);
    CHECK (thinned.size() <= 200);
    CHECK (thinned.size() >= 100); // Half of them lie evenly; at the resonance a line may take several steps.
    CHECK (thinned.front() == 0);
    CHECK (thinned.back() == 9999);
    CHECK (std::is_sorted (thinned.begin(), thinned.end()));
    const auto nearLines =
        std::count_if (thinned.begin(), thinned.end(), [] (auto n) { return std::abs (n - 499) <= 5; });
    CHECK (nearLines == 11); // All: they change the phase by more than a step each.
    CHECK (thinnedLines (used, responses, modes, 20000) == used);
}

TEST_CASE ("Each candidate that is picked becomes the mode, also those that are not taken by themselves",
           "[identification]")
{
    const auto truth = knownBeam (5, 30, 2);
    auto responses = idealResponses (truth, lines (200, 6000, 4));
    addNoise (responses, 30, 5);
    const auto modes = identify (responses, {});
    REQUIRE (modes.candidates.size() >= static_cast<std::size_t> (modes.modes()));
    Eigen::Index fitted = 0;

    for (const auto& candidate : modes.candidates)
        if (candidate.mode)
        {
            // A candidate differs from the mode that the fit makes of it by much less than its half width.
            const auto frequency = modes.angularFrequencies[*candidate.mode] / (2 * std::numbers::pi);
            CHECK (std::abs (candidate.frequency - frequency) < 0.3 * candidate.dampingRatio * candidate.frequency);
            CHECK (*candidate.mode == fitted++);
        }

    CHECK (fitted == modes.modes());
    IdentificationOptions options;
    options.selected = { modes.candidates[1].frequency, modes.candidates[2].frequency };
    const auto again = identify (responses, options);
    REQUIRE (again.candidates.size() == modes.candidates.size());
    CHECK (again.candidates[1].mode == 0);
    CHECK (again.candidates[2].mode == 1);
}
