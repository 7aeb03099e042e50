#include "Support/AdaptiveOde.h"

#include <antinode_base/InputError.h>
#include <antinode_focus/ModeDrives.h>
#include <antinode_focus/Prediction.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double pi = std::numbers::pi;

struct Mode
{
    double frequency, damping;
    double omega() const { return 2 * pi * frequency; }
    double a() const { return damping * omega(); }
    double b() const { return omega() * std::sqrt (1 - damping * damping); }
    std::complex<double> pole() const { return { -a(), b() }; }
};

ModalModel makeModel (const std::vector<Mode>& modes)
{
    ModalModel model;
    const auto count = static_cast<Eigen::Index> (modes.size());
    model.angularFrequencies.resize (count);
    model.dampingRatios.resize (count);

    for (Eigen::Index k = 0; k < count; ++k)
    {
        model.angularFrequencies[k] = modes[static_cast<std::size_t> (k)].omega();
        model.dampingRatios[k] = modes[static_cast<std::size_t> (k)].damping;
    }

    model.participation = Eigen::MatrixXd::Identity (count, count);
    return model;
}

/** q and q' of a mode at `time` under oscillations, by the adaptive solution of the equation of motion itself. */
Eigen::Vector2d integrated (const Mode& mode, const std::vector<Oscillation>& oscillations, double time)
{
    std::vector<double> breaks;
    double first = time;

    for (const auto& oscillation : oscillations)
    {
        breaks.push_back (oscillation.start);
        breaks.push_back (oscillation.end);
        first = std::min (first, oscillation.start);
    }

    const auto force = [&] (double t)
    {
        double sum = 0;

        for (const auto& o : oscillations)
            if (t >= o.start && t < o.end)
                sum += std::exp (o.growth * (t - o.start))
                       * (o.inPhase * std::sin (o.angularFrequency * (t - o.start))
                          + o.quadrature * std::cos (o.angularFrequency * (t - o.start)));

        return sum;
    };
    const auto derivative = [&] (double t, const Eigen::VectorXd& y) -> Eigen::VectorXd
    { return Eigen::Vector2d (y[1], force (t) - 2 * mode.a() * y[1] - mode.omega() * mode.omega() * y[0]); };
    return test::integrateOde (derivative, Eigen::Vector2d::Zero(), first, time, 1e-12, breaks);
}

/** The closed form of the same. */
Eigen::Vector2d predicted (const Mode& mode, const std::vector<Oscillation>& oscillations, double time)
{
    std::complex<double> y = 0;

    for (const auto& oscillation : oscillations)
        y += modalResponse (mode.pole(), oscillation, time);

    return { y.imag() / mode.b(), y.real() - mode.a() / mode.b() * y.imag() };
}

void checkAgainstOde (const Mode& mode, const std::vector<Oscillation>& oscillations, double time, double velocityScale)
{
    const auto exact = integrated (mode, oscillations, time);
    const auto closed = predicted (mode, oscillations, time);
    CHECK (closed[1] == Approx (exact[1]).margin (1e-9 * velocityScale));
    CHECK (closed[0] * mode.omega() == Approx (exact[0] * mode.omega()).margin (1e-9 * velocityScale));
}
} // namespace

TEST_CASE ("Both drives bring their mode to velocity 1, for growth 0 to 50, as the equation of motion says to 1e-9",
           "[focus]")
{
    const Mode mode { 963, 1.0 / 120 };
    const Mode other { 1171, 1.0 / 90 };

    for (const auto kind : { DriveKind::offsetFree, DriveKind::paper })
        for (const auto growth : { 0.0, 1.0, 4.0, 20.0, 50.0 })
        {
            const auto drive = driveMode ({ 0, mode.a(), mode.b(), growth, 10 }, kind, 0.025);
            INFO ("growth " << growth << (kind == DriveKind::paper ? " paper" : " offset-free"));
            CHECK (drive.oscillations.front().start == Approx (0.025 - (pi / 2 + 20 * pi) / mode.b()));
            CHECK (predicted (mode, drive.oscillations, 0.025)[1] == Approx (1).epsilon (1e-9));
            checkAgainstOde (mode, drive.oscillations, 0.025, 1);
            checkAgainstOde (mode, drive.oscillations, 0.0191, 1);
            checkAgainstOde (mode, drive.oscillations, 0.031, 1);
            checkAgainstOde (other, drive.oscillations, 0.025, 1);
        }
}

