#include "EngineFixtures.h"
#include "Support/AllocationCount.h"

#include <antinode_base/InputError.h>
#include <antinode_engine/VoltageSynthesiser.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace antinode;
using namespace antinode::test;

namespace
{
constexpr auto throughInterface = Reconstruction::bandLimited;
constexpr auto zeroOrderHold = Reconstruction::zeroOrderHold;

/** One oscillation on one ceramic of 1 V. */
VoltageProgram single (const Oscillation& oscillation, double focusTime)
{
    return { { oscillation }, Eigen::MatrixXd::Ones (1, 1), Eigen::VectorXd::Constant (1, 100.0), focusTime };
}

Eigen::MatrixXd synthesise (const VoltageProgram& program, Playback playback, std::int64_t first, Eigen::Index samples)
{
    Eigen::MatrixXd voltages (program.allocation.rows(), samples);
    VoltageSynthesiser (program, playback).process (first, voltages);
    return voltages;
}

/** The samples around the focus. */
Eigen::MatrixXd synthesiseInBlocks (const VoltageSynthesiser& synthesiser, Eigen::Index samples, int blockSize)
{
    Eigen::MatrixXd voltages (8, samples);
    const auto start = synthesiser.focusSample() - samples / 2;
    for (Eigen::Index first = 0; first < samples; first += blockSize)
        synthesiser.process (start + first,
                             voltages.middleCols (first, std::min<Eigen::Index> (blockSize, samples - first)));
    return voltages;
}
} // namespace

TEST_CASE ("oscillations are exact to 1e-12 of their envelope after a second at 192 kHz")
{
    for (const auto frequency : { 963.0, 30.9e3, 95e3 })
    {
        for (const auto growth : { -3.0, 0.0, 4.0 })
        {
            // All times are awkward on purpose: the exact difference of focus time and start counts.
            const Oscillation oscillation { 0, 0.0123456789, 1.2, growth, 2 * std::numbers::pi * frequency, 0.7, -0.4 };
            const auto focusTime = 1.1000013;
            const VoltageSynthesiser synthesiser (single (oscillation, focusTime), { throughInterface, 192e3 });
            Eigen::MatrixXd voltages (1, 5000);
            const std::int64_t first = 205000;
            synthesiser.process (first, voltages);

            double worst = 0; // relative to the envelope
            for (Eigen::Index j = 0; j < voltages.cols(); ++j)
            {
                const auto tau =
                    static_cast<long double> (first + j - synthesiser.focusSample()) / 192000.0L
                    + (static_cast<long double> (focusTime) - static_cast<long double> (oscillation.start));
                const auto phase = static_cast<long double> (oscillation.angularFrequency) * tau;
                const auto envelope = std::exp (static_cast<long double> (growth) * tau);
                const auto value = envelope * (0.7L * std::sin (phase) - 0.4L * std::cos (phase));
                const auto error = std::abs (static_cast<long double> (voltages (0, j)) - value) / envelope;
                worst = std::max (worst, static_cast<double> (error));
            }
            INFO (frequency << " Hz, growth " << growth << ": " << worst);
            CHECK (worst < 1e-12);
        }
    }
}

TEST_CASE ("the focus falls on a sample at every rate")
{
    for (const auto rate : usualRates)
    {
        // cos at its peak at the focus time 10.0037 ms, which is between samples
        const auto omega = 2 * std::numbers::pi * 1000;
        const auto program = single ({ 0, 0.0100037 - 0.005, 1, 0, omega, 0, 1 }, 0.0100037);
        const VoltageSynthesiser synthesiser (program, { throughInterface, rate });
        CHECK (synthesiser.focusSample() == std::llround (0.0100037 * rate));
        const auto voltages = synthesise (program, { throughInterface, rate }, synthesiser.focusSample() - 1, 3);
        CHECK (voltages (0, 1) == Approx (1).epsilon (1e-13));
        CHECK (voltages (0, 0) == Approx (std::cos (omega / rate)).epsilon (1e-12));
        CHECK (voltages (0, 2) == Approx (voltages (0, 0)).epsilon (1e-12));
    }
}

TEST_CASE (
    "a constant that starts and ends on samples has half values there when band-limited, and is half open when held")
{
    const auto program = single ({ 0, 0.002, 0.005, 0, 0, 0, 3 }, 0.005);
    Eigen::RowVectorXd smooth (8), held (8);
    smooth << 0, 0, 1.5, 3, 3, 1.5, 0, 0;
    held << 0, 0, 3, 3, 3, 0, 0, 0;
    CHECK (synthesise (program, { throughInterface, 1000 }, 0, 8) == smooth);
    CHECK (synthesise (program, { zeroOrderHold, 1000 }, 0, 8) == held);
}

TEST_CASE ("an oscillation between samples starts at the first and ends before the last sample in it")
{
    const auto program = single ({ 0, 0.0015, 0.0042, 0, 0, 0, 3 }, 0.005);
    Eigen::RowVectorXd wanted (7);
    wanted << 0, 0, 3, 3, 3, 0, 0;
    CHECK (synthesise (program, { throughInterface, 1000 }, 0, 7) == wanted);
    CHECK (synthesise (program, { zeroOrderHold, 1000 }, 0, 7) == wanted);
}

