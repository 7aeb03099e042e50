#include <antinode_measurement/SimulatedBench.h>

#include "MeasuredBeam.h"

#include <antinode_numerics/Fourier.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace antinode;

namespace
{
/** One period of the velocity after everything has settled: line by line from the closed form. */
Eigen::VectorXd settledPeriod (const Excitation& excitation, const ModalModel& model, Eigen::Index ceramic)
{
    Eigen::VectorXcd lines = forwardFourier (excitation.signal.segment (excitation.block, excitation.block));
    const Eigen::VectorXd frequencies =
        Eigen::VectorXd::NullaryExpr (lines.size(), [&] (Eigen::Index k) { return excitation.lineFrequency (k); });
    lines.array() *=
        excitation.settings.levels[ceramic]
        * test::closedForm (model, shapesAt (model, test::listeningPlace, 0), ceramic, frequencies).array();
    return inverseFourier (lines, excitation.block);
}
} // namespace

TEST_CASE ("the signal that a sensor should give is that of the settled modes", "[measurement]")
{
    const auto beam = test::benchBeam();
    auto settings = test::shortSettings (ExcitationSignal::multisine, beam.actuators());
    settings.periods = 12;
    settings.levels[1] = 5;
    const auto excitation = test::testExcitation (settings);
    const auto expected = expectedSignals (beam, shapesAt (beam, test::listeningPlace, 0), excitation);
    REQUIRE (std::ssize (expected) == beam.actuators());

    for (Eigen::Index ceramic = 0; ceramic < beam.actuators(); ++ceramic)
    {
        const auto settled = settledPeriod (excitation, beam, ceramic);
        const auto& signal = expected[static_cast<std::size_t> (ceramic)];
        // One of 13 periods contains the fading in; its transient may exceed the settled peak a little.
        CHECK (signal.effective
               == Approx (settled.norm() / std::sqrt (static_cast<double> (settled.size()))).epsilon (0.02));
        CHECK (signal.peak >= 0.999 * settled.cwiseAbs().maxCoeff());
        CHECK (signal.peak <= 1.3 * settled.cwiseAbs().maxCoeff());
    }
}

TEST_CASE ("the strongest resonances are the highest peaks of the closed form in the band", "[measurement]")
{
    const auto beam = test::benchBeam();
    const Eigen::RowVectorXd shapes = shapesAt (beam, test::listeningPlace, 0);
    const auto strongest = strongestResonances (beam, shapes, 200, 6000, 3);
    REQUIRE (strongest.size() == 3);
    const Eigen::VectorXd frequencies = Eigen::VectorXd::LinSpaced (580001, 200, 6000);
    double highest = 0;

    for (Eigen::Index ceramic = 0; ceramic < beam.actuators(); ++ceramic)
        highest = std::max (highest, test::closedForm (beam, shapes, ceramic, frequencies).cwiseAbs().maxCoeff());

    CHECK (strongest[0].response == Approx (highest).epsilon (1e-3));
    CHECK (strongest[0].response >= strongest[1].response);
    CHECK (strongest[1].response >= strongest[2].response);

    for (const auto& each : strongest)
    {
        CHECK (each.frequency >= 200);
        CHECK (each.response
               == Approx (std::abs (
                   test::closedForm (beam, shapes, each.ceramic, Eigen::VectorXd::Constant (1, each.frequency))[0])));
    }

    CHECK (strongestResonances (beam, shapes, 200, 6000, 99).size() < 99);
}

TEST_CASE ("an excitation needs the current of its steepest slope, and the limits say which level they allow",
           "[measurement]")
{
    auto beam = test::benchBeam();
    beam.ceramics[0].capacitance = 20e-9;
    beam.ceramics[0].slewLimit = 1e4;
    beam.ceramics[1].capacitance = 0;
    const auto excitation = test::testExcitation (test::shortSettings (ExcitationSignal::multisine, beam.actuators()));
    // The waveform at 16 times the rate, and its steepest step.
    const Eigen::VectorXd period = excitation.signal.segment (excitation.block, excitation.block);
    Eigen::VectorXcd wide = Eigen::VectorXcd::Zero (8 * period.size() + 1);
    wide.head (period.size() / 2 + 1) = 16 * forwardFourier (period);
    const auto fine = inverseFourier (wide, 16 * period.size());
    const auto steepest =
        (fine.tail (fine.size() - 1) - fine.head (fine.size() - 1)).cwiseAbs().maxCoeff() * 16 * 24000;
    const auto loads = excitationLoads (beam, excitation);
    REQUIRE (std::ssize (loads) == beam.actuators());
    CHECK (loads[0].slew == Approx (20 * steepest).epsilon (0.02));
    CHECK (loads[0].current == Approx (20e-9 * loads[0].slew));
    CHECK (loads[0].highestLevel == Approx (1e4 / steepest).epsilon (0.02));
    CHECK (loads[1].current == 0);
    CHECK (loads[1].highestLevel == 0);
}