TEST_CASE ("The paper's drive moves its mode as A e^{gamma a t} sin bt, paper (26)", "[focus]")
{
    const Mode mode { 3907, 1.0 / 94 };

    for (const auto growth : { 0.0, 4.0, 20.0 })
    {
        const auto drive = driveMode ({ 0, mode.a(), mode.b(), growth, 12 }, DriveKind::paper, 0.025);
        const auto start = drive.oscillations.front().start;
        const auto duration = 0.025 - start;

        for (const auto share : { 0.1, 0.37, 0.5, 0.93 })
        {
            const auto t = share * duration;
            const auto wanted = std::exp (growth * mode.a() * (t - duration)) * std::sin (mode.b() * t);
            CHECK (predicted (mode, drive.oscillations, start + t)[1] == Approx (wanted).margin (1e-12));
        }
    }
}

TEST_CASE ("The offset-free drive moves its mode as A (e^{gamma a t} - rho e^{-a t}) sin bt and has no constant",
           "[focus]")
{
    const Mode mode { 3907, 1.0 / 94 };
    const auto growth = 4.0;
    const auto drive = driveMode ({ 0, mode.a(), mode.b(), growth, 12 }, DriveKind::offsetFree, 0.025);
    REQUIRE (drive.oscillations.size() == 3); // itself and its release
    const auto duration = 0.025 - drive.oscillations.front().start;
    const auto rho = mode.omega() * mode.omega() / (growth * growth * mode.a() * mode.a() + mode.b() * mode.b());
    const auto envelope = [&] (double t) { return std::exp (growth * mode.a() * t) - rho * std::exp (-mode.a() * t); };

    for (const auto share : { 0.2, 0.61, 0.97 })
    {
        const auto t = share * duration;
        CHECK (predicted (mode, drive.oscillations, 0.025 - duration + t)[1]
               == Approx (envelope (t) / envelope (duration) * std::sin (mode.b() * t)).margin (1e-12));
    }

    // No step: the force begins at (1 - rho) of its scale, here 2e-3, and not at the paper's constant.
    const auto paper = driveMode ({ 0, mode.a(), mode.b(), growth, 12 }, DriveKind::paper, 0.025);
    REQUIRE (paper.oscillations.size() == 6); // the oscillation, the constant, two parts of release for each
    CHECK (paper.oscillations[1].angularFrequency == 0);
    CHECK (std::abs (drive.oscillations[0].quadrature) < 0.03 * std::abs (drive.oscillations[0].inPhase));
}

TEST_CASE ("The release goes on from the drive without a step in value or slope and ends at nothing", "[focus]")
{
    const Mode mode { 5719, 1.0 / 126 };

    for (const auto kind : { DriveKind::offsetFree, DriveKind::paper })
        for (const auto growth : { 0.0, 4.0, 20.0 })
        {
            const auto drive = driveMode ({ 0, mode.a(), mode.b(), growth, 20 }, kind, 0.025);
            const auto value = [&] (double time)
            {
                double sum = 0;

                for (const auto& oscillation : drive.oscillations)
                    sum += oscillationValue (oscillation, time);

                return sum;
            };
            constexpr double step = 1e-9;
            const auto scale = std::abs (value (0.025));
            CHECK (value (0.025) == Approx (value (0.025 - 1e-13)).margin (1e-6 * scale));
            const auto before = (value (0.025 - step) - value (0.025 - 2 * step)) / step;
            const auto after = (value (0.025 + 2 * step) - value (0.025 + step)) / step;
            CHECK (after == Approx (before).margin (1e-3 * mode.b() * scale));
            CHECK (std::abs (value (0.025 + 0.999 * releaseDuration())) < 1e-5 * scale);
        }
}

