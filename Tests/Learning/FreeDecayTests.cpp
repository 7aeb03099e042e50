#include "Support/SineBeam.h"

#include <antinode_learning/DrivenModes.h>
#include <antinode_numerics/Statistics.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;
using test::sineBeam;

namespace
{
constexpr double rate = 24000;
constexpr Eigen::Index samples = 3000;
using Complex = std::complex<double>;

double at (const FreeDecay& decay, Complex logarithm, Eigen::Index n)
{
    const auto time = static_cast<double> (n);
    return ((decay.constant + decay.slope * time) * std::exp (logarithm * time)).real();
}

/** Sample by sample: while voltages drive the mode, and after. */
Eigen::VectorXd whole (const Histories& histories, Eigen::Index p, Complex logarithm)
{
    const auto driven = histories.driven.rows();
    Eigen::VectorXd all (samples);
    all.head (driven) = histories.driven.col (p);

    for (Eigen::Index n = driven; n < samples; ++n)
        all[n] = at (histories.after[static_cast<std::size_t> (p)], logarithm, n - driven);

    return all;
}
} // namespace

TEST_CASE ("Inner products of free decays are the sums over their samples", "[learning]")
{
    const auto [one, other] = GENERATE (table<Complex, Complex> ({
        { { -1e-3, 0.3 }, { -2e-4, 0.31 } },
        { { -1e-3, 0.3 }, { -1e-3, 0.3 } },
        { { 0, 0.3 }, { 0, 0.3 } },                                   // no damping
        { { -1e-9, std::numbers::pi }, { -1e-9, std::numbers::pi } }, // half of the sample rate
        { { -0.2, 1 }, { -1e-5, 1e-3 } },                             // gone at once; hardly begun
        { { -1e-4, 0.5 + 2 * std::numbers::pi }, { -1e-4, 0.5 } },    // above half of the sample rate
    }));
    const FreeDecay a { { 0.7, -0.4 }, { 1e-3, 2e-3 } }, b { { -0.2, 1.1 }, { -3e-3, 1e-3 } };
    double sum = 0, size = 0;

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        const auto product = at (a, one, n) * at (b, other, n);
        sum += product;
        size += std::abs (product);
    }

    CHECK (a.parts().dot (decayProducts (one, other, samples) * b.parts()) == Approx (sum).margin (1e-6 * size));
    CHECK (decayProducts (one, other, 0).isZero());
}

TEST_CASE ("Parts of free decays are their samples, without those that are silent", "[learning]")
{
    Eigen::VectorXcd logarithms (2);
    logarithms << Complex { -1e-3, 0.3 }, Complex { -0.2, 1 };
    const FreeDecay decay { { 0.7, -0.4 }, { 1e-3, 2e-3 } };
    Eigen::Index next = 0;
    forEachDecayPart (logarithms, samples,
                      [&] (const DecayPart& part)
                      {
                          REQUIRE (part.first == next);
                          // The second mode is gone after 115 samples.
                          REQUIRE (part.columns.size() == (part.first == 0 ? 8U : 4U));

                          for (Eigen::Index n = 0; n < part.basis.rows(); ++n)
                              CHECK (part.basis.row (n).head<4>().dot (decay.parts())
                                     == Approx (at (decay, logarithms[0], part.first + n)).margin (1e-9));

                          next += part.basis.rows();
                      });
    CHECK (next == samples);
}

TEST_CASE ("A mode that nothing drives goes on as it would be integrated", "[learning]")
{
    const auto model = sineBeam (5, 3);
    RandomNumbers random (5);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (model.actuators(), samples);

    for (Eigen::Index i = 0; i < voltages.rows(); ++i)
        voltages.row (i).head (200) = random.normal (200).transpose();

    const PlayedVoltages played (voltages, rate);
    REQUIRE (played.drivenSamples() < samples / 2);
    const auto all = driveModes (model, played, samples);
    const auto logarithms = decayLogarithms (model, rate);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const auto wanted = modeMotion (model.angularFrequencies[k], model.dampingRatios[k],
                                        played.force (model.participation.row (k)), rate, samples, true);
        CHECK ((whole (all.velocity, k, logarithms[k]) - wanted.velocity).norm() < 1e-9 * wanted.velocity.norm());
        CHECK ((whole (all.byFrequency, k, logarithms[k]) - wanted.byFrequency).norm()
               < 1e-7 * wanted.byFrequency.norm());
        CHECK ((whole (all.byDamping, k, logarithms[k]) - wanted.byDamping).norm() < 1e-7 * wanted.byDamping.norm());

        // What each ceramic does adds up to what all do.
        const auto each = drivenByEachCeramic (model, k, played, samples);
        Eigen::VectorXd sum = Eigen::VectorXd::Zero (samples);

        for (Eigen::Index i = 0; i < model.actuators(); ++i)
            sum += whole (each, i, logarithms[k]);

        CHECK ((sum - wanted.velocity).norm() < 1e-9 * wanted.velocity.norm());
    }
}
