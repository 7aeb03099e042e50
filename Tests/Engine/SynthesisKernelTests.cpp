#include "EngineFixtures.h"
#include "Support/AllocationCount.h"

#include <antinode_engine/VoltageSynthesiser.h>

#include <catch2/catch.hpp>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>

using namespace antinode;
using namespace antinode::test;

namespace
{

/** Planar channels of what a synthesiser adds to 0 from a sample on, in blocks. */
std::vector<std::vector<double>> addInBlocks (const VoltageSynthesiser& synthesiser, std::int64_t first, int samples,
                                              int blockSize, double amplitude = 1)
{
    std::vector<std::vector<double>> planar (synthesiser.channelCount(), std::vector<double> (samples));
    std::vector<double*> channels (planar.size());

    for (int done = 0; done < samples; done += blockSize)
    {
        for (std::size_t i = 0; i < planar.size(); ++i)
            channels[i] = planar[i].data() + done;

        synthesiser.add (first + done, std::min (blockSize, samples - done), amplitude, channels.data());
    }

    return planar;
}

/** 150 oscillations, more than a few chunks, that start and end anywhere within 60 ms, on 23 ceramics: groups of 16, 8,
    4, 2, 1. */
VoltageProgram crowd()
{
    Draws draws (11);
    VoltageProgram program;
    program.focusTime = 0.03;

    for (int c = 0; c < 150; ++c)
    {
        const auto start = 0.03 + 0.03 * draws.next(), length = 0.02 * (1 + draws.next());
        program.oscillations.push_back (
            { c, start, start + length, 100 * draws.next(), 2e5 * (1 + draws.next()) / 2, draws.next(), draws.next() });
    }

    program.allocation = draws.matrix (23, 150);
    program.voltageLimits = Eigen::VectorXd::Constant (23, 100);
    return program;
}

/** The same by the definition, sample by sample. */
Eigen::MatrixXd byDefinition (const VoltageProgram& program, double rate, std::int64_t first, Eigen::Index samples)
{
    Eigen::MatrixXd voltages = Eigen::MatrixXd::Zero (program.allocation.rows(), samples);
    const auto focus = std::llround (program.focusTime * rate);

    for (Eigen::Index n = 0; n < samples; ++n)
    {
        for (std::size_t c = 0; c < program.oscillations.size(); ++c)
        {
            const auto& oscillation = program.oscillations[c];
            const auto time = program.focusTime + static_cast<long double> (first + n - focus) / rate;
            const auto tau = time - oscillation.start;

            if (time < oscillation.start || time >= oscillation.end)
                continue;

            const auto phase = oscillation.angularFrequency * tau;
            const auto value = std::exp (oscillation.growth * tau)
                               * (oscillation.inPhase * std::sin (phase) + oscillation.quadrature * std::cos (phase));
            voltages.col (n) += program.allocation.col (static_cast<Eigen::Index> (c)) * static_cast<double> (value);
        }
    }

    return voltages;
}

double worstDifference (const std::vector<std::vector<double>>& planar, const Eigen::MatrixXd& wanted)
{
    double worst = 0;

    for (std::size_t i = 0; i < planar.size(); ++i)
        for (std::size_t n = 0; n < planar[i].size(); ++n)
            worst = std::max (
                worst, std::abs (planar[i][n] - wanted (static_cast<Eigen::Index> (i), static_cast<Eigen::Index> (n))));

    return worst;
}

/** Restricts the kernels that are chosen to one target, while it lives. */
class OnlyTarget
{
public:
    explicit OnlyTarget (std::int64_t target) { hwy::SetSupportedTargetsForTest (target); }
    ~OnlyTarget() { hwy::SetSupportedTargetsForTest (0); }
    OnlyTarget (const OnlyTarget&) = delete;
    OnlyTarget& operator= (const OnlyTarget&) = delete;
};
} // namespace

