#include "FmaPeak.h"
#include "Peers/CsoundBank.h"
#include "Peers/FaustBank.h"
#include "Peers/JuceBank.h"

#include <antinode_engine/RealtimePlate.h>

#include <numbers>
#include <stk/BiQuad.h>

// One input, 64 modes, one output: the filter bank that others have too. 512 samples, 192 kHz, counted as 6 operations
// a mode-sample, what the coupled form needs: input, four for the state, output.

namespace antinode
{
namespace
{
constexpr int modes = 64, samples = 512;
constexpr double rate = 192e3, operations = 6.0 * modes * samples, items = 1.0 * modes * samples;

double modeFrequency (int mode)
{
    return 100.0 * (mode + 1);
}

ModalModel makeModel()
{
    ModalModel model;
    model.angularFrequencies.resize (modes);

    for (int k = 0; k < modes; ++k)
        model.angularFrequencies[k] = 2 * std::numbers::pi * modeFrequency (k);

    model.dampingRatios = Eigen::VectorXd::Constant (modes, 0.01);
    model.participation = Eigen::MatrixXd::Ones (modes, 1);
    return model;
}

void bankOfAntinode (benchmark::State& state)
{
    RealtimePlate plate (makeModel(), rate, Eigen::MatrixXd::Ones (1, modes));
    std::vector<double> in (samples, 1.0), out (samples);
    const double* voltages = in.data();
    double* velocities = out.data();
    bench::measure (state, operations, items, [&] { plate.process (&voltages, &velocities, samples); });
}
BENCHMARK (bankOfAntinode)->Iterations (200);

/** Structure of arrays, as one would write it; the compiler vectorises over the modes, for each instruction set. On a
   cache line: else its speed would depend on where the stack happens to be. */
struct alignas (64) PlainBank
{
    double real[modes], imaginary[modes], turnReal[modes], turnImaginary[modes], gain[modes];
};

__attribute__ ((target_clones ("avx512f", "arch=haswell", "default"),
                optimize ("associative-math,no-signed-zeros,no-trapping-math"))) void
playPlain (PlainBank& bank, const double* in, double* out)
{
    for (int n = 0; n < samples; ++n)
    {
        double sum = 0;

        for (int k = 0; k < modes; ++k)
        {
            const auto real =
                bank.turnReal[k] * bank.real[k] - bank.turnImaginary[k] * bank.imaginary[k] + bank.gain[k] * in[n];
            bank.imaginary[k] = bank.turnReal[k] * bank.imaginary[k] + bank.turnImaginary[k] * bank.real[k];
            bank.real[k] = real;
            sum += real;
        }

        out[n] = sum;
    }
}

void bankOfPlainLoop (benchmark::State& state)
{
    PlainBank bank {};

    for (int k = 0; k < modes; ++k)
    {
        const auto phase = 2 * std::numbers::pi * modeFrequency (k) / rate;
        bank.turnReal[k] = 0.999 * std::cos (phase);
        bank.turnImaginary[k] = 0.999 * std::sin (phase);
        bank.gain[k] = 1;
    }

    std::vector<double> in (samples, 1.0), out (samples);
    bench::measure (state, operations, items, [&] { playPlain (bank, in.data(), out.data()); });
}
BENCHMARK (bankOfPlainLoop)->Iterations (200);

void bankOfStk (benchmark::State& state)
{
    stk::Stk::setSampleRate (rate);
    std::vector<stk::BiQuad> filters (modes);

    for (int k = 0; k < modes; ++k)
        filters[static_cast<std::size_t> (k)].setResonance (modeFrequency (k), 0.999, true);

    std::vector<double> in (samples, 1.0), out (samples);
    const auto block = [&]
    {
        for (std::size_t n = 0; n < samples; ++n)
        {
            double sum = 0;

            for (auto& filter : filters)
                sum += filter.tick (in[n]);

            out[n] = sum;
        }
    };
    bench::measure (state, operations, items, block);
}
BENCHMARK (bankOfStk)->Iterations (200);

void bankOfFaust (benchmark::State& state)
{
    bench::FaustBank bank (rate);
    std::vector<double> in (samples, 1.0), out (samples);
    bench::measure (state, operations, items, [&] { bank.process (in.data(), out.data(), samples); });
}
BENCHMARK (bankOfFaust)->Iterations (200);

void bankOfJuce (benchmark::State& state)
{
    bench::JuceBank bank (rate, samples);
    std::vector<double> in (samples, 1.0), out (samples);
    bench::measure (state, operations, items, [&] { bank.process (in.data(), out.data(), samples); });
}
BENCHMARK (bankOfJuce)->Iterations (200);

void bankOfCsound (benchmark::State& state)
{
    bench::CsoundBank bank (rate, samples);
    bench::measure (state, operations, items, [&] { benchmark::DoNotOptimize (bank.process()); });
}
BENCHMARK (bankOfCsound)->Iterations (200);
} // namespace
} // namespace antinode
