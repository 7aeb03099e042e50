#pragma once

#include <antinode_session/PlayControls.h>
#include <antinode_touch/Touch.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace antinode
{
/** What a finger is to do because of a touch. */
struct FingerMove
{
    enum class Kind
    {
        down, ///< It comes to rest at a place.
        move, ///< It rests, and is at another place now.
        lift  ///< It has left; the place means nothing.
    };

    std::size_t finger = 0;
    Kind kind = Kind::down;
    double x = 0, y = 0; ///< Fractions of the surface.

    bool operator== (const FingerMove&) const = default;
};

/** Which finger each touch is. A touch of a number from 1 to 8 is the finger of that number, any other one the next
   that is free; a touch that finds none waits for one. However often touches move, of each only its last place counts.
    Docs/Design/fingers.md */
class TouchedFingers
{
public:
    static constexpr std::size_t mostTouches = 64; ///< That are kept, those that wait among them.

    /** A touch that comes, moves or leaves; foci are none of these and do nothing. A stop lifts all.
        [any but the audio thread] */
    void take (const Touch&);

    /** As if all had left. [any but the audio thread] */
    void liftAll();

    /** What has changed since the last call, in its order. @param isFree  which fingers a touch may take that is not
        bound to one: nobody uses them, and they have inputs [message thread] */
    std::vector<FingerMove> takeMoves (const std::array<bool, mostFingers>& isFree);

    /** Which fingers are touches', also of those that have just left. [any but the audio thread] */
    std::array<bool, mostFingers> touched() const;

    /** Touches that are fingers, and those that wait for one. [any but the audio thread] */
    std::size_t resting() const;
    std::size_t waiting() const;

    /** Touches that were left out because too many were there. [any but the audio thread] */
    std::int64_t dropped() const;

private:
    struct Resting
    {
        std::int64_t touch = 0;
        double x = 0, y = 0;
        std::optional<std::size_t> finger;
        bool hasMoved = false;
    };

    std::optional<std::size_t> fingerFor (const Resting&, const std::array<bool, mostFingers>& isFree) const;
    bool isHeld (std::size_t finger) const;

    mutable std::mutex mutex;        ///< For all that follows.
    std::vector<Resting> touches;    ///< In the order in which they came.
    std::vector<std::size_t> lifted; ///< Fingers whose touches have left since the last call.
    std::int64_t droppedTouches = 0;
};
} // namespace antinode