TEST_CASE ("voltages of every instruction set are the definition's, to 1e-11")
{
    // 150 oscillations of up to e^4 V and 1 each: rounding adds up to some 1e-13.
    const auto program = crowd();
    const auto wanted = byDefinition (program, 96e3, -10, 6000);
    CHECK (wanted.cwiseAbs().maxCoeff() > 10);

    for (const auto target : hwy::SupportedAndGeneratedTargets())
    {
        const OnlyTarget only (target);
        const VoltageSynthesiser synthesiser (program, { Reconstruction::bandLimited, 96e3 });
        INFO (hwy::TargetName (target));
        CHECK (worstDifference (addInBlocks (synthesiser, -10, 6000, 6000), wanted) < 1e-11);
    }
}

TEST_CASE ("added voltages do not depend on the block size, to the bit, with any instruction set")
{
    for (const auto target : hwy::SupportedAndGeneratedTargets())
    {
        const OnlyTarget only (target);
        const VoltageSynthesiser synthesiser (crowd(), { Reconstruction::bandLimited, 192e3 });
        const auto whole = addInBlocks (synthesiser, -77, 12000, 12000);

        for (const auto blockSize : { 1, 7, 33, 64, 100, 512, 8193 })
        {
            INFO (hwy::TargetName (target) << ", blocks of " << blockSize);
            CHECK (addInBlocks (synthesiser, -77, 12000, blockSize) == whole);
        }
    }
}

TEST_CASE ("voltages are the same in planar channels and in a matrix, to the bit")
{
    const VoltageSynthesiser synthesiser (crowd(), { Reconstruction::bandLimited, 48e3 });
    Eigen::MatrixXd matrix (23, 3000);
    synthesiser.process (5, matrix);
    CHECK (worstDifference (addInBlocks (synthesiser, 5, 3000, 1000), matrix) == 0);
}

TEST_CASE ("voltages are added to what the channels hold, times the amplitude, and nothing beside the block is touched")
{
    const VoltageSynthesiser synthesiser (manyOscillations(), { Reconstruction::bandLimited, 48e3 });
    const auto alone = addInBlocks (synthesiser, 900, 200, 200);
    std::vector<std::vector<double>> planar (8, std::vector<double> (210, 3.0));
    std::vector<double*> channels;
    std::transform (planar.begin(), planar.end(), std::back_inserter (channels), [] (auto& p) { return p.data() + 5; });
    synthesiser.add (900, 0, 0.5, channels.data());
    synthesiser.add (900, 200, 0.5, channels.data());

    for (std::size_t i = 0; i < planar.size(); ++i)
    {
        for (std::size_t n = 0; n < 5; ++n)
            CHECK ((planar[i][n] == 3.0 && planar[i][205 + n] == 3.0));

        for (std::size_t n = 0; n < 200; ++n)
            CHECK (planar[i][5 + n] == Approx (3.0 + 0.5 * alone[i][n]).margin (1e-13));
    }
}

TEST_CASE ("an oscillation of an hour is as exact at its end as at its start")
{
    const Oscillation oscillation { 0, 0.1, 3700, 0, 2 * std::numbers::pi * 30.9e3, 1, 0 };
    const VoltageProgram program { { oscillation }, Eigen::MatrixXd::Ones (1, 1), Eigen::VectorXd::Ones (1), 0.2 };
    const VoltageSynthesiser synthesiser (program, { Reconstruction::bandLimited, 192e3 });

    for (const auto first : { 50000LL, 691200000LL })
        CHECK (worstDifference (addInBlocks (synthesiser, first, 500, 500), byDefinition (program, 192e3, first, 500))
               < 1e-9); // extended precision knows the phase, 7e8 rad, to 4e-11
}

TEST_CASE ("adding voltages allocates nothing")
{
    const VoltageSynthesiser synthesiser (manyOscillations(), { Reconstruction::bandLimited, 48e3 });
    std::vector<std::vector<double>> planar (8, std::vector<double> (700));
    std::vector<double*> channels;
    std::transform (planar.begin(), planar.end(), std::back_inserter (channels), [] (auto& p) { return p.data(); });
    const auto before = mallocCalls();
    synthesiser.add (400, 700, 1.0, channels.data());
    CHECK (mallocCalls() == before);
    CHECK ((! mallocIsCounted() || before > 0));
}
