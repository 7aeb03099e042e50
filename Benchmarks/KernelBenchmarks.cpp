#include "FmaPeak.h"

#include <antinode_engine/AlignedBuffers.h>
#include <antinode_engine/RealtimePlate.h>
#include <antinode_engine/VoltageLimiter.h>
#include <antinode_engine/VoltageSynthesiser.h>

#include <numbers>
#include <random>

namespace antinode
{
namespace
{
constexpr double rate = 192e3;
constexpr int blockSize = 512;

Eigen::MatrixXd draws (Eigen::Index rows, Eigen::Index columns)
{
    std::mt19937 generator (1);
    return Eigen::MatrixXd::NullaryExpr (rows, columns,
                                         [&] { return static_cast<double> (generator()) / 2147483647.5 - 1; });
}

VoltageProgram makeProgram (int modes, int ceramics)
{
    VoltageProgram program;

    for (int k = 0; k < modes; ++k)
        program.oscillations.push_back ({ k, 0, 100, 0.01, 600.0 * (k + 1), 1, 0.5 });

    program.allocation = draws (ceramics, modes);
    program.voltageLimits = Eigen::VectorXd::Constant (ceramics, 1);
    program.focusTime = 100;
    return program;
}

ModalModel makeModel (int modes, int ceramics)
{
    ModalModel model;
    model.angularFrequencies =
        Eigen::VectorXd::LinSpaced (modes, 2 * std::numbers::pi * 100, 2 * std::numbers::pi * 90e3);
    model.dampingRatios = Eigen::VectorXd::Constant (modes, 0.01);
    model.participation = draws (modes, ceramics);
    return model;
}

/** Arguments: modes, ceramics. Counts two operations for the value of an oscillation and one a ceramic. */
void synthesis (benchmark::State& state)
{
    const auto modes = static_cast<int> (state.range (0)), ceramics = static_cast<int> (state.range (1));
    const VoltageSynthesiser synthesiser (makeProgram (modes, ceramics), { Reconstruction::bandLimited, rate });
    const PlanarBuffer<double> channels (ceramics, blockSize);
    std::int64_t first = 0;
    const auto items = static_cast<double> (modes) * blockSize;

    const auto block = [&]
    {
        synthesiser.add (first, blockSize, 1e-9, channels.channels());
        first = (first + blockSize) % 10000000;
    };
    bench::measure (state, items * (ceramics + 2), items, block);
    state.counters["of_a_core"] = state.counters["ns"] * 1e-9 * modes * rate;
}

/** Arguments: modes, ceramics, probes. Counts two operations for a mode, one a ceramic and one a probe; it needs four
   for the mode. */
void plate (benchmark::State& state)
{
    const auto modes = static_cast<int> (state.range (0)), ceramics = static_cast<int> (state.range (1));
    const auto probes = static_cast<int> (state.range (2));
    RealtimePlate played (makeModel (modes, ceramics), rate, draws (probes, modes));
    PlanarBuffer<double> voltages (ceramics, blockSize), velocities (probes, blockSize);
    const auto items = static_cast<double> (modes) * blockSize;

    voltages.fill (1);

    const auto block = [&] { played.process (voltages.channels(), velocities.channels(), blockSize); };
    bench::measure (state, items * (ceramics + 2 + probes), items, block);
    state.counters["of_a_core"] = state.counters["ns"] * 1e-9 * modes * rate;
}

/** Argument: ceramics. */
void limiter (benchmark::State& state)
{
    const auto ceramics = static_cast<int> (state.range (0));
    VoltageLimiter limited (Eigen::VectorXd::Constant (ceramics, 1));
    const PlanarBuffer<double> channels (ceramics, blockSize);
    const auto items = static_cast<double> (ceramics) * blockSize;
    bench::measure (state, items, items, [&] { limited.process (channels.channels(), blockSize); });
}

void synthesisSizes (benchmark::internal::Benchmark* benchmark)
{
    benchmark->ArgsProduct ({ { 16, 64, 256, 512 }, { 2, 8, 16, 64 } })->ArgNames ({ "modes", "ceramics" });
    benchmark->Iterations (100);
}

void plateSizes (benchmark::internal::Benchmark* benchmark)
{
    benchmark->ArgsProduct ({ { 16, 64, 256, 512 }, { 2, 8, 16, 64 }, { 1, 8, 16 } });
    benchmark->ArgNames ({ "modes", "ceramics", "probes" })->Iterations (100);
}

BENCHMARK (synthesis)->Apply (synthesisSizes);
BENCHMARK (plate)->Apply (plateSizes);
BENCHMARK (limiter)->Arg (16)->ArgName ("ceramics")->Iterations (100);
} // namespace
} // namespace antinode
