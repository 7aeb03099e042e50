#include "VoltageSynthesiserChunk.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr double furthestSample = 1e15; // below 2^53: every sample's index is exact
constexpr int ceramicsAtOnce = 16;      // of those that pass through a buffer on the stack

void requireUsable (const Oscillation& oscillation, const std::string& where, double rate)
{
    const auto finite = std::isfinite (oscillation.start) && std::isfinite (oscillation.end)
                        && std::isfinite (oscillation.growth) && std::isfinite (oscillation.angularFrequency)
                        && std::isfinite (oscillation.inPhase) && std::isfinite (oscillation.quadrature);

    if (! finite)
        throw InputError (where, "has a number that is not finite");

    if (oscillation.end < oscillation.start)
        throw InputError (where, "ends before it starts");

    if (std::max (std::abs (oscillation.start), std::abs (oscillation.end)) * rate > furthestSample)
        throw InputError (where, "starts or ends more than 1e15 samples from the trigger");

    // The strip of the first sample begins up to a strip before the start, where a decaying envelope is larger still.
    const auto spread = std::max (0.0, oscillation.growth) * (oscillation.end - oscillation.start)
                        + std::abs (oscillation.growth) * static_cast<double> (stripSamples) / rate;

    if (! std::isfinite (std::abs (oscillation.phasor()) * std::exp (spread)))
        throw InputError (where, "grows or decays beyond double precision");
}

void requireUsable (const VoltageProgram& program, double rate)
{
    if (! std::isfinite (rate) || rate <= 0)
        throw InputError ("sample rate", "must be finite and positive to play samples");

    const auto count = static_cast<Eigen::Index> (program.oscillations.size());

    if (program.allocation.cols() != count || ! program.allocation.allFinite())
        throw InputError ("voltage program",
                          "the allocation needs one column of finite voltages for every oscillation");

    if (! std::isfinite (program.focusTime) || std::abs (program.focusTime) * rate > furthestSample)
        throw InputError ("voltage program", "the focus time must be finite and within 1e15 samples of the trigger");

    for (Eigen::Index c = 0; c < count; ++c)
        requireUsable (program.oscillations[static_cast<std::size_t> (c)],
                       "voltage program: oscillation " + std::to_string (c + 1), rate);
}
} // namespace

VoltageSynthesiser::VoltageSynthesiser (const VoltageProgram& program, Playback playback) : rate (playback.sampleRate)
{
    requireUsable (program, rate);
    focus = std::llround (program.focusTime * rate);
    ceramics = static_cast<int> (program.allocation.rows());

    for (const auto& oscillation : program.oscillations)
        voices.push_back (makeVoice (oscillation, program.focusTime, playback.reconstruction));

    tables = makeTables (program);
}

VoltageSynthesiser::Edge VoltageSynthesiser::edgeAt (double time, double focusTime, Reconstruction reconstruction) const
{
    const auto position = static_cast<long double> (focus) + (static_cast<long double> (time) - focusTime) * rate;
    const auto nearest = std::round (position);

    if (std::abs (position - nearest) < 1e-6L)
        return { std::llround (nearest), reconstruction == Reconstruction::bandLimited ? 0.5 : 1.0 };

    return { static_cast<std::int64_t> (std::ceil (position)), 1.0 };
}

VoltageSynthesiser::Voice VoltageSynthesiser::makeVoice (const Oscillation& oscillation, double focusTime,
                                                         Reconstruction reconstruction) const
{
    const auto start = edgeAt (oscillation.start, focusTime, reconstruction);
    const auto end = edgeAt (oscillation.end, focusTime, reconstruction);
    const auto firstTile = tileIndex (start.sample), lastTile = tileIndex (end.sample),
               firstStrip = stripIndex (firstTile);

    // Extended precision: 1e-16 of a phase of 1e5 rad would already be more than the 1e-12 that are promised.
    const auto tau = static_cast<long double> (firstStrip * stripSamples - focus) / rate
                     + (static_cast<long double> (focusTime) - oscillation.start);
    const auto first = oscillation.phasor() * exponential (oscillation, tau);
    return { start,    end,        firstTile,
             lastTile, firstStrip, TilePhasors (oscillation, first, rate, stripIndex (lastTile) - firstStrip + 1) };
}

