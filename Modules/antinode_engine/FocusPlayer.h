#pragma once

#include "FocusVoices.h"

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
    template <typename Sample>
    void process (Sample* const* channels, int count, std::span<const FocusEvent> events);

private:
    static constexpr int fadeChunk = 64; ///< Samples.

    template <typename Sample>
    void render (Sample* const* channels, int offset, int count);
    template <typename Sample>
    void addOscillations (const Voice&, std::int64_t from, std::int64_t to, Sample* const* channels) const;
    template <typename Sample>
    void renderVoice (const Voice&, Sample* const* channels, int offset, int count);
    template <typename Sample>
    void renderFade (const Voice&, Sample* const* channels, int offset, std::int64_t from, std::int64_t to);
    template <typename Sample>
    void fadeOscillations (const Voice&, Sample* const* channels, int offset, std::int64_t from, std::int64_t to);
    template <typename Sample>
    const Sample* gainsFrom (std::int64_t sampleOfFade) const;
    template <typename Sample>
    Sample* const* scratchChannels();
    template <typename Sample>
    Sample* const* shiftedBy (std::int64_t samples, Sample* const* channels);

    std::vector<double> scratchDouble;
    std::vector<float> scratchFloat, floatGains; ///< The latter as fadeGains.
    std::vector<double*> channelsDouble, shiftedDouble;
    std::vector<float*> channelsFloat, shiftedFloat;
};
} // namespace antinode
