#include "Support/MeasuredStructure.h"

#include <antinode_identification/Identification.h>

#include <catch2/catch.hpp>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr Eigen::Index modeCount = 3, pointCount = 4, referenceCount = 2;

/** All that a model of modes has, in one vector: frequencies, dampings, shapes, participations, delay, residual terms.
 */
struct Parameters
{
    Eigen::VectorXd values;

    static constexpr Eigen::Index shapes = 2 * modeCount, participation = shapes + pointCount * modeCount,
                                  delay = participation + modeCount * referenceCount, residuals = delay + 1, powers = 9,
                                  count = residuals + powers * pointCount * referenceCount;
};

IdentifiedModes toModes (const Eigen::VectorXd& values, const IdentifiedModes& like)
{
    auto modes = like;
    modes.angularFrequencies = values.head (modeCount);
    modes.dampingRatios = values.segment (modeCount, modeCount);
    modes.shapes = values.segment (Parameters::shapes, pointCount * modeCount).reshaped (pointCount, modeCount);
    modes.participation =
        values.segment (Parameters::participation, modeCount * referenceCount).reshaped (modeCount, referenceCount);
    modes.delay = values[Parameters::delay];

    for (std::size_t n = 0; n < Parameters::powers; ++n)
        modes.residuals[n].coefficients =
            values
                .segment (Parameters::residuals + static_cast<Eigen::Index> (n) * pointCount * referenceCount,
                          pointCount * referenceCount)
                .reshaped (pointCount, referenceCount);

    return modes;
}

Eigen::VectorXd toValues (const IdentifiedModes& modes)
{
    Eigen::VectorXd values (Parameters::count);
    values << modes.angularFrequencies, modes.dampingRatios, modes.shapes.reshaped(), modes.participation.reshaped(),
        modes.delay, Eigen::VectorXd::Zero (Parameters::count - Parameters::residuals);

    for (std::size_t n = 0; n < Parameters::powers; ++n)
        values.segment (Parameters::residuals + static_cast<Eigen::Index> (n) * pointCount * referenceCount,
                        pointCount * referenceCount) = modes.residuals[n].coefficients.reshaped();

    return values;
}

Eigen::VectorXd flat (const FrequencyResponses& responses)
{
    const auto lines = responses.frequencies.size();
    Eigen::VectorXd result (2 * lines * pointCount * referenceCount);

    for (Eigen::Index i = 0; i < referenceCount; ++i)
        for (Eigen::Index p = 0; p < pointCount; ++p)
        {
            const auto& column = responses.values[static_cast<std::size_t> (i)].col (p);
            result.segment ((i * pointCount + p) * 2 * lines, 2 * lines) << column.real(), column.imag();
        }

    return result;
}

/** Derivatives of all values by all parameters, by differences, each in units of what makes its column 1 long. */
Eigen::MatrixXd jacobian (const IdentifiedModes& modes, const Eigen::VectorXd& frequencies, Eigen::VectorXd& units)
{
    const auto values = toValues (modes);
    Eigen::MatrixXd result (2 * frequencies.size() * pointCount * referenceCount, Parameters::count);
    units.resize (Parameters::count);

    for (Eigen::Index n = 0; n < Parameters::count; ++n)
    {
        auto after = values, before = values;
        const auto step = n < Parameters::residuals
                              ? 1e-5 * std::max (std::abs (values[n]), n == Parameters::delay ? 1e-6 : 1e-3)
                              : 1e-3 * std::max (std::abs (values[n]), 1e-30);
        after[n] += step;
        before[n] -= step;
        result.col (n) = (flat (synthesise (toModes (after, modes), frequencies))
                          - flat (synthesise (toModes (before, modes), frequencies)))
                         / (2 * step);
        units[n] = 1 / result.col (n).norm();
        result.col (n) *= units[n];
    }

    return result;
}

KnownStructure threeModes()
{
    KnownStructure structure;
    structure.points.resize (pointCount, 2);
    structure.points << 0, 0, 0.01, 0, 0.02, 0, 0.03, 0;
    structure.frequencies = Eigen::Vector3d (900, 930, 1300);
    structure.dampingRatios = Eigen::Vector3d (0.01, 0.015, 0.008);
    structure.shapes.resize (pointCount, modeCount);
    structure.shapes << 1, 0.5, -0.8, 0.4, -1.2, 0.6, -0.7, 0.3, 1.1, 0.2, 0.9, -0.5;
    structure.participation.resize (modeCount, referenceCount);
    structure.participation << 1, 0.3, -0.4, 0.8, 0.7, 0.6;
    return structure;
}
} // namespace

TEST_CASE ("Stated deviations of noise are the Cramer-Rao bound of the whole model, computed by brute force",
           "[identification]")
{
    const auto frequencies = lines (500, 1700, 4);
    auto responses = idealResponses (threeModes(), frequencies);
    const auto noise = addNoise (responses, 30, 5);

    for (std::size_t i = 0; i < referenceCount; ++i)
        responses.variances.emplace_back (Eigen::MatrixXd::Constant (frequencies.size(), pointCount, noise * noise));

    const auto modes = identify (responses, {});
    REQUIRE (modes.modes() == modeCount);
    REQUIRE (modes.residuals.size() == Parameters::powers);
    Eigen::VectorXd units;
    const auto derivatives = jacobian (modes, frequencies, units);
    // Lengths of shapes are free: the smallest of all solutions is taken, and asked only what does not depend on them.
    const Eigen::MatrixXd inverse =
        (derivatives.transpose() * derivatives).completeOrthogonalDecomposition().pseudoInverse();
    const Eigen::MatrixXd covariance = units.asDiagonal() * inverse * units.asDiagonal() * (noise * noise / 2);
    // The fit's own variance is at least the given one, and is so by chance a little more.
    const auto tolerance = 0.03;

    for (Eigen::Index k = 0; k < modeCount; ++k)
    {
        CHECK (modes.noiseDeviations.angularFrequencies[k]
               == Approx (std::sqrt (covariance (k, k))).epsilon (tolerance));
        CHECK (modes.noiseDeviations.dampingRatios[k]
               == Approx (std::sqrt (covariance (modeCount + k, modeCount + k))).epsilon (tolerance));

        // The size of a participation at fixed length of its shape.
        for (Eigen::Index i = 0; i < referenceCount; ++i)
        {
            Eigen::VectorXd weights = Eigen::VectorXd::Zero (Parameters::count);
            weights[Parameters::participation + i * modeCount + k] = 1;
            weights.segment (Parameters::shapes + k * pointCount, pointCount) =
                modes.participation (k, i) * modes.shapes.col (k) / modes.shapes.col (k).squaredNorm();
            CHECK (modes.noiseDeviations.participation (k, i)
                   == Approx (std::sqrt (weights.dot (covariance * weights))).epsilon (tolerance));
        }
    }

    CHECK (modes.noiseDeviations.delay
           == Approx (std::sqrt (covariance (Parameters::delay, Parameters::delay))).epsilon (tolerance));
}