TEST_CASE ("The closed form stays exact where the drive's exponent meets the pole", "[focus]")
{
    const Mode mode { 500, 0.01 };

    for (const auto distance : { 0.0, 1e-9, 1e-4, 0.3, 30.0 })
    {
        const Oscillation oscillation { 0, 0.001, 0.021, -mode.a() + distance, mode.b(), 0.7, -0.3 };
        checkAgainstOde (mode, { oscillation }, 0.021, 0.02);
        checkAgainstOde (mode, { oscillation }, 0.013, 0.02);
    }
}

TEST_CASE ("Held samples: the closed sum is the exact answer to the staircase, to 1e-11", "[focus]")
{
    const Mode mode { 5719, 1.0 / 126 };
    const auto rate = 96000.0;
    const auto focus = 0.01;
    const auto drive = driveMode ({ 0, mode.a(), mode.b(), 1.5, 30 }, DriveKind::offsetFree, focus);
    const auto& oscillation = drive.oscillations.front();
    std::complex<double> y = 0;
    const auto step = std::exp (mode.pole() / rate);
    const auto held = (step - 1.0) / mode.pole();

    for (int n = -2000; n < 0; ++n)
        y = step * y + held * oscillationValue (oscillation, focus + n / rate);

    const auto closed = heldModalResponse (mode.pole(), oscillation, focus, rate);
    CHECK (closed.real() == Approx (y.real()).margin (1e-11));
    CHECK (closed.imag() == Approx (y.imag()).margin (1e-11));
    // Held samples lag by half a sample: the difference to the continuous drive is that of first order.
    CHECK (std::abs (closed - modalResponse (mode.pole(), oscillation, focus)) > 1e-2);
}

TEST_CASE ("Growth and cycles that are not given are chosen: one envelope rate of 4 / t_f, as many cycles as fit",
           "[focus]")
{
    const std::vector<Mode> modes { { 420, 1.0 / 380 }, { 957, 1.0 / 120 }, { 10733, 1.0 / 120 } };
    const auto model = makeModel (modes);
    const auto drives = driveModes (model, { 0, 1, 2 }, 0.025, {});

    for (std::size_t k = 0; k < 3; ++k)
    {
        CHECK (drives[k].growth * modes[k].a() == Approx (4 / 0.025));
        const auto duration = 0.025 - drives[k].oscillations.front().start;
        CHECK (duration <= 0.025 * (1 + 1e-12));
        CHECK (duration + 2 * pi / modes[k].b() > 0.025);
    }
}

TEST_CASE ("What cannot be driven is said in one sentence", "[focus]")
{
    const auto model = makeModel ({ { 420, 0.004 }, { 957, 0.004 } });
    CHECK_THROWS_WITH (driveModes (model, { 0, 1 }, 0.0001, {}),
                       Catch::Contains ("focus: focus time: leaves 0.1 ms")
                           && Catch::Contains ("needs a quarter period; allowed: at least "));
    CHECK_THROWS_WITH (driveModes (model, { 0, 1 }, 0.025, { DriveKind::paper, {}, { 100 }, {}, {} }),
                       Catch::Contains ("allowed: 0 to 10"));
    CHECK_THROWS_WITH (
        driveModes (model, { 0, 1 }, 0.025, { DriveKind::paper, { 1, 2, 3 }, {}, {}, {} }),
        Catch::Contains ("has 3 values, but 2 modes are controlled; allowed: one value, or one per mode"));
}

TEST_CASE ("A growth of a thousand still gives a finite drive that arrives", "[focus]")
{
    const std::vector<Mode> modes { { 420, 0.02 }, { 20000, 0.02 } };
    const auto drives =
        driveModes (makeModel (modes), { 0, 1 }, 0.025, { DriveKind::offsetFree, { 1000 }, {}, {}, {} });

    for (std::size_t k = 0; k < 2; ++k)
        CHECK (predicted (modes[k], drives[k].oscillations, 0.025)[1] == Approx (1).epsilon (1e-9));
}