VoltageSynthesiser::Tables VoltageSynthesiser::makeTables (const VoltageProgram& program) const
{
    constexpr auto line = cacheLine / sizeof (double);
    const auto used = 2UL * synthesisTile + static_cast<std::size_t> (ceramics);
    Tables made { phasorKernel(), synthesisKernel(), (used + line - 1) / line * line, {} };
    made.records.resize (made.recordSize * program.oscillations.size());

    for (std::size_t c = 0; c < program.oscillations.size(); ++c)
    {
        auto* record = made.records.data() + c * made.recordSize;

        for (int j = 0; j < synthesisTile; ++j)
        {
            const auto fine = exponential (program.oscillations[c], static_cast<long double> (j) / rate);
            record[j] = fine.real();
            record[j + synthesisTile] = fine.imag();
        }

        for (Eigen::Index i = 0; i < ceramics; ++i)
            record[2 * synthesisTile + i] = program.allocation (i, static_cast<Eigen::Index> (c));
    }

    return made;
}

void VoltageSynthesiser::addBlock (const Block& block) const
{
    if (block.count <= 0)
        return;

    // Chunk by chunk, so that the tables of a chunk are read from the fastest cache in all tiles but the first.
    for (std::size_t voice = 0; voice < voices.size(); voice += synthesisChunk)
        ChunkPlayer (*this, block, voice).addAll();
}

void VoltageSynthesiser::add (std::int64_t first, int count, double amplitude, double* const* channels,
                              const std::complex<double>* factors) const
{
    addBlock ({ first, count, amplitude, 0, ceramics, channels, factors });
}

void VoltageSynthesiser::addForces (std::int64_t first, int count, double amplitude, double* const* forces,
                                    std::ptrdiff_t offset, const std::complex<double>* factors) const
{
    addBlock ({ first, count, amplitude, 0, ceramics, forces, factors, true, offset });
}

/** Takes at most a tile of some oscillations; those that are silent in it are left out. */
void VoltageSynthesiser::gatherForces (const double* const* forces, std::size_t firstVoice, int at, int length,
                                       SynthesisChunk& chunk) const
{
    const auto end = std::min (firstVoice + synthesisChunk, voices.size());
    chunk.count = 0;

    for (auto c = firstVoice; c < end; ++c)
    {
        const auto* const force = forces[c] + at;

        if (std::all_of (force, force + length, [] (double value) { return value == 0; }))
            continue;

        auto* const values = chunk.values + chunk.count * synthesisTile;
        std::fill (std::copy_n (force, length, values), values + synthesisTile, 0.0);
        chunk.records[chunk.count++] = tables.records.data() + c * tables.recordSize;
    }
}

void VoltageSynthesiser::mix (const double* const* forces, int from, int to, double* const* channels) const
{
    SynthesisChunk chunk;

    for (std::size_t voice = 0; voice < voices.size(); voice += synthesisChunk)
        for (auto at = from; at < to; at += synthesisTile)
        {
            const auto length = std::min (synthesisTile, to - at);
            gatherForces (forces, voice, at, length, chunk);

            if (chunk.count > 0)
                tables.kernel.addValues (chunk, { 0, length, 0, ceramics, channels, at });
        }
}

void VoltageSynthesiser::process (std::int64_t first, Eigen::Ref<Eigen::MatrixXd> voltages) const
{
    std::array<std::array<double, stripSamples>, ceramicsAtOnce> planar;
    std::array<double*, ceramicsAtOnce> channels;
    std::transform (planar.begin(), planar.end(), channels.begin(), [] (auto& channel) { return channel.data(); });

    for (int ceramic = 0; ceramic < ceramics; ceramic += ceramicsAtOnce)
    {
        const auto rows = std::min (ceramicsAtOnce, ceramics - ceramic);

        for (Eigen::Index n = 0; n < voltages.cols(); n += stripSamples)
        {
            const auto count = std::min<Eigen::Index> (stripSamples, voltages.cols() - n);
            planar = {};
            addBlock ({ first + n, count, 1.0, ceramic, rows, channels.data() });

            for (int i = 0; i < rows; ++i)
                voltages.row (ceramic + i).segment (n, count) =
                    Eigen::Map<const Eigen::RowVectorXd> (channels[static_cast<std::size_t> (i)], count);
        }
    }
}
} // namespace antinode
