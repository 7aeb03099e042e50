#pragma once

#include "FocusVoices.h"
#include "PlanarBuffer.h"

#include <vector>

namespace antinode
{
/** Overlapping foci, each with its own design and amplitude, summed into one channel per ceramic: the voices with their
   synthesis and mixing fused.

    Output depends on the samples' and events' places in time only, not, to the bit, on how time is cut into blocks.
   Limits are not its concern: VoltageLimiter stands behind it. */
class FocusPlayer : public FocusVoices
{
public:
    /** @param ceramics    channels, 1 or more
        @param sampleRate  Hz
        @throws InputError  when one of them, or the fade time, is not usable
        [worker] allocates */
    FocusPlayer (int ceramics, double sampleRate, PlayerSettings);

    /** Writes a block.
        @param channels  one pointer per ceramic, to count samples each, V; overwritten
        @param count     0 or more
        [audio thread] allocates nothing, locks nothing */
    void process (double* const* channels, int count, std::span<const FocusEvent> events);

private:
    static constexpr int fadeChunk = 64; ///< Samples.

    void render (double* const* channels, int offset, int count);
    void addOscillations (const Voice&, std::int64_t from, std::int64_t to, double* const* channels) const;
    void renderVoice (const Voice&, double* const* channels, int offset, int count);
    void renderFade (const Voice&, double* const* channels, int offset, std::int64_t from, std::int64_t to);
    void fadeOscillations (const Voice&, double* const* channels, int offset, std::int64_t from, std::int64_t to);
    double* const* shiftedBy (std::int64_t samples, double* const* channels);

    PlanarBuffer<double> scratch; ///< Of a fading voice.
    std::vector<double*> shifted; ///< A pointer a ceramic.
};
} // namespace antinode
