#include "Support/ErrorText.h"

#include <antinode_identification/ImpulseResponses.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>

using namespace antinode;

namespace
{
IdentifiedModes twoModes()
{
    IdentifiedModes modes;
    modes.angularFrequencies = Eigen::Vector2d (600, 2500);
    modes.dampingRatios = Eigen::Vector2d (0.005, 0.01);
    modes.participation = Eigen::MatrixXd::Constant (2, 3, 0.4);
    modes.quality.resize (2);
    return modes;
}
} // namespace

TEST_CASE ("Residues of a truncated record are restored, and a mode that still rang gets a warning", "[identification]")
{
    constexpr double length = 0.7; // exp (-0.005 * 600 * 0.7) = 0.12, exp (-0.01 * 2500 * 0.7) = 2.5e-8
    const auto modes = withoutRecordEffects (twoModes(), { length, 0 });
    const std::complex<double> pole (-3, 600 * std::sqrt (1 - 0.005 * 0.005));
    CHECK (modes.participation (0, 1) == Approx (0.4 / (1.0 - std::exp (pole * length)).real()).epsilon (1e-12));
    CHECK (modes.participation (1, 1) == Approx (0.4).epsilon (1e-7));
    CHECK (modes.quality[0].warnings.size() == 1);
    CHECK (modes.quality[1].warnings.empty());
    CHECK (modes.angularFrequencies == twoModes().angularFrequencies);
}

TEST_CASE ("An exponential window is taken out of the decay rates, the damped frequency stays", "[identification]")
{
    constexpr double window = 2;
    const auto before = twoModes(), after = withoutRecordEffects (before, { 0, window });

    for (Eigen::Index k = 0; k < 2; ++k)
    {
        const auto damped = [k] (const IdentifiedModes& modes)
        { return modes.angularFrequencies[k] * std::sqrt (1 - std::pow (modes.dampingRatios[k], 2)); };
        CHECK (damped (after) == Approx (damped (before)).epsilon (1e-14));
        CHECK (after.dampingRatios[k] * after.angularFrequencies[k]
               == Approx (before.dampingRatios[k] * before.angularFrequencies[k] - window).epsilon (1e-12));
    }

    CHECK (errorText (
               [] {
                   withoutRecordEffects (twoModes(), { 0, 3.5 });
               })
               .starts_with ("exponential window: has a larger decay rate than mode 1"));
}

TEST_CASE ("Under an exponential window a mode is one of other damping once its numerator is put right",
           "[identification]")
{
    constexpr double window = 2, omega = 600, ratio = 0.005;
    FrequencyResponses responses;
    responses.frequencies = Eigen::VectorXd::LinSpaced (50, 60, 130);
    responses.values.resize (1, Eigen::MatrixXcd (50, 1));

    for (Eigen::Index f = 0; f < 50; ++f) // e^{-at} h (t) has the transform H (i omega + a).
    {
        const std::complex<double> s (window, 2 * std::numbers::pi * responses.frequencies[f]);
        responses.values[0](f, 0) = s / (s * s + 2 * ratio * omega * s + omega * omega);
    }

    const auto corrected = withModalNumerators (responses, { 0, window });
    const auto decay = ratio * omega + window, squared = omega * omega * (1 - ratio * ratio) + decay * decay;

    for (Eigen::Index f = 0; f < 50; ++f)
    {
        const std::complex<double> jw (0, 2 * std::numbers::pi * responses.frequencies[f]);
        const auto expected = jw / (jw * jw + 2 * decay * jw + squared);
        CHECK (std::abs (corrected.values[0](f, 0) - expected) < 1e-12 * std::abs (expected));
    }
}
