#include "Support/IdentificationScore.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
/** Each row with an imaginary part that no turn takes away, as large as the collinearity wants it. */
Eigen::MatrixXcd spreadPhases (const Eigen::MatrixXd& rows, double collinearity, unsigned seed)
{
    const auto root = std::sqrt (collinearity);
    const auto size = std::sqrt ((1 - root) / (1 + root));
    Eigen::MatrixXcd result = rows.cast<std::complex<double>>();
    ComplexNoise noise (seed);

    for (Eigen::Index k = 0; k < rows.rows(); ++k)
    {
        Eigen::RowVectorXd other =
            Eigen::RowVectorXcd::NullaryExpr (rows.cols(), [&] (Eigen::Index) { return noise(); }).real();
        other -= other.dot (rows.row (k)) / rows.row (k).squaredNorm() * rows.row (k);
        result.row (k).imag() = size * rows.row (k).norm() / other.norm() * other;
    }

    return result;
}

/** What a vibrometer sees of complex modes with these real parts: r / (i omega - s) and its mirror, by no code of ours.
    @param drift  relative, of the resonances from point to point */
FrequencyResponses complexResponses (const KnownStructure& truth, const Eigen::VectorXd& frequencies,
                                     double collinearity, double drift = 0)
{
    const Eigen::MatrixXcd shapes = spreadPhases (truth.shapes.transpose(), collinearity, 11);
    const Eigen::MatrixXcd participation = spreadPhases (truth.participation, collinearity, 12);
    auto responses = idealResponses (truth, frequencies);

    for (Eigen::Index i = 0; i < participation.cols(); ++i)
    {
        auto& values = responses.values[static_cast<std::size_t> (i)];
        values.setZero();

        for (Eigen::Index k = 0; k < shapes.rows(); ++k)
            for (Eigen::Index p = 0; p < values.cols(); ++p)
            {
                const auto resonance = 2 * std::numbers::pi * truth.frequencies[k]
                                       * (1 + drift * std::cos (2.4 * static_cast<double> (p)));
                const std::complex<double> pole (-truth.dampingRatios[k] * resonance,
                                                 resonance
                                                     * std::sqrt (1 - truth.dampingRatios[k] * truth.dampingRatios[k]));
                const auto residue =
                    shapes (k, p) * participation (k, i) * pole / std::complex<double> (0, 2 * pole.imag());

                for (Eigen::Index f = 0; f < frequencies.size(); ++f)
                {
                    const std::complex<double> at (0, 2 * std::numbers::pi * frequencies[f]);
                    values (f, p) += (residue / (at - pole) + std::conj (residue) / (at - std::conj (pole)))
                                     * std::exp (-at * truth.delay);
                }
            }
    }

    return responses;
}

bool areComplex (const IdentifiedModes& modes)
{
    return modes.complexShapes.size() > 0;
}
} // namespace

TEST_CASE ("Complex modes of MPC 0.8 are seen to be complex, and found as exactly as real ones", "[identification]")
{
    const auto truth = lowestModes (knownBeam (5, 20, 3), 20);
    auto responses = complexResponses (truth, lines (200, 29000, 2), 0.8);
    addNoise (responses, 50, 1);
    const auto modes = identify (responses, {});
    CHECK_THAT (modes.kindReason, Catch::StartsWith ("Modes are complex: "));
    REQUIRE (areComplex (modes));
    const auto result = score (modes, truth);
    CHECK (result.found == 20);
    CHECK (result.falseOnes == 0);
    CHECK (quantile (result.frequency, 0.5) < 1e-6);
    CHECK (quantile (result.frequency, 1) < 10e-6);
    CHECK (quantile (result.damping, 0.5) < 0.01e-2);
    CHECK (quantile (result.damping, 1) < 0.3e-2);
    CHECK (modes.reconstructionError == Approx (-50).margin (0.05));
    CHECK (modes.lowPasses.size() == 0);

    for (const auto& quality : modes.quality)
        CHECK (quality.collinearity == Approx (0.8).margin (0.01));
}

TEST_CASE ("The kind that is asked for is taken as it is, and modes ascend", "[identification]")
{
    const auto truth = lowestModes (knownBeam (5, 4, 2), 3);
    auto responses = idealResponses (truth, lines (200, 1400, 3));
    addNoise (responses, 40, 2);
    IdentificationOptions options;
    options.complexModes = true;
    options.selected = { truth.frequencies[2], truth.frequencies[0], truth.frequencies[1] };
    const auto modes = identify (responses, options);
    CHECK (areComplex (modes));
    CHECK (modes.kindReason.empty());
    CHECK (std::is_sorted (modes.angularFrequencies.begin(), modes.angularFrequencies.end()));
    responses = complexResponses (truth, lines (200, 1400, 3), 0.8);
    addNoise (responses, 40, 2);
    options.complexModes = false;
    CHECK (! areComplex (identify (responses, options)));
    CHECK (areComplex (identify (responses, {})));
}

TEST_CASE ("Real modes are called complex in at most one of twenty measurements", "[identification]")
{
    const auto ideal = idealResponses (lowestModes (knownBeam (5, 4, 2), 3), lines (250, 1300, 5));
    int complexOnes = 0;

    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        auto responses = ideal;
        addNoise (responses, seed % 2 == 0 ? 30 : 15, independentSeed (seed));
        complexOnes += areComplex (identify (responses, {})) ? 1 : 0;
    }

    // With a risk of one in a thousand, two of 20 are a chance of one in five thousand.
    CHECK (complexOnes < 2);
}

TEST_CASE ("Resonances that differ from point to point do not make modes complex", "[identification]")
{
    auto responses = complexResponses (lowestModes (knownBeam (5, 8, 2), 6), lines (200, 4000, 2), 1, 1e-3);
    addNoise (responses, 60, 3);
    const auto modes = identify (responses, {});
    CHECK (! areComplex (modes));
    CHECK (modes.lowPasses.size() == 0);
    CHECK_THAT (modes.kindReason, Catch::StartsWith ("Modes are real: "));
}
