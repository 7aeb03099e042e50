#include "Support/ErrorText.h"
#include "Support/SineBeam.h"

#include <antinode_documents/SkinThresholds.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FreeWaveform.h>
#include <antinode_focus/Prediction.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>

using namespace antinode;

namespace
{
constexpr Playback atInterface { Reconstruction::bandLimited, 48000 };
constexpr Playback generator { Reconstruction::zeroOrderHold, 48000 };
constexpr double bystander = -0.06; // m

ModalModel quietBeam()
{
    return test::sineBeam (12, 8);
}

FocusDescription quietFocus (double weight, FeltAt at = FeltAt::places)
{
    FocusDescription focus;
    focus.targets = { { TargetShape::sinc, 0.02, 0, 0.04, 0.04, 1 } };
    focus.focusTime = 0.015;
    focus.modes.count = 5;
    focus.allocation.method = AllocationMethod::leastVoltage;
    focus.allocation.timesBound = upToLimits;
    focus.allocation.voltageLimit = 1000;
    focus.felt = FeltChoice { at, {}, weight, 0.01 };
    focus.threshold = findSkinThreshold ({});

    if (at == FeltAt::places)
        focus.felt->places = { { bystander, 0 } };

    return focus;
}

FreeWaveform madeWith (const ModalModel& model, const FocusDescription& focus, Playback playback = atInterface)
{
    const auto design = designFocus (model, focus, playback, DesignExtent::compared);
    return freeWaveform (model, focus, design.controlledModes, design.moments.front().wanted,
                         Eigen::VectorXd::Constant (model.actuators(), *focus.allocation.voltageLimit), playback);
}

/** Displacements of places under samples, by Newmark's rule at the rate of the samples, one place a row. */
Eigen::MatrixXd displacements (const ModalModel& model, const SampledVoltages& voltages, const std::vector<double>& x)
{
    constexpr double ringing = 0.6; // s
    const auto rate = voltages.playback.sampleRate, h = 1 / rate;
    const auto count = voltages.values.cols() + static_cast<Eigen::Index> (ringing * rate);
    Eigen::MatrixXd moved = Eigen::MatrixXd::Zero (static_cast<Eigen::Index> (x.size()), count);

    for (Eigen::Index k = 0; k < model.modes(); ++k)
    {
        const auto w = model.angularFrequencies[k], c = 2 * model.dampingRatios[k] * w;
        double q = 0, v = 0, a = 0;
        Eigen::VectorXd history (count);

        for (Eigen::Index n = 0; n < count; ++n)
        {
            const auto force =
                n < voltages.values.cols() ? model.participation.row (k).dot (voltages.values.col (n)) : 0.0;
            const auto next = (force - c * (v + h / 2 * a) - w * w * (q + h * v + h * h / 4 * a))
                              / (1 + c * h / 2 + w * w * h * h / 4);
            q += h * v + h * h / 4 * (a + next);
            v += h / 2 * (a + next);
            a = next;
            history[n] = q;
        }

        for (std::size_t i = 0; i < x.size(); ++i)
            moved.row (static_cast<Eigen::Index> (i)) += shapesAt (model, x[i], 0)[k] * history.transpose();
    }

    return moved;
}

/** The energy of displacements in thresholds, summed line by line from 30 to 1400 Hz, s. */
double weightedEnergy (const Eigen::MatrixXd& moved, double rate)
{
    constexpr double step = 1.5;
    const auto threshold = findSkinThreshold ({});
    double sum = 0;

    for (double f = 30; f < 1400; f += step)
        for (Eigen::Index i = 0; i < moved.rows(); ++i)
        {
            const auto turn = std::polar (1.0, -2 * std::numbers::pi * f / rate);
            std::complex<double> line = 0, phasor = 1 / rate;

            for (const auto value : moved.row (i))
            {
                line += value * phasor;
                phasor *= turn;
            }

            sum += 2 * step * std::norm (line / thresholdAt (threshold, f));
        }

    return sum / static_cast<double> (moved.rows());
}

double feltAtBystander (const ModalModel& model, const SampledVoltages& voltages)
{
    return weightedEnergy (displacements (model, voltages, { bystander }), voltages.playback.sampleRate);
}

double decibels (double ratio)
{
    return 10 * std::log10 (ratio);
}
} // namespace

TEST_CASE ("With less felt elsewhere every controlled mode still has its velocity, played by the plate model",
           "[freeWaveform][felt]")
{
    const auto model = quietBeam();

    for (const auto playback : { atInterface, generator })
    {
        const auto design = designFocus (model, quietFocus (30), playback);
        RenderSettings settings;
        settings.playback = playback;
        settings.duration = 0.03;
        settings.probeShapes.resize (0, model.modes());
        const auto render = renderOffline (model, design.program, settings);
        const auto closed = modalVelocities (model, predictStates (model, design.program, design.program.focusTime));
        const auto largest = design.target.modalVelocities.cwiseAbs().maxCoeff();
        CHECK (design.certificate.rowResidual < 1e-9);

        for (const auto mode : design.controlledModes)
        {
            CHECK (closed[mode] == Approx (design.target.modalVelocities[mode]).margin (1e-8 * largest));
            CHECK (render.focusVelocities[mode]
                   == Approx (design.target.modalVelocities[mode]).margin (1e-8 * largest));
        }
    }
}

