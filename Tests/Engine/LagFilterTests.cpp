#include "Support/ErrorText.h"
#include "Support/SineBeam.h"

#include <antinode_engine/LagFilters.h>
#include <antinode_engine/OfflineRender.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_measurement/Amplifier.h>
#include <antinode_numerics/Fourier.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>

using namespace antinode;

namespace
{
constexpr double lagRate = 96000;
constexpr double turn = 2 * std::numbers::pi;
constexpr Playback lagPlayback { Reconstruction::bandLimited, lagRate };
using Complex = std::complex<double>;

/** A beam whose modes go from 0.1 to 7.4 kHz, with these lags. */
ModalModel beamThatLags (const std::vector<InputLag>& lags)
{
    auto model = test::sineBeam (8, static_cast<int> (lags.size()));

    for (std::size_t i = 0; i < lags.size(); ++i)
        model.ceramics[i].lag = lags[i];

    return model;
}

/** What a filter makes of a frequency, in Hz. */
Complex responseOf (const LagFilters& filters, Eigen::Index ceramic, double frequency)
{
    Complex sum = 0;
    const auto start = filters.starts[static_cast<std::size_t> (ceramic)];

    for (Eigen::Index n = 0; n < filters.taps.rows(); ++n)
        sum += filters.taps (filters.taps.rows() - 1 - n, ceramic)
               * std::polar (1.0, -turn * frequency / lagRate * static_cast<double> (n + start));

    return sum;
}

/** What a ceramic does of a voltage, by the definition of its lag. */
Complex lagResponse (const InputLag& lag, double frequency)
{
    const auto omega = turn * frequency;
    return std::polar (1.0, -omega * lag.delay - lag.angle) / Complex (1, omega * lag.timeConstant);
}

/** Voltages behind real amplifiers, by Fourier transforms: another way than the filters have. The common lateness is
 * taken off, so that all is at its own time again. */
Eigen::MatrixXd behind (const std::vector<Amplifier>& amplifiers, const Eigen::MatrixXd& asked, double lateness)
{
    const auto length = 4 * asked.cols();
    Eigen::MatrixXd result (asked.rows(), asked.cols());

    for (Eigen::Index i = 0; i < asked.rows(); ++i)
    {
        Eigen::VectorXcd lines = forwardFourier (asked.row (i).transpose(), length);

        for (Eigen::Index k = 0; k < lines.size(); ++k)
        {
            const auto frequency = static_cast<double> (k) * lagRate / static_cast<double> (length);
            lines[k] *= responseOf (amplifiers[static_cast<std::size_t> (i)], frequency)
                        * std::polar (1.0, turn * frequency * lateness);
        }

        result.row (i) = inverseFourier (lines, length).head (asked.cols()).transpose();
    }

    return result;
}

/** Amplifiers as their monitors tell them, with noise. */
std::vector<Amplifier> measuredAt40Decibels (const std::vector<Amplifier>& real)
{
    constexpr Eigen::Index lines = 400;
    const Eigen::VectorXd frequencies = Eigen::VectorXd::LinSpaced (lines, 50, 20000);
    std::vector<Amplifier> measured;

    for (const auto& amplifier : real)
    {
        Eigen::VectorXcd response = frequencies.unaryExpr ([&] (double f) { return responseOf (amplifier, f); });
        const Eigen::VectorXcd noise = Eigen::VectorXcd::Random (lines);
        response += 0.01 * response.norm() / noise.norm() * noise;
        measured.push_back (fitAmplifier (frequencies, response).amplifier);
    }

    return measured;
}

/** Velocities of all modes at a sample, from rest. */
Eigen::VectorXd velocitiesAt (const ModalModel& model, Eigen::MatrixXd voltages, Eigen::Index sample)
{
    PlateModel plate (model, lagPlayback, Eigen::MatrixXd (0, model.coordinates()));
    Eigen::MatrixXd velocities (model.coordinates(), voltages.cols());
    plate.processModes (voltages, velocities);
    return velocities.col (sample + plate.latencySamples());
}

FocusDescription narrowFocus()
{
    FocusDescription focus;
    focus.targets = { Target {} };
    focus.targets[0].width = 0.03;
    focus.targets[0].peakVelocity = 0.02;
    focus.focusTime = 0.02;
    focus.modes.count = 8;
    return focus;
}
} // namespace

