#include "VoltageSynthesiser.h"

#include <antinode_model/InputError.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
constexpr double furthestSample = 1e15; // below 2^53: every sample's index is exact
constexpr int ceramicsAtOnce = 16;      // of those that pass through a buffer on the stack

std::int64_t tileOf (std::int64_t sample)
{
    return sample >= 0 ? sample / synthesisTile : -((-sample + synthesisTile - 1) / synthesisTile);
}

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

    // The tile of the first sample begins up to one tile before the start, where a decaying envelope is larger still.
    const auto spread = std::max (0.0, oscillation.growth) * (oscillation.end - oscillation.start)
                        + std::abs (oscillation.growth) * static_cast<double> (synthesisTile) / rate;

    if (! std::isfinite (std::abs (oscillation.phasor()) * std::exp (spread)))
        throw InputError (where, "grows or decays beyond the range of numbers");
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

template <>
const VoltageSynthesiser::Tables<double>& VoltageSynthesiser::tables<double>() const
{
    return doubles;
}

template <>
const VoltageSynthesiser::Tables<float>& VoltageSynthesiser::tables<float>() const
{
    return floats;
}

/** Samples that are asked for, of some of the ceramics. */
template <typename Sample>
struct VoltageSynthesiser::Block
{
    std::int64_t first = 0, count = 0;
    double amplitude = 1;
    int firstCeramic = 0, ceramics = 0;
    Sample* const* channels = nullptr; // of these ceramics
    const std::complex<double>* factors = nullptr;
};

/** Plays a chunk of the oscillations through the tiles of a block. */
template <typename Sample>
class VoltageSynthesiser::ChunkPlayer
{
public:
    ChunkPlayer (const VoltageSynthesiser& owner, const Block<Sample>& what, std::size_t from)
        : synthesiser (owner), tables (owner.tables<Sample>()), block (what), firstVoice (from),
          lastVoice (std::min (from + synthesisChunk, owner.voices.size()))
    {
    }

    void addAll()
    {
        const auto end = tileOf (block.first + block.count - 1) + 1;

        for (auto tile = tileOf (block.first); tile < end;)
        {
            const auto runEnd = std::min (end, gather (tile));

            for (auto strip = tile; chunk.count > 0 && strip < runEnd; strip += synthesisStrip)
                addStrip (tile, strip, std::min<std::int64_t> (synthesisStrip, runEnd - strip));

            tile = runEnd;
        }
    }

private:
    /** Lists the oscillations that sound in a tile. @return  up to which tile the list and its anchors hold */
    std::int64_t gather (std::int64_t tile)
    {
        auto runEnd = std::numeric_limits<std::int64_t>::max();
        chunk.count = 0;
        edges = false;

        for (auto c = firstVoice; c < lastVoice; ++c)
        {
            const auto& voice = synthesiser.voices[c];

            if (tile < voice.firstTile)
                runEnd = std::min (runEnd, voice.firstTile);
            else if (tile <= voice.lastTile)
                runEnd = std::min (runEnd, append (c, tile));
        }

        return runEnd;
    }

    std::int64_t append (std::size_t c, std::int64_t tile)
    {
        const auto& voice = synthesiser.voices[c];
        const auto sinceStart = static_cast<std::uint64_t> (tile - voice.firstTile);
        const auto turn = sinceStart % synthesisGroup;
        auto anchor = voice.phasors.atGroup (sinceStart / synthesisGroup);

        if (block.factors != nullptr)
            anchor = product (anchor, block.factors[c]);

        numbers[chunk.count] = c;
        auto& sounding = chunk.sounding[chunk.count++];
        sounding.anchorReal = block.amplitude * anchor.real();
        sounding.anchorImaginary = block.amplitude * anchor.imag();
        sounding.turnReal = voice.phasors.turnReal() + turn;
        sounding.turnImaginary = voice.phasors.turnImaginary() + turn;
        sounding.fine = tables.fine.data() + c * (2UL * synthesisTile);
        sounding.mixing = tables.mixing.data() + c * synthesiser.ceramics + block.firstCeramic;

        if (voice.hasEdgeIn (tile))
        {
            edges = true;
            return tile + 1;
        }

        return std::min (voice.lastTile, tile + synthesisGroup - static_cast<std::int64_t> (turn));
    }

    /** Adds a few tiles of a run, or what of them lies in the block. */
    void addStrip (std::int64_t run, std::int64_t tile, std::int64_t tiles)
    {
        const auto offset = tile * synthesisTile - block.first;
        const auto begin = std::max<std::int64_t> (0, -offset);
        const auto end = std::min (tiles * synthesisTile, block.count - offset);
        tables.kernel.evaluate (chunk, static_cast<int> (tile - run), static_cast<int> (tiles));

        for (int slot = 0; edges && slot < chunk.count; ++slot)
            if (const auto& voice = synthesiser.voices[numbers[slot]]; voice.hasEdgeIn (tile))
                weigh (voice, tile, chunk.values + slot * chunk.samples);

        tables.kernel.mix (chunk, static_cast<int> (begin), static_cast<int> (end), block.ceramics, block.channels,
                           offset + begin);
    }