TEST_CASE ("What is felt at a bystander falls by what the design says, integrated step by step", "[freeWaveform][felt]")
{
    const auto model = quietBeam();
    const auto plain = madeWith (model, quietFocus (0)), quiet = madeWith (model, quietFocus (10));
    const auto gain = decibels (feltAtBystander (model, plain.voltages) / feltAtBystander (model, quiet.voltages));
    CHECK (plain.felt->gain == Approx (0).margin (1e-9));
    CHECK (quiet.felt->gain > 3);
    CHECK (quiet.felt->share == 1);
    CHECK (quiet.felt->residual < 1e-3);
    CHECK (gain == Approx (quiet.felt->gain).margin (0.2));
    CHECK (quiet.felt->plainPeak == Approx (plain.voltages.values.cwiseAbs().maxCoeff()));
}

TEST_CASE ("Each weight has the least sum of volts and what is felt, against the designs of other weights",
           "[freeWaveform][felt]")
{
    const auto model = quietBeam();
    const std::vector weights { 0.0, 1.0, 10.0, 100.0 };
    std::vector<double> energies, felts;

    for (const auto weight : weights)
    {
        const auto made = madeWith (model, quietFocus (weight));
        energies.push_back (made.voltages.values.squaredNorm());
        felts.push_back (feltAtBystander (model, made.voltages));
    }

    for (std::size_t i = 0; i < weights.size(); ++i)
        for (std::size_t j = 0; j < weights.size(); ++j)
        {
            const auto sum = [&] (std::size_t of)
            { return energies[of] / energies[0] + weights[i] * felts[of] / felts[0]; };
            CHECK (sum (i) <= 1.005 * sum (j));
        }

    for (std::size_t i = 1; i < weights.size(); ++i)
    {
        CHECK (felts[i] < felts[i - 1]);
        CHECK (energies[i] > energies[i - 1]);
    }
}

TEST_CASE ("Less is felt everywhere farther than 30 mm from the target, on average", "[freeWaveform][felt]")
{
    const auto model = quietBeam();
    std::vector<double> far;

    for (double x = -0.098; x < 0.1; x += 0.014)
        if (std::abs (x - 0.02) > feltNeighbourhood)
            far.push_back (x);

    const auto energy = [&] (const FreeWaveform& made)
    { return weightedEnergy (displacements (model, made.voltages, far), made.voltages.playback.sampleRate); };
    const auto plain = madeWith (model, quietFocus (0, FeltAt::everywhere));
    const auto quiet = madeWith (model, quietFocus (10, FeltAt::everywhere));
    CHECK (quiet.felt->gain > 1);
    CHECK (decibels (energy (plain) / energy (quiet)) == Approx (quiet.felt->gain).margin (0.4));
}

TEST_CASE ("Limits are kept at the cost of what is felt elsewhere, and it is said", "[freeWaveform][felt]")
{
    const auto model = quietBeam();
    auto focus = quietFocus (100);
    const auto free = designFocus (model, focus, atInterface);
    const auto plain = madeWith (model, quietFocus (0)).felt->plainPeak;
    const auto limit = 0.5 * (plain + peakVoltage (free));
    REQUIRE (limit > plain);
    focus.allocation.voltageLimit = limit;
    const auto limited = madeWith (model, focus);
    CHECK (limited.voltages.values.cwiseAbs().maxCoeff() <= limit * (1 + 1e-12));
    CHECK (limited.felt->share == 1);
    CHECK (limited.felt->weight < 100);
    CHECK (limited.felt->gain > 0);
    CHECK (limited.felt->gain == Approx (madeWith (model, quietFocus (limited.felt->weight)).felt->gain));
    CHECK (limited.certificate.rowResidual < 1e-9);
    const auto design = designFocus (model, focus, atInterface);
    REQUIRE (! design.warnings.empty());
    CHECK_THAT (design.warnings.front(), Catch::Contains ("allows the weight"));
    focus.allocation.voltageLimit = 1.0001 * plain;
    const auto tight = madeWith (model, focus);
    CHECK (tight.voltages.values.cwiseAbs().maxCoeff() <= 1.0001 * plain * (1 + 1e-12));
    CHECK (tight.felt->gain >= 0);
}

TEST_CASE ("Places that are not there are refused", "[freeWaveform][felt]")
{
    const auto model = quietBeam();
    auto focus = quietFocus (1);
    focus.felt->places = { { 0.5, 0 } };
    CHECK_THROWS_AS (madeWith (model, focus), InputError);
    CHECK_THAT (errorText ([&] { madeWith (model, quietFocus (1, FeltAt::fingers)); }),
                Catch::Contains ("there are none"));
}
