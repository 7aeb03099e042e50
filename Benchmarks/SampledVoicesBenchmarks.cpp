#include <antinode_engine/AlignedBuffers.h>
#include <antinode_engine/FocusPlayer.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <vector>

// Voices of samples, each of a place of its own so that they do not share what is in the cache: 32 ceramics at 96 kHz,
// blocks of 512. of_a_core is what real time takes.

namespace antinode
{
namespace
{
constexpr double rate = 96000;
constexpr int samples = 512, ceramics = 32, blocksOfAFocus = 4;
constexpr Playback playback { Reconstruction::bandLimited, rate };

VoltageProgram waves (int place)
{
    VoltageProgram program;
    program.allocation.resize (ceramics, 0);
    program.voltageLimits = Eigen::VectorXd::Constant (ceramics, 100);
    program.focusTime = 0.025;
    program.samples = { playback, 0, Eigen::MatrixXd (ceramics, std::llround (0.025 * rate) + 32) };
    auto& values = program.samples->values;

    for (Eigen::Index n = 0; n < values.cols(); ++n)
        for (Eigen::Index i = 0; i < ceramics; ++i)
            values (i, n) = std::sin (0.01 * static_cast<double> ((place + 3) * (i + 1) * n));

    return program;
}

/** So many voices at once. Beyond 24 the oldest fade, for so long that they do not end while it is measured. */
struct PlayedVoices
{
    FocusPlayer player { ceramics,
                         rate,
                         { NoteOffBehaviour::ignore, RetriggerBehaviour::overlap, false, /* fade */ 1.0 } };
    std::vector<FocusEvent> events;

    explicit PlayedVoices (int voices)
    {
        auto bank = std::make_unique<FocusBank>();

        for (int place = 0; place < voices; ++place)
        {
            bank->foci[static_cast<std::size_t> (place)] =
                std::make_shared<const PlayableFocus> (waves (place), playback);
            events.push_back ({ 0, FocusEventKind::trigger, place, 0.5 });
        }

        player.handOver().give (std::move (bank));
    }
};

/** Argument: voices. */
void sampledVoices (benchmark::State& state)
{
    PlayedVoices played (static_cast<int> (state.range (0)));
    const PlanarBuffer<double> channels (ceramics, samples);
    auto left = 0;

    for (auto run : state)
    {
        if (left == 0)
        {
            state.PauseTiming();
            played.player.reset();
            played.player.process (channels.channels(), 0, played.events);
            left = blocksOfAFocus;
            state.ResumeTiming();
        }

        played.player.process (channels.channels(), samples, {});
        benchmark::DoNotOptimize (channels.channel (0)[0]);
        --left;
    }

    const auto audio = static_cast<double> (state.iterations()) * samples / rate; // s
    state.counters["of_a_core"] = benchmark::Counter (audio, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK (sampledVoices)->Arg (1)->Arg (24)->Arg (32)->ArgName ("voices");
} // namespace
} // namespace antinode