TEST_CASE ("where one oscillation ends and another starts on a sample the sample is the mean of both")
{
    auto program = single ({ 0, 0.001, 0.003, 0, 0, 0, 2 }, 0.003);
    program.oscillations.push_back ({ 0, 0.003, 0.005, 0, 0, 0, -4 });
    program.allocation = Eigen::MatrixXd::Ones (1, 2);
    Eigen::RowVectorXd wanted (7);
    wanted << 0, 1, 2, -1, -4, -2, 0;
    CHECK (synthesise (program, { throughInterface, 1000 }, 0, 7) == wanted);
}

TEST_CASE ("an oscillation of no length is silent")
{
    const auto program = single ({ 0, 0.002, 0.002, 0, 0, 0, 3 }, 0.002);
    CHECK (synthesise (program, { throughInterface, 1000 }, 0, 5).isZero (0));
    CHECK (synthesise (program, { zeroOrderHold, 1000 }, 0, 5).isZero (0));
}

TEST_CASE ("voltages are the allocation times the oscillations")
{
    auto program = manyOscillations();
    const auto all = synthesise (program, { throughInterface, 96e3 }, 0, 2300);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero (8, 2300);
    for (std::size_t c = 0; c < program.oscillations.size(); ++c)
    {
        const auto alone =
            synthesise (single (program.oscillations[c], program.focusTime), { throughInterface, 96e3 }, 0, 2300);
        sum += program.allocation.col (static_cast<Eigen::Index> (c)) * alone;
    }
    CHECK ((all - sum).cwiseAbs().maxCoeff() < 1e-14);
    CHECK (all.cwiseAbs().maxCoeff() > 0.1);
}

TEST_CASE ("synthesised voltages do not depend on the block size, to the bit, at any rate")
{
    for (const auto rate : usualRates)
    {
        for (const auto reconstruction : { throughInterface, zeroOrderHold })
        {
            const VoltageSynthesiser synthesiser (manyOscillations(), { reconstruction, rate });
            const auto whole = synthesiseInBlocks (synthesiser, 9000, 9000);
            CHECK (whole.cwiseAbs().maxCoeff() > 0.1);
            for (const auto blockSize : blockSizes)
            {
                INFO (rate << " Hz, blocks of " << blockSize);
                CHECK (sameBits (synthesiseInBlocks (synthesiser, 9000, blockSize), whole));
            }
        }
    }
}

TEST_CASE ("blocks may come in any order and before the trigger")
{
    const VoltageSynthesiser synthesiser (manyOscillations(), { throughInterface, 48e3 });
    Eigen::MatrixXd late (8, 100), early (8, 300), again (8, 100);
    synthesiser.process (900, late);
    synthesiser.process (-200, early);
    synthesiser.process (900, again);
    CHECK (sameBits (late, again));
    CHECK (early.leftCols (200).isZero (0));

    Eigen::MatrixXd straight (8, 100);
    synthesiser.process (0, straight);
    CHECK (sameBits (early.rightCols (100), straight));
}

TEST_CASE ("a program that is shifted by whole samples gives the same voltages shifted")
{
    const auto program = manyOscillations();
    auto shifted = program;
    const auto samples = 37;
    const auto shift = samples / 48e3;
    shifted.focusTime += shift;
    for (auto& oscillation : shifted.oscillations)
    {
        oscillation.start += shift;
        oscillation.end += shift;
    }
    const auto before = synthesise (program, { throughInterface, 48e3 }, 0, 1100);
    const auto after = synthesise (shifted, { throughInterface, 48e3 }, samples, 1100);
    CHECK ((after - before).cwiseAbs().maxCoeff() < 1e-11); // the shifted times are rounded to 1e-18 s
}

TEST_CASE ("synthesis allocates nothing")
{
    const VoltageSynthesiser synthesiser (manyOscillations(), { throughInterface, 48e3 });
    Eigen::MatrixXd voltages (8, 700);
    const auto before = mallocCalls();
    synthesiser.process (400, voltages);
    CHECK (mallocCalls() == before);
    CHECK ((! mallocIsCounted() || before > 0));
}

TEST_CASE ("a voltage program that cannot be played is refused")
{
    const Oscillation good { 0, 0, 0.01, 10, 1000, 1, 0 };
    const Playback playback { throughInterface, 48e3 };
    const auto refuses = [] (const VoltageProgram& program, Playback how)
    { CHECK_THROWS_AS (VoltageSynthesiser (program, how), InputError); };
    CHECK_NOTHROW (VoltageSynthesiser (single (good, 0.01), playback));

    for (const auto rate :
         { 0.0, -48e3, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
        refuses (single (good, 0.01), { throughInterface, rate });

    auto program = single (good, 0.01);
    program.allocation = Eigen::MatrixXd::Ones (1, 2);
    refuses (program, playback);
    program.allocation = Eigen::MatrixXd::Constant (1, 1, std::numeric_limits<double>::quiet_NaN());
    refuses (program, playback);

    for (const auto focusTime : { 1e300, std::numeric_limits<double>::infinity() })
        refuses (single (good, focusTime), playback);

    refuses (single ({ 0, 0.02, 0.01, 0, 1000, 1, 0 }, 0.01), playback);
    refuses (single ({ 0, 0, 1e200, 0, 1000, 1, 0 }, 0.01), playback);
    refuses (single ({ 0, 0, 0.01, 1e6, 1000, 1, 0 }, 0.01), playback);
    refuses (single ({ 0, 0, 0.01, -1e9, 1000, 1, 0 }, 0.01), playback);
    refuses (single ({ 0, 0, 0.01, 0, std::numeric_limits<double>::quiet_NaN(), 1, 0 }, 0.01), playback);
}
