#include <antinode_documents/Inputs.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_render/PowerFlow.h>
#include <antinode_render/RenderedFocus.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace antinode;

namespace
{
constexpr Playback interface {
    Reconstruction::bandLimited, 192000
};

/** What the energies of an event come out as when its continuous voltages, not their samples, drive every mode through
   Runge and Kutta's steps, 16 for each sample, and charges are differences from step to step. */
struct FineBalance
{
    double in = 0, drawn = 0, mechanicalLoss = 0, motionAtEnd = 0, peakMotion = 0, peakCurrent = 0;
};

Eigen::VectorXd continuousVoltages (const VoltageProgram& program, double time)
{
    Eigen::VectorXd values (std::ssize (program.oscillations));

    for (Eigen::Index c = 0; c < values.size(); ++c)
    {
        const auto& one = program.oscillations[static_cast<std::size_t> (c)];
        const auto tau = time - one.start;
        const auto angle = one.angularFrequency * tau;
        values[c] =
            time < one.start || time >= one.end
                ? 0.0
                : std::exp (one.growth * tau) * (one.inPhase * std::sin (angle) + one.quadrature * std::cos (angle));
    }

    return program.allocation * values;
}

/** Whether a drive begins or ends: its voltage then jumps a little, which samples make smooth. */
bool jumpsWithin (const VoltageProgram& program, double from, double to)
{
    return std::any_of (program.oscillations.begin(), program.oscillations.end(),
                        [&] (const Oscillation& one)
                        { return (one.start >= from && one.start <= to) || (one.end >= from && one.end <= to); });
}

FineBalance fineBalance (const ModalModel& model, const VoltageProgram& program, double duration)
{
    const auto step = 1 / (16 * interface.sampleRate);
    const auto steps = static_cast<int> (duration / step);
    const Eigen::ArrayXd square = model.angularFrequencies.array().square();
    const Eigen::ArrayXd damping = 2 * model.dampingRatios.array() * model.angularFrequencies.array();
    const Eigen::ArrayXXd alpha = model.participation.array();
    const Eigen::VectorXd modal = (alpha.square().colwise() / square).colwise().sum().transpose();
    Eigen::VectorXd capacitance (model.actuators());

    for (Eigen::Index i = 0; i < capacitance.size(); ++i)
        capacitance[i] = model.ceramics[static_cast<std::size_t> (i)].capacitance - modal[i];

    Eigen::ArrayXd q = Eigen::ArrayXd::Zero (model.modes()), v = q;
    Eigen::VectorXd before = continuousVoltages (program, 0);
    Eigen::VectorXd charge = capacitance.cwiseProduct (before);
    FineBalance sums;

    for (int n = 0; n < steps; ++n)
    {
        const auto time = n * step;
        const Eigen::VectorXd middle = continuousVoltages (program, time + step / 2);
        const Eigen::VectorXd after = continuousVoltages (program, time + step);
        const Eigen::ArrayXd f0 = model.participation * before, f1 = model.participation * middle,
                             f2 = model.participation * after;
        const auto slope = [&] (const Eigen::ArrayXd& place, const Eigen::ArrayXd& speed, const Eigen::ArrayXd& force)
        { return Eigen::ArrayXd (force - damping * speed - square * place); };
        const Eigen::ArrayXd a1 = slope (q, v, f0), v2 = v + step / 2 * a1, a2 = slope (q + step / 2 * v, v2, f1),
                             v3 = v + step / 2 * a2, a3 = slope (q + step / 2 * v2, v3, f1), v4 = v + step * a3,
                             a4 = slope (q + step * v3, v4, f2);
        sums.mechanicalLoss += step * (damping * v2 * v2).sum();
        q += step / 6 * (v + 2 * v2 + 2 * v3 + v4);
        v += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        const Eigen::VectorXd chargeAfter =
            capacitance.cwiseProduct (after) + model.participation.transpose() * q.matrix();
        const Eigen::ArrayXd taken = 0.5 * (before + after).array() * (chargeAfter - charge).array();
        sums.in += taken.sum();
        sums.drawn += taken.max (0).sum();

        if (! jumpsWithin (program, time, time + step))
            sums.peakCurrent = std::max (sums.peakCurrent, (chargeAfter - charge).cwiseAbs().maxCoeff() / step);

        charge = chargeAfter;
        before = after;
        sums.motionAtEnd = 0.5 * (v.square() + square * q.square()).sum();
        sums.peakMotion = std::max (sums.peakMotion, sums.motionAtEnd);
    }

    return sums;
}

void checkBalance (const std::string& device, const std::string& focusName, double duration)
{
    auto model = solveStructure (loadDevice (device, {}));

    for (auto& ceramic : model.ceramics)
        ceramic.lossFactor = 0; // Currents that depend on the whole past have no place in steps.

    RenderOptions options;
    options.playback = interface;
    options.duration = duration;
    options.repetitions = 10;
    const auto focus =
        renderFocus (model, designFocus (model, loadFocus (focusName, {}), interface, DesignExtent::playable), options);
    const auto& once = focus.power->once;
    const auto fine = fineBalance (model, focus.design.program, duration);
    CAPTURE (device, once.electricalIn(), fine.in, once.drawn(), fine.drawn, once.mechanicalLoss, fine.mechanicalLoss,
             once.motionAtEnd, fine.motionAtEnd, once.imbalance());

    CHECK (std::abs (fine.in - fine.mechanicalLoss - fine.motionAtEnd) < 1e-3 * fine.in);
    CHECK (once.electricalIn() == Approx (fine.in).epsilon (0.01));
    CHECK (once.drawn() == Approx (fine.drawn).epsilon (0.01));
    CHECK (once.mechanicalLoss == Approx (fine.mechanicalLoss).epsilon (0.01));
    CHECK (once.motionAtEnd == Approx (fine.motionAtEnd).epsilon (0.01));
    CHECK (once.peakMotion == Approx (fine.peakMotion).epsilon (0.01));
    CHECK (std::abs (once.imbalance()) < 0.01);

    double largest = 0;

    for (const auto& ceramic : once.ceramics)
        largest = std::max (largest, ceramic.peakCurrent);

    CHECK (largest == Approx (fine.peakCurrent).epsilon (0.02)); // Between the samples there is a little more.
}

/** A ceramic of 10 nF on a body with one mode that it hardly moves. */
ModalModel capacitor()
{
    ModalModel model;
    model.angularFrequencies = Eigen::VectorXd::Constant (1, 2 * std::numbers::pi * 500);
    model.dampingRatios = Eigen::VectorXd::Constant (1, 0.01);
    model.participation = Eigen::MatrixXd::Constant (1, 1, 1e-9);
    model.shapes = Eigen::MatrixXd::Ones (1, 1);
    Ceramic ceramic;
    ceramic.name = "C1";
    ceramic.voltageLimit = 100;
    ceramic.capacitance = 10e-9;
    ceramic.lossFactor = 0.03;
    ceramic.area = 1e-4;
    model.ceramics = { ceramic };
    return model;
}

/** 200 cycles of 4 kHz with smooth ends. */
Eigen::MatrixXd burst (double amplitude)
{
    constexpr int samples = 9600, ramp = 480;
    Eigen::MatrixXd voltages (1, samples);

    for (int n = 0; n < samples; ++n)
    {
        const auto end =
            std::min ({ 1.0, static_cast<double> (n) / ramp, static_cast<double> (samples - 1 - n) / ramp });
        voltages (0, n) = amplitude * std::pow (std::sin (std::numbers::pi / 2 * end), 2)
                          * std::sin (2 * std::numbers::pi * 4000 * n / interface.sampleRate);
    }

    return voltages;
}
} // namespace

