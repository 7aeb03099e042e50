#pragma once

#include <cstdint>

namespace antinode
{
/** A gain for all ceramics that goes to its target on a straight line: arming, disarming, emergency stop.

    The gain of a sample is computed from how many samples of the ramp are left, so the output does not depend, to the
   bit, on the blocks, and the last sample of a ramp has the target itself. What is not finite stays so: VoltageLimiter
   mutes it. Docs/Theory.md, section 6.4. */
class SafetyRamp
{
public:
    /** @param gain  0..1, where it starts. [worker] */
    explicit SafetyRamp (double gain);

    /** From the next sample on, goes from the present gain to another one.
        @param target   0..1; other values and NaN count as 0, for safety
        @param samples  how many samples the way takes; the last of them has the target. 0 or less: at once
        [audio thread] */
    void setTarget (double target, std::int64_t samples);

    /** The gain of the sample processed last. [audio thread] */
    double gain() const;

    /** Whether the gain has not reached its target. [audio thread] */
    bool isMoving() const { return left > 0; }

    /** Multiplies planar channels, of double or float, in place. @param channels  pointers to count samples each
        [audio thread] allocates nothing, locks nothing, any count >= 0 */
    template <typename Sample>
    void process (Sample* const* channels, int channelCount, int count);

private:
    double start = 1, end = 1;
    std::int64_t length = 0, left = 0; // samples
};
} // namespace antinode
