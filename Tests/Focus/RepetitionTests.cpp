#include "Support/SineBeam.h"

#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/Prediction.h>
#include <antinode_focus/Repetition.h>

#include <catch2/catch.hpp>

using namespace antinode;

namespace
{
FocusDescription repeatedFocus (std::optional<double> brakeDuration, double limit = 150)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.025, 0.04, 1 } };
    focus.focusTime = 0.025;
    focus.modes.count = 6;
    focus.allocation.voltageLimit = limit;
    focus.transients.brakeDuration = brakeDuration;
    return focus;
}

/** One program after the other. */
VoltageProgram repeated (const VoltageProgram& program, double period, int count)
{
    auto all = program;

    for (int n = 1; n < count; ++n)
    {
        for (auto oscillation : program.oscillations)
        {
            oscillation.start += n * period;
            oscillation.end += n * period;
            all.oscillations.push_back (oscillation);
        }
    }

    all.allocation = program.allocation.replicate (1, count);
    return all;
}

/** What the others leave at the worst focus of a train, of the peak: the velocity, or its amplitude whatever its phase.
 */
double loss (const ModalModel& model, const VoltageProgram& program, double period, bool isAmplitude)
{
    constexpr int count = 12;
    const auto train = repeated (program, period, count);
    const auto alone = predictStates (model, program, program.focusTime);
    const Eigen::VectorXd ratio = decayRates (model).cwiseQuotient (dampedFrequencies (model));
    const auto field = [&] (const Eigen::VectorXcd& states)
    {
        Eigen::VectorXcd velocities = states;

        for (Eigen::Index k = 0; k < states.size(); ++k)
            velocities[k] *= std::complex<double> (1, ratio[k]);

        return Eigen::VectorXcd (model.shapes * velocities);
    };
    double worst = 0;

    for (int n = 0; n < count; ++n)
    {
        const Eigen::VectorXcd others = field (predictStates (model, train, program.focusTime + n * period) - alone);
        worst = std::max (worst, isAmplitude ? others.cwiseAbs().maxCoeff() : others.real().cwiseAbs().maxCoeff());
    }

    return worst / field (alone).real().cwiseAbs().maxCoeff();
}

double highestVoltage (const VoltageProgram& program, double from, double to)
{
    double highest = 0;

    for (auto t = from; t < to; t += 1e-5)
    {
        Eigen::VectorXd values (static_cast<Eigen::Index> (program.oscillations.size()));

        for (Eigen::Index c = 0; c < values.size(); ++c)
            values[c] = oscillationValue (program.oscillations[static_cast<std::size_t> (c)], t);

        highest = std::max (highest, (program.allocation * values).cwiseAbs().maxCoeff());
    }

    return highest;
}
} // namespace

TEST_CASE ("The motion of a program at any time is what the closed forms say one by one", "[focus][repetition]")
{
    const auto model = test::sineBeam (12, 6);
    const auto design = designFocus (model, repeatedFocus (0.01), {}, DesignExtent::playable);
    const ProgramMotion motion (model, design.program);
    const auto largest = predictStates (model, design.program, 0.025).cwiseAbs().maxCoeff();

    for (const auto time : { -0.001, 0.0, 0.003, 0.0249, 0.025, 0.0251, 0.0257, 0.03, 0.0349, 0.035, 0.1 })
        CHECK ((motion.statesAt (time) - predictStates (model, design.program, time)).cwiseAbs().maxCoeff()
               < 1e-10 * largest);
}

TEST_CASE ("A resonant oscillation is no singular motion", "[focus][repetition]")
{
    const auto model = test::sineBeam (3, 2);
    VoltageProgram program;
    program.oscillations = { { 0, 0, 0.05, -decayRates (model)[0], dampedFrequencies (model)[0], 1, 0.5 } };
    program.allocation = Eigen::Vector2d (1, 0.3);
    program.voltageLimits = Eigen::Vector2d (10, 10);
    const ProgramMotion motion (model, program);

    for (const auto time : { 0.02, 0.05, 0.07 })
    {
        const auto exact = predictStates (model, program, time);
        CHECK ((motion.statesAt (time) - exact).cwiseAbs().maxCoeff() < 1e-6 * exact.cwiseAbs().maxCoeff());
    }
}

TEST_CASE ("At the shortest period a simulated train loses at most 1 % at every focus, just below it more",
           "[focus][repetition]")
{
    for (const auto quality : { 60.0, 200.0 })
        for (const auto duration : { std::optional<double>(), std::optional<double> (0.015) })
        {
            const auto model = test::sineBeam (12, 6, quality);
            const auto design = designFocus (model, repeatedFocus (duration), {});
            REQUIRE (design.shortestPeriod.has_value());
            const auto period = *design.shortestPeriod;
            CAPTURE (quality, period);
            CHECK (loss (model, design.program, period, false) <= repetitionLoss);
            CHECK (loss (model, design.program, period, true) <= 1.001 * repetitionLoss);

            // An eighth of the highest mode's period is what it is exact to.
            const auto step = 2 * std::numbers::pi / dampedFrequencies (model)[design.controlledModes.back()] / 8;
            CHECK (loss (model, design.program, period - 1.001 * step, true) > 0.99 * repetitionLoss);

            for (const auto longer : { 1.01, 1.07, 1.3, 2.1 })
                CHECK (loss (model, design.program, longer * period, false) <= repetitionLoss);
        }
}

TEST_CASE ("Brakes let foci follow one another much sooner", "[focus][repetition]")
{
    const auto model = test::sineBeam (12, 6, 200);
    const auto free = *designFocus (model, repeatedFocus ({}), {}).shortestPeriod;
    const auto braked = *designFocus (model, repeatedFocus (0.015), {}).shortestPeriod;
    CHECK (braked < 0.04);
    CHECK (free > 5 * braked);
}

TEST_CASE ("Voltages of overlapping repeats keep the limits, which may take a longer period", "[focus][repetition]")
{
    const auto model = test::sineBeam (12, 6, 200);
    const auto wide = designFocus (model, repeatedFocus (0.015), {});
    auto tight = wide.program;
    tight.voltageLimits.setConstant (1.001 * highestVoltage (wide.program, 0, 0.05));
    const auto period = *shortestPeriod (model, tight, { 0.025 });
    CHECK (period >= *wide.shortestPeriod);
    CHECK (highestVoltage (repeated (tight, period, 5), 0, 0.05 + 4 * period) <= 1.001 * tight.voltageLimits[0]);
}