TEST_CASE ("The energies of a rendered focus agree with a finer integration of charge and motion, to 1 %", "[power]")
{
    checkBalance ("beam", "demonstrator", 0.05);
    checkBalance ("staple", "demonstrator", 0.05);
    checkBalance ("aluminium-200x120", "aluminium-centre", 0.04);
}

TEST_CASE ("With dielectric loss, energy in is what is stored and lost, to 1 %, from an interface and a generator",
           "[power]")
{
    for (const auto* const device : { "beam", "staple", "aluminium-200x120" })
        for (const auto reconstruction : { Reconstruction::bandLimited, Reconstruction::zeroOrderHold })
        {
            const auto model = solveStructure (loadDevice (device, {}));
            RenderOptions options;
            options.playback = { reconstruction, 192000 };
            options.repetitions = 10;
            const auto name = model.surface.kind == SurfaceKind::line ? "demonstrator" : "aluminium-centre";
            const auto focus = renderFocus (
                model, designFocus (model, loadFocus (name, {}), options.playback, DesignExtent::playable), options);
            const auto& once = focus.power->once;
            CAPTURE (device, once.imbalance());
            CHECK (once.dielectricLoss() > 0);
            CHECK (std::abs (once.imbalance()) < 0.01);
        }
}

TEST_CASE ("A ceramic alone takes 2 pi f C U, loses pi C U^2 tan delta per cycle and gives the rest back", "[power]")
{
    const auto model = capacitor();
    const auto flow = powerFlow (model, burst (50), interface);
    const auto& ceramic = flow.ceramics[0];
    const auto omega = 2 * std::numbers::pi * 4000;
    CHECK (ceramic.peakVoltage == Approx (50).epsilon (1e-3));
    CHECK (ceramic.peakSlew == Approx (omega * 50).epsilon (1e-3));
    CHECK (ceramic.peakCurrent == Approx (omega * 10e-9 * 50).epsilon (1e-3));
    CHECK (ceramic.peakCharge == Approx (10e-9 * 50).epsilon (1e-3));
    // sin^2 ramps hold 3/8 of their time: 200 - 20 cycles whole, 20 by 3/8.
    const auto cycles = 180 + 20 * 0.375;
    CHECK (ceramic.dielectricLoss == Approx (cycles * std::numbers::pi * 10e-9 * 2500 * 0.03).epsilon (2e-3));
    // Two charges and two discharges of C U^2 / 2 in a cycle, and half of the loss on either side of zero.
    CHECK (ceramic.drawn == Approx (cycles * 10e-9 * 2500 + ceramic.dielectricLoss / 2).epsilon (5e-3));
    CHECK (ceramic.drawn - ceramic.returned == Approx (ceramic.dielectricLoss).epsilon (1e-3));
    CHECK (flow.duration == Approx (0.05).epsilon (1e-3));

    const auto repeated = repeatedPower (model, flow, 10);
    const auto playing = cycles / 4000; // s of full amplitude per repetition
    CHECK (repeated.ceramics[0].rmsVoltage == Approx (50 * std::sqrt (5 * playing)).epsilon (1e-3));
    CHECK (repeated.ceramics[0].rmsCurrent == Approx (omega * 10e-9 * 50 * std::sqrt (5 * playing)).epsilon (2e-3));
    CHECK (repeated.reactivePower == Approx (omega * 10e-9 * 2500 * 5 * playing).epsilon (3e-3));
    CHECK (repeated.realPower == Approx (0.03 * repeated.reactivePower).epsilon (3e-3));
    CHECK (repeated.ceramics[0].warming == Approx (repeated.realPower / (10 * 1e-4)).epsilon (1e-2));
    // The mean of |sin| is 2/pi; ramps of sin^2 have a mean of 1/2.
    CHECK (repeated.linear.supply
           == Approx (10 * 100 * omega * 10e-9 * 50 * 2 / std::numbers::pi * 190 / 4000).epsilon (5e-3));
    CHECK (repeated.switching.heat
           == Approx (10 * (ceramic.drawn / 0.9 - 0.9 * ceramic.returned) - repeated.realPower).epsilon (1e-9));
    CHECK (repeated.charge.supply == Approx (1.1 * repeated.linear.supply));
    CHECK_FALSE (repeated.overlaps);
    CHECK (repeatedPower (model, flow, 21).overlaps);
}

TEST_CASE ("A slow voltage charges the whole capacitance, held part and modes together", "[power]")
{
    auto model = capacitor();
    model.angularFrequencies[0] = 2 * std::numbers::pi * 20000;
    model.participation (0, 0) = model.angularFrequencies[0] * std::sqrt (4e-9); // 4 of the 10 nF
    model.ceramics[0].lossFactor = 0;
    Eigen::MatrixXd voltages (1, 19200);

    for (int n = 0; n < 19200; ++n)
        voltages (0, n) = 50 * std::pow (std::sin (std::numbers::pi * n / 19199.0), 2);

    CHECK (powerFlow (model, voltages, interface).ceramics[0].peakCharge == Approx (10e-9 * 50).epsilon (1e-4));
    model.ceramics[0].capacitance = 3e-9;
    CHECK_THROWS_WITH (powerFlow (model, voltages, interface), Catch::Contains ("3 nF") && Catch::Contains ("4 nF"));
    model.ceramics[0].capacitance = 0;
    CHECK (focusPower (model, voltages, interface, 10).obstacle.find ("capacitance of ceramic 'C1'")
           != std::string::npos);
}
