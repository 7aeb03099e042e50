#pragma once

// How VoltageSynthesiser plays a block; only its own file includes this.

#include "VoltageSynthesiser.h"

#include <algorithm>
#include <array>
#include <limits>

namespace antinode
{
/** The requested samples of some of the ceramics. */
struct VoltageSynthesiser::Block
{
    std::int64_t first = 0, count = 0;
    double amplitude = 1;
    int firstCeramic = 0, ceramics = 0;
    double* const* channels = nullptr;             // of these ceramics
    const std::complex<double>* factors = nullptr; // one for every oscillation, or none
    bool areForces = false;   // whether there is a channel for every oscillation, to which it is added as it is
    std::ptrdiff_t shift = 0; // of the first sample in the channels
};

/** Plays a chunk of the oscillations through the tiles of a block. */
class VoltageSynthesiser::ChunkPlayer
{
public:
    ChunkPlayer (const VoltageSynthesiser& owner, const Block& what, std::size_t from)
        : synthesiser (owner), tables (owner.tables), block (what), firstVoice (from),
          lastVoice (std::min (from + synthesisChunk, owner.voices.size()))
    {
    }

    void addAll()
    {
        const auto end = tileIndex (block.first + block.count - 1) + 1;

        for (auto tile = tileIndex (block.first); tile < end;)
        {
            const auto runEnd = std::min (end, gather (tile));

            while (chunk.count > 0 && tile < runEnd)
            {
                const auto next = std::min (runEnd, (stripIndex (tile) + 1) * synthesisStrip);
                addStrip (tile, next);
                tile = next;
            }

            tile = runEnd;
        }
    }

private:
    /** Lists the oscillations that sound in a tile. @return  up to which tile the list holds */
    std::int64_t gather (std::int64_t tile)
    {
        auto runEnd = std::numeric_limits<std::int64_t>::max();
        chunk.count = 0;
        edges = false;
        firstStrip = stripIndex (tile);
        nextAnchor = std::numeric_limits<std::int64_t>::max();

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
        const auto slot = chunk.count++;
        numbers[slot] = c;
        chunk.records[slot] = tables.records.data() + c * tables.recordSize;
        anchor (slot, firstStrip);

        if (voice.hasEdgeIn (tile))
        {
            edges = true;
            return tile + 1;
        }

        return voice.lastTile;
    }

    /** Sets what an oscillation's phasors have in common from a strip of the run on. */
    void anchor (int slot, std::int64_t strip)
    {
        const auto& voice = synthesiser.voices[numbers[slot]];
        const auto sinceStart = static_cast<std::uint64_t> (strip - voice.firstStrip);
        const auto inGroup = static_cast<std::int64_t> (sinceStart % synthesisGroup);
        auto phasor = voice.phasors.atGroup (sinceStart / synthesisGroup);

        if (block.factors != nullptr)
            phasor = product (phasor, block.factors[numbers[slot]]);

        auto& sounding = chunk.sounding[slot];
        sounding.anchorReal = block.amplitude * phasor.real();
        sounding.anchorImaginary = block.amplitude * phasor.imag();
        sounding.turns = voice.phasors.turns() + (inGroup - (strip - firstStrip)) * (2 * synthesisStrip);
        anchors[slot] = strip - inGroup + synthesisGroup;
        nextAnchor = std::min (nextAnchor, anchors[slot]);
    }

    /** Anchors again the oscillations whose group begins with a strip. */
    void anchorAt (std::int64_t strip)
    {
        nextAnchor = std::numeric_limits<std::int64_t>::max();

        for (int slot = 0; slot < chunk.count; ++slot)
            if (anchors[slot] == strip)
                anchor (slot, strip);
            else
                nextAnchor = std::min (nextAnchor, anchors[slot]);
    }

    /** Adds a few tiles of a run, all in one strip, or what of them lies in the block. */
    void addStrip (std::int64_t tile, std::int64_t endTile)
    {
        const auto strip = stripIndex (tile);
        const auto first = strip * synthesisStrip;
        const auto offset = first * synthesisTile - block.first;
        const auto begin = std::max (-offset, (tile - first) * synthesisTile);
        const auto end = std::min (block.count - offset, (endTile - first) * synthesisTile);

        if (strip == nextAnchor)
            anchorAt (strip);

        tables.findPhasors (chunk, static_cast<int> (strip - firstStrip));
        const SynthesisTarget target { static_cast<int> (begin), static_cast<int> (end), block.firstCeramic,
                                       block.ceramics,           block.channels,         offset + block.shift };

        if (block.areForces)
            addForces (tile, endTile, target);
        else if (edges)
            addEdges (tile, static_cast<int> (tile - first), target);
        else
            tables.kernel.add (chunk, target);
    }

    /** Adds a tile in which some oscillations start or end. */
    void addEdges (std::int64_t tile, int tileInStrip, const SynthesisTarget& target)
    {
        tables.kernel.evaluate (chunk, tileInStrip);

        for (int slot = 0; slot < chunk.count; ++slot)
            if (const auto& voice = synthesiser.voices[numbers[slot]]; voice.hasEdgeIn (tile))
                weigh (voice, tile, chunk.values + slot * synthesisTile);

        tables.kernel.addValues (chunk, target);
    }

    /** Adds tiles of a strip to the channels of their oscillations. */
    void addForces (std::int64_t tile, std::int64_t endTile, const SynthesisTarget& target)
    {
        for (; tile < endTile; ++tile)
        {
            const auto start =
                static_cast<int> (tile % synthesisStrip + synthesisStrip) % synthesisStrip * synthesisTile;
            const auto begin = std::max (start, target.begin), end = std::min (start + synthesisTile, target.end);
            tables.kernel.evaluate (chunk, start / synthesisTile);

            for (int slot = 0; slot < chunk.count; ++slot)
            {
                auto* const values = chunk.values + slot * synthesisTile;

                if (const auto& voice = synthesiser.voices[numbers[slot]]; voice.hasEdgeIn (tile))
                    weigh (voice, tile, values);

                auto* const force = block.channels[numbers[slot]] + target.offset;

                for (auto n = begin; n < end; ++n)
                    force[n] += values[n - start];
            }
        }
    }

    /** Silences values before the start and after the end; on an edge they may count half. */
    static void weigh (const Voice& voice, std::int64_t tile, double* values)
    {
        for (int j = 0; j < synthesisTile; ++j)
        {
            const auto n = tile * synthesisTile + j;
            const auto weight = voice.start.weightAt (n) - voice.end.weightAt (n);
            values[j] = weight > 0 ? weight * values[j] : 0.0;
        }
    }

    const VoltageSynthesiser& synthesiser;
    const Tables& tables;
    const Block& block;
    std::size_t firstVoice, lastVoice;
    std::array<std::size_t, synthesisChunk> numbers;  // of the voices that sound
    std::array<std::int64_t, synthesisChunk> anchors; // at which strips they need the next ones
    std::int64_t firstStrip = 0, nextAnchor = 0;      // of the run
    bool edges = false; // whether one of them starts or ends in the run, which is then one tile
    SynthesisChunk chunk;
};
} // namespace antinode
