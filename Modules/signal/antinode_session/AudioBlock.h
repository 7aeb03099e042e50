#pragma once

#include <antinode_engine/FocusEvent.h>

#include <algorithm>
#include <span>

namespace antinode
{
/** Samples of a block between a host and what plays. Outputs may be the same memory as inputs and the sensor; those
   that nothing plays become silent. */
template <typename Sample>
struct AudioBlock
{
    std::span<const Sample* const> inputs; ///< Channel k is finger k or, of Antinode Plate, ceramic k; missing ones are
                                           ///< silent.
    std::span<Sample* const> outputs; ///< Channel k is ceramic k, 1.0 its device's full scale, or probe k, 1.0 = 1 m/s.
    std::span<Sample* const> monitor; ///< Velocities at probes; may be empty.
    int count = 0;                    ///< Samples.
    std::span<const FocusEvent> events; ///< In the order of their offsets; a note's place is its number.
    const Sample* sensor = nullptr;     ///< What listens to the surface; none: not plugged in.

    /** [audio thread] */
    void silence() const
    {
        for (const auto& channels : { outputs, monitor })
            for (auto* const channel : channels)
                std::fill_n (channel, count, Sample (0));
    }
};
} // namespace antinode