    /** Silences values before the start and after the end; on an edge they may count half. */
    static void weigh (const Voice& voice, std::int64_t tile, Sample* values)
    {
        for (int j = 0; j < synthesisTile; ++j)
        {
            const auto n = tile * synthesisTile + j;
            const auto weight = voice.start.weightAt (n) - voice.end.weightAt (n);
            values[j] = weight > 0 ? static_cast<Sample> (weight) * values[j] : Sample (0);
        }
    }

    const VoltageSynthesiser& synthesiser;
    const Tables<Sample>& tables;
    const Block<Sample>& block;
    std::size_t firstVoice, lastVoice;
    std::array<std::size_t, synthesisChunk> numbers; // of the voices that sound
    bool edges = false; // whether one of them starts or ends in the run, which is then one tile
    SynthesisChunk<Sample> chunk;
};

VoltageSynthesiser::VoltageSynthesiser (const VoltageProgram& program, Playback playback) : rate (playback.sampleRate)
{
    requireUsable (program, rate);
    focus = std::llround (program.focusTime * rate);
    ceramics = static_cast<int> (program.allocation.rows());

    for (const auto& oscillation : program.oscillations)
        voices.push_back (voiceOf (oscillation, program.focusTime, playback.reconstruction));

    doubles = tablesOf<double> (program);
    floats = tablesOf<float> (program);
}

VoltageSynthesiser::Edge VoltageSynthesiser::edgeAt (double time, double focusTime, Reconstruction reconstruction) const
{
    const auto position = static_cast<long double> (focus) + (static_cast<long double> (time) - focusTime) * rate;
    const auto nearest = std::round (position);

    if (std::abs (position - nearest) < 1e-6L)
        return { std::llround (nearest), reconstruction == Reconstruction::bandLimited ? 0.5 : 1.0 };

    return { static_cast<std::int64_t> (std::ceil (position)), 1.0 };
}

VoltageSynthesiser::Voice VoltageSynthesiser::voiceOf (const Oscillation& oscillation, double focusTime,
                                                       Reconstruction reconstruction) const
{
    const auto start = edgeAt (oscillation.start, focusTime, reconstruction);
    const auto end = edgeAt (oscillation.end, focusTime, reconstruction);
    const auto firstTile = tileOf (start.sample), lastTile = tileOf (end.sample);

    // Extended precision: 1e-16 of a phase of 1e5 rad would already be more than the 1e-12 that are promised.
    const auto tau = static_cast<long double> (firstTile * synthesisTile - focus) / rate
                     + (static_cast<long double> (focusTime) - oscillation.start);
    const auto first = oscillation.phasor() * exponential (oscillation, tau);
    return { start, end, firstTile, lastTile, TilePhasors (oscillation, first, rate, lastTile - firstTile + 1) };
}

template <typename Sample>
VoltageSynthesiser::Tables<Sample> VoltageSynthesiser::tablesOf (const VoltageProgram& program) const
{
    Tables<Sample> tables { synthesisKernel<Sample>(), {}, {} };

    for (const auto& oscillation : program.oscillations)
    {
        std::array<std::complex<double>, synthesisTile> fine;

        for (std::size_t j = 0; j < fine.size(); ++j)
            fine[j] = exponential (oscillation, static_cast<long double> (j) / rate);

        for (const auto& value : fine)
            tables.fine.push_back (static_cast<Sample> (value.real()));

        for (const auto& value : fine)
            tables.fine.push_back (static_cast<Sample> (value.imag()));
    }

    for (const auto value : program.allocation.reshaped())
        tables.mixing.push_back (static_cast<Sample> (value));

    return tables;
}

template <typename Sample>
void VoltageSynthesiser::addBlock (const Block<Sample>& block) const
{
    if (block.count <= 0)
        return;

    // Chunk by chunk, so that the tables of a chunk are read from the fastest cache in all tiles but the first.
    for (std::size_t voice = 0; voice < voices.size(); voice += synthesisChunk)
        ChunkPlayer<Sample> (*this, block, voice).addAll();
}

template <typename Sample>
void VoltageSynthesiser::add (std::int64_t first, int count, double amplitude, Sample* const* channels,
                              const std::complex<double>* factors) const
{
    addBlock<Sample> ({ first, count, amplitude, 0, ceramics, channels, factors });
}

template void VoltageSynthesiser::add (std::int64_t, int, double, double* const*, const std::complex<double>*) const;
template void VoltageSynthesiser::add (std::int64_t, int, double, float* const*, const std::complex<double>*) const;

void VoltageSynthesiser::process (std::int64_t first, Eigen::Ref<Eigen::MatrixXd> voltages) const
{
    constexpr auto stripSamples = SynthesisChunk<double>::samples;
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
            addBlock<double> ({ first + n, count, 1.0, ceramic, rows, channels.data() });

            for (int i = 0; i < rows; ++i)
                voltages.row (ceramic + i).segment (n, count) =
                    Eigen::Map<const Eigen::RowVectorXd> (channels[static_cast<std::size_t> (i)], count);
        }
    }
}
} // namespace antinode
