#pragma once

#include "OscPacket.h"
#include "Touch.h"
#include "TuioSources.h"

#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace antinode
{
/** A message that is no touch, and how many touches of its packet came before it. */
struct OscCommand
{
    OscMessage message;
    std::size_t touchesBefore = 0;
};

/** From datagrams to touches, by these OSC 1.0 messages:

    - `/antinode/focus x_mm [y_mm [amplitude]]`: a focus at a place in mm; y = 0, amplitude = 1 where left out;
    - `/antinode/touch x y [amplitude]`: a focus at fractions of the surface;
    - `/antinode/finger number x y`: a finger rests at fractions of the surface, or moves there;
    - `/antinode/lift [number]`: it is lifted; without a number, or with what is none, all that `/antinode/finger` put
      down;
    - `/antinode/stop`, whatever stands behind it or is wrong with its packet: fades everything out;
    - `/tuio/2Dcur` of TUIO 1.1: see TuioCursors. Other profiles below `/tuio/` are skipped.

    Numbers are of the types i f h d. Addresses are compared as they stand: patterns with wildcards are unknown ones.
    Amplitudes are clamped to 0 to 1. What is bad is counted and dropped. */
class TouchMessages
{
public:
    explicit TouchMessages (const TouchOptions& options = {}) : sources (options) {}

    using Time = TuioCursors::Time;

    /** The touches of a packet in their order; packets and faults are counted.
        @param now       times do not go back
        @param commands  gets the messages below `/antinode/` that are no touches, and stops; none: these are unknown
        [any] throws nothing but std::bad_alloc; memory is bounded by the size of the packet */
    std::vector<Touch> read (std::span<const std::byte> packet, Time now, TouchCounters&,
                             std::vector<OscCommand>* commands = nullptr);

    /** What is lifted because its TUIO source has ended without a word. Call it now and then. [any] */
    std::vector<Touch> endSilent (Time now);

private:
    void readFinger (const OscMessage&, std::vector<Touch>&, TouchCounters&);
    void readLift (const OscMessage&, std::vector<Touch>&, TouchCounters&);
    bool readMessage (const OscMessage&, Time now, std::vector<Touch>&, TouchCounters&);

    TuioSources sources;
    std::set<std::int64_t> fingers; ///< Put down by numbers.
};
} // namespace antinode