TEST_CASE ("Filters and lags together are one delay for all ceramics", "[lag]")
{
    const auto model = beamThatLags ({ { 20e-6, 30e-6, 0 }, { 7.3e-6, 0, 0.08 }, { 2e-6, 5e-6, -0.03 }, {} });
    const auto filters = lagFilters (model, lagRate, LagDirection::undo);
    CHECK (filters.misfit < 5e-3); // Of the angle, at the lowest mode.

    for (Eigen::Index i = 0; i < model.actuators(); ++i)
        for (Eigen::Index k = 0; k < model.modes(); ++k)
        {
            const auto frequency = model.frequencyHz (k);
            const auto together = responseOf (filters, i, frequency)
                                  * lagResponse (model.ceramics[static_cast<std::size_t> (i)].lag, frequency);
            CAPTURE (i, frequency);
            CHECK (std::abs (together
                             - std::polar (1.0, -turn * frequency * static_cast<double> (filters.lateness) / lagRate))
                   < 5e-3);
        }
}

TEST_CASE ("Without lags, or with the same delay for all, voltages stay to the bit", "[lag]")
{
    const Eigen::MatrixXd voltages = Eigen::MatrixXd::Random (2, 50);
    const auto model = beamThatLags ({ { 1e-5, 0, 0 }, { 1e-5, 0, 0 } });
    CHECK_FALSE (needsLagFilters (model));
    CHECK (withLagsUndone (model, voltages, voltageLimits (model), lagRate).voltages == voltages);
    CHECK (withLags (model, voltages, lagRate) == voltages);
}

TEST_CASE ("Whole delays wait, and what was played comes back", "[lag]")
{
    const auto model = beamThatLags ({ { 50 / lagRate, 0, 0 }, {} });
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (2, 400);
    voltages.col (100).setConstant (0.5);
    const auto undone = withLagsUndone (model, voltages, voltageLimits (model), lagRate);
    REQUIRE (undone.voltages.cols() > 400 + undone.lateness);
    CHECK (undone.voltages (0, 100 + undone.lateness - 50) == Approx (0.5).margin (1e-3));
    CHECK (undone.voltages (1, 100 + undone.lateness) == Approx (0.5).margin (1e-3));
    const auto acted = withLags (model, undone.voltages, lagRate);
    CHECK (acted (0, 100 + undone.lateness) == Approx (0.5).margin (1e-3));
    CHECK (acted (1, 100 + undone.lateness) == Approx (0.5).margin (1e-3));
}

TEST_CASE ("Filters are right at any sample rate, or say by how much they are not", "[lag]")
{
    const auto model = beamThatLags ({ { 20e-6, 30e-6, 0 }, { 0, 10e-6, 0 }, {} });

    for (const auto sampleRate : { 8000.0, 48000.0, 192000.0, 768000.0 })
    {
        const auto filters = lagFilters (model, sampleRate, LagDirection::undo);
        CAPTURE (sampleRate, filters.taps.rows());
        CHECK (filters.misfit < 1e-3);
        CAPTURE (filters.taps.cwiseAbs().colwise().sum().maxCoeff());
    }

    // An angle at 0.1 kHz needs a filter as long as its period.
    const auto angle = beamThatLags ({ { 0, 0, 0.05 }, {} });
    CHECK (lagFilters (angle, 48000, LagDirection::undo).misfit < 1e-3);
    const auto tooShort = lagFilters (angle, 768000, LagDirection::undo).misfit;
    CHECK (tooShort > 0.01);
    CHECK (tooShort < 0.05);
}

TEST_CASE ("Ceramics act on what lags make of the voltages, angles included", "[lag]")
{
    const auto model = beamThatLags ({ { 15e-6, 25e-6, 0.06 }, { 0, 0, -0.04 }, {} });
    constexpr Eigen::Index length = 4000;
    Eigen::MatrixXd asked (3, length), wanted (3, length);

    for (Eigen::Index i = 0; i < 3; ++i)
        for (Eigen::Index n = 0; n < length; ++n)
        {
            asked (i, n) = wanted (i, n) = 0;

            for (const auto frequency : { 300.0, 1100.0, 4100.0 })
            {
                const auto phase = turn * frequency * static_cast<double> (n) / lagRate;
                const auto response = lagResponse (model.ceramics[static_cast<std::size_t> (i)].lag, frequency);
                asked (i, n) += std::sin (phase);
                wanted (i, n) += (response * std::polar (1.0, phase)).imag();
            }
        }

    const auto acted = withLags (model, asked, lagRate);
    REQUIRE (acted.cols() == length);
    // Tones that begin and end have other frequencies there.
    CHECK ((acted - wanted).middleCols (1000, 2000).cwiseAbs().maxCoeff() < 0.005);
}

