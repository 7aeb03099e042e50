#pragma once

#include "FocusPlayer.h"

namespace antinode
{
/** Where the oscillations of a voice lie in a block of forces, and by which design they are shared out among
    ceramics; or where its samples lie, which are voltages already. */
struct ForceStretch
{
    const VoltageSynthesiser* design = nullptr; ///< Channel first + c is its oscillation c; its mix() shares them out.
                                                ///< None: channel first + i is the voltage of ceramic i, V.
    int first = 0;                              ///< Channel.
    int from = 0, to = 0;                       ///< The samples from .. to - 1 of the block.
    int rank = 0; ///< Stretches stand in this order, so that sums are the same to the bit however time is cut.
};

/** The voices of FocusPlayer, with their force oscillations given as they are, before they are shared out among
    ceramics: a channel an oscillation, so many for each voice as its design has. Each focus of a bank has an
    allocation of its own; stretches() says which channels belong to which. Samples of a free waveform have no forces:
    they take as many channels as there are ceramics.

    Voices take channels from a common stock while they play. Where a trigger finds too few of them, voices are cut
    for it, the one whose fade began first, else the oldest. Foci that need more channels than there are count
    as empty. Docs/Design/engine.md. */
class ForcePlayer : public FocusVoices
{
public:
    static constexpr std::size_t maximumEvents = 4096; ///< Of one block: those beyond are left out.

    /** @param channels  the stock, 1 or more
        @throws InputError  as FocusPlayer
        [worker] allocates */
    ForcePlayer (int ceramics, double sampleRate, PlayerSettings, int channels);

    /** Writes a block. Channels that no stretch speaks of keep what they hold.
        @param channels  as many pointers as the stock has, to count samples each; no unit
        [audio thread] allocates nothing, locks nothing */
    void process (double* const* channels, int count, std::span<const FocusEvent> events);

    /** What the last block holds, voice by voice. Valid until the next one. [audio thread] */
    std::span<const ForceStretch> stretches() const { return listed; }

private:
    static constexpr int partKinds = 3; ///< Of a focus its oscillations, its brake, its samples.

    /** The channels of a voice, and where its parts stand in the list. */
    struct Room
    {
        std::int64_t order = -1; ///< Of the voice that it was made for.
        int first = 0, size = 0;
        std::array<std::ptrdiff_t, partKinds> entries { -1, -1, -1 };
    };

    /** A part of a focus that plays some samples of the clock. */
    struct Part
    {
        const VoltageSynthesiser* design; ///< None: the samples.
        int kind;                         ///< 0: the focus, 1: its brake, 2: its samples.
        int first, size;                  ///< Its channels.
        std::int64_t start, from, to;
        const std::complex<double>* factors;
    };

    bool hasRoom (const Voice& voice) const;
    int freeChannel (const Voice&, int size) const;
    void makeRoom (const Voice&);
    void makeRooms (int count);
    void list (const Voice&, const Part&, int offset);
    void renderVoice (const Voice&, double* const* channels, int offset, int count);
    void renderPart (const Voice&, const Part&, double* const* channels, int offset);

    int stock;
    std::array<Room, allVoices> rooms {};
    std::vector<ForceStretch> listed;
};
} // namespace antinode
