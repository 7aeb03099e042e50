#include "Support/ErrorText.h"
#include "Support/SineBeam.h"

#include <antinode_measurement/Amplifier.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;
using test::sineBeam;

namespace
{
constexpr double pi = 3.14159265358979323846;

/** A response with noise at so many lines. */
Eigen::VectorXcd measured (const Amplifier& amplifier, const Eigen::VectorXd& frequencies, double noise)
{
    RandomNumbers random (7);
    Eigen::VectorXcd response (frequencies.size());

    for (Eigen::Index f = 0; f < frequencies.size(); ++f)
    {
        const auto error = random.normal (2);
        response[f] = responseOf (amplifier, frequencies[f])
                      * (1.0 + noise * std::complex<double> (error[0], error[1]) / std::sqrt (2.0));
    }

    return response;
}
} // namespace

TEST_CASE ("A low-pass of first order has half the power and an eighth of a turn at its bandwidth", "[amplifier]")
{
    const Amplifier amplifier { 2, 1 / (2 * pi * 10000), 0 };
    CHECK (std::norm (responseOf (amplifier, 10000)) == Approx (2));
    CHECK (std::arg (responseOf (amplifier, 10000)) == Approx (-pi / 4));
    CHECK (lateness (amplifier, 1) == Approx (amplifier.timeConstant));
}

TEST_CASE ("Gain, bandwidth and delay come back from a response at 40 dB", "[amplifier]")
{
    const Eigen::VectorXd frequencies = Eigen::VectorXd::LinSpaced (400, 100, 20000);

    for (const auto bandwidth : { 5000.0, 30000.0 })
        for (const auto delay : { -3e-6, 0.0, 150e-6 })
        {
            const Amplifier right { 19.3, 1 / (2 * pi * bandwidth), delay };
            const auto found = fitAmplifier (frequencies, measured (right, frequencies, 0.01));
            CAPTURE (bandwidth, delay);
            CHECK (found.amplifier.gain == Approx (right.gain).epsilon (0.003));
            CHECK (found.amplifier.timeConstant == Approx (right.timeConstant).epsilon (0.03));
            CHECK (found.amplifier.delay == Approx (delay).margin (3e-7));
            CHECK (found.misfit == Approx (0.01).epsilon (0.15));
        }
}

TEST_CASE ("An amplifier without a low-pass has none", "[amplifier]")
{
    const Eigen::VectorXd frequencies = Eigen::VectorXd::LinSpaced (200, 100, 10000);
    const auto found = fitAmplifier (frequencies, measured ({ 0.5, 0, 2e-5 }, frequencies, 0));
    CHECK (found.amplifier.gain == Approx (0.5));
    CHECK (found.amplifier.timeConstant < 1e-9);
    CHECK (found.amplifier.delay == Approx (2e-5));
}

TEST_CASE ("Amplifiers in front of ceramics scale participations, lower limits and lag", "[amplifier]")
{
    const auto model = sineBeam (4, 2);
    const Amplifier amplifier { 1.25, 1 / (2 * pi * model.frequencyHz (3)), 1e-5 };
    const auto with = throughAmplifiers (model, { amplifier, {} });

    for (Eigen::Index k = 0; k < 4; ++k)
    {
        CHECK (with.participation (k, 0) == Approx (1.25 * model.participation (k, 0)));
        CHECK (with.participation (k, 1) == model.participation (k, 1));
    }

    CHECK (with.ceramics[0].lag == InputLag { amplifier.delay, amplifier.timeConstant, 0 });
    CHECK (with.ceramics[1].lag == InputLag {});
    CHECK (errorText (
               [&] {
                   throughAmplifiers (with, { amplifier, {} });
               })
           == "amplifier: stands in front of '" + with.ceramics[0].name
                  + "' already; allowed: the device as it was before it was calibrated");
    CHECK (
        errorText (
            [&] {
                throughAmplifiers (model, { { 1, 0, 0.02 }, {} });
            })
        == "amplifier: of '" + model.ceramics[0].name
               + "' is later than a device file can describe; allowed: up to 10 ms after the first one, and as long a "
                 "time constant");
    CHECK (with.ceramics[0].voltageLimit == Approx (model.ceramics[0].voltageLimit / 1.25));
    CHECK (with.ceramics[1].voltageLimit == model.ceramics[1].voltageLimit);
    CHECK (errorText ([&] { throughAmplifiers (model, { amplifier }); })
           == "amplifier: is needed for each of the 2 ceramics");
    CHECK (errorText (
               [&] {
                   throughAmplifiers (model, { { -1, 0, 0 }, {} });
               })
           == "amplifier: has a gain of 0 or less");
}