TEST_CASE ("Voltages of other channels than the ceramics are refused in a sentence", "[lag]")
{
    const auto model = beamThatLags ({ { 1e-5, 0, 0 }, {} });
    CHECK (errorText ([&] { withLags (model, Eigen::MatrixXd::Zero (3, 10), lagRate); })
           == "voltages: have 3 channels; allowed: 2, one per ceramic");
}

TEST_CASE ("Slew rates stay within their limits", "[lag]")
{
    auto model = beamThatLags ({ { 0, 3e-5, 0 }, {} });
    model.ceramics[0].slewLimit = 2e4;
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Random (2, 2000);
    const auto [undone, changed, late, misfit] = withLagsUndone (model, voltages, voltageLimits (model), lagRate);
    CHECK (changed[0] > 0);
    CHECK (changed[1] == 0);
    const auto last = undone.cols() - 1;
    CHECK ((undone.row (0).tail (last) - undone.row (0).head (last)).cwiseAbs().maxCoeff() * lagRate
           < 2e4 * (1 + 1e-9));
}

TEST_CASE ("No voltage that is asked for is beyond its limit", "[lag]")
{
    const auto model = beamThatLags ({ { 0, 3e-5, 0.1 }, {} });
    const Eigen::Vector2d limits (0.7, 1);
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Random (2, 3000).cwiseSign();
    voltages.row (0) *= limits[0];
    const auto undone = withLagsUndone (model, voltages, limits, lagRate);
    CHECK (undone.voltages.row (0).cwiseAbs().maxCoeff() <= limits[0]);
    CHECK (undone.voltages.row (1).cwiseAbs().maxCoeff() <= limits[1]);
    CHECK (undone.limited[0] > 0);
}

TEST_CASE ("Delays that differ by more than filters are long are refused in a sentence", "[lag]")
{
    CHECK (errorText (
               [&] {
                   lagFilters (beamThatLags ({ { 0.02, 0, 0 }, {} }), lagRate, LagDirection::undo);
               })
               .find ("allowed: up to")
           != std::string::npos);
}

TEST_CASE ("Behind slow amplifiers that differ the focus is the one that was designed", "[lag][amplifier]")
{
    const auto bare = test::sineBeam (8, 6);
    std::vector<Amplifier> amplifiers;

    for (int i = 0; i < 6; ++i)
        amplifiers.push_back ({ 1 + 0.03 * i, (1 + 0.1 * i) / (turn * 5000), (10 + 4.0 * i) * 1e-6 });

    const auto known = throughAmplifiers (bare, measuredAt40Decibels (amplifiers));
    const auto design = designFocus (known, narrowFocus(), lagPlayback);
    const auto render = renderOffline (known, design.program, { lagPlayback, 0.03, 512, Eigen::MatrixXd (0, 8) });
    const auto undone = withLagsUndone (known, render.voltages, design.program.voltageLimits, lagRate);
    const Eigen::VectorXd wanted = render.focusVelocities;
    const auto errorOf = [&] (const Eigen::MatrixXd& asked, double late) {
        return (velocitiesAt (bare, behind (amplifiers, asked, late), render.focusSample) - wanted).norm()
               / wanted.norm();
    };

    const auto late = static_cast<double> (undone.lateness) / lagRate + amplifiers[0].delay;
    CHECK (errorOf (undone.voltages, late) < 0.005);
    auto best = 1.0;

    for (auto common = 0.0; common < 1e-4; common += 2e-6)
        best = std::min (best, errorOf (render.voltages, common));

    CAPTURE (best, errorOf (undone.voltages, late));
    CHECK (best > 0.05); // Without filters, the common delay at its best.
}
