#include "Support/ErrorText.h"
#include "Support/SineBeam.h"

#include <antinode_measurement/Hysteresis.h>

#include <catch2/catch.hpp>

#include <complex>

using namespace antinode;

namespace
{
using Complex = std::complex<double>;

/** Of a ceramic whose full level adds 10 % and lags by 30 mrad. */
Eigen::VectorXcd responseAt (double level)
{
    const Eigen::VectorXcd small =
        Eigen::VectorXd::LinSpaced (50, 1, 6).unaryExpr ([] (double x) { return std::polar (x, 7 * x); });
    return small * Complex (1 + 0.1 * level, -0.03 * level);
}
} // namespace

TEST_CASE ("A response that grows and lags with the level is hysteresis", "[hysteresis]")
{
    const auto [high, low] = GENERATE (table<double, double> ({ { 0.8, 0.2 }, { 1, 0.01 }, { 0.5, 0.4 } }));
    const auto found = fitHysteresis (responseAt (high), responseAt (low), high, low);
    CHECK (found.hysteresis.gain == Approx (0.1));
    CHECK (found.hysteresis.phase == Approx (0.03));
    CHECK (found.misfit < 1e-12);
}

TEST_CASE ("What is not a factor of the response is told as misfit", "[hysteresis]")
{
    Eigen::VectorXcd high = responseAt (0.8);
    high[3] *= 2;
    CHECK (fitHysteresis (high, responseAt (0.2), 0.8, 0.2).misfit > 0.01);
}

TEST_CASE ("A device with hysteresis answers by its gain at the level, and lags", "[hysteresis]")
{
    const auto model = test::sineBeam (4, 2);
    const auto with = withHysteresis (model, { { 0.1, 0.03 }, { -0.2, 0 } }, Eigen::Vector2d (0.5, 1));

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        CHECK (with.participation (k, 0) == Approx (std::abs (Complex (1.05, 0.015)) * model.participation (k, 0)));
        CHECK (with.participation (k, 1) == Approx (0.8 * model.participation (k, 1)));
    }

    CHECK (with.ceramics[0].lag.angle == Approx (std::atan2 (0.015, 1.05)));
    CHECK (with.ceramics[1].lag == InputLag {});
    CHECK (errorText (
               [&] {
                   withHysteresis (with, { { 0.1, 0.03 }, {} }, Eigen::Vector2d (0.5, 1));
               })
           == "hysteresis: of ceramic 1 is in this device already; allowed: the device as it answers at low voltages");
    CHECK (errorText (
               [&] {
                   withHysteresis (model, { { 0, 2 }, {} }, Eigen::Vector2d (1, 1));
               })
           == "hysteresis: of ceramic 1 lags by 63 degrees; allowed: -45 to 45 degrees");
    CHECK (with.ceramics[0].voltageLimit == model.ceramics[0].voltageLimit);
}

TEST_CASE ("Hysteresis that makes no sense is refused in a sentence", "[hysteresis]")
{
    const auto model = test::sineBeam (4, 2);
    CHECK (errorText ([&] { fitHysteresis (responseAt (1), responseAt (0.5), 0.5, 0.5); })
           == "hysteresis: needs two levels, the higher one above the lower, both above 0");
    CHECK (errorText ([&] { fitHysteresis (responseAt (1), 0 * responseAt (1), 1, 0.5); }).find ("finite responses")
           != std::string::npos);
    // Motion in place of motion per volt: twelve times at twelve times the level.
    CHECK (errorText ([&] { fitHysteresis (12 * responseAt (0), responseAt (0), 0.6, 0.05); }).find ("per volt")
           != std::string::npos);
    CHECK (errorText ([&] { withHysteresis (model, { {} }, Eigen::Vector2d (1, 1)); })
           == "hysteresis: is needed for each of the 2 ceramics");
    CHECK (errorText (
               [&] {
                   withHysteresis (model, { { -1, 0 }, {} }, Eigen::Vector2d (1, 1));
               })
           == "hysteresis: of ceramic 1 leaves nothing at this level");
}
