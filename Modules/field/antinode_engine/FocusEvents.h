#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace antinode
{
enum class FocusEventKind
{
    trigger, ///< Plays the focus of a place.
    release, ///< A note-off: what it does is up to the player's settings.
    stopAll  ///< Fades every voice out.
};

/** An event for the player, accurate to the sample. */
struct FocusEvent
{
    int offset = 0; ///< Sample of the block, 0 to its length - 1; events come in the order of their offsets.
    FocusEventKind kind = FocusEventKind::trigger;
    int place = 0;             ///< Of the bank.
    double amplitude = 1;      ///< Of a trigger: times the velocity that the focus was designed for, 0 to 1.
    std::uint32_t request = 0; ///< Of a trigger: whose answer tells when it plays; 0: nobody waits for one.
};

/** [any] */
inline bool isStop (const FocusEvent& event)
{
    return event.kind == FocusEventKind::stopAll;
}

/** Events that come out a number of samples later, in the order in which they came, whatever the blocks are. A delay
    that becomes shorter never lets an event overtake an earlier one. A stop does not wait, and what waits then is void.
 */
class EventDelay
{
public:
    static constexpr std::size_t mostWaiting = 4096;  ///< Events beyond these are left out.
    static constexpr std::size_t mostPerBlock = 1024; ///< Those beyond come at the start of the next block.

    /** @param events  of this block, in the order of their offsets
        @param count   samples of the block
        @param delay   samples, 0 or more
        @param isHeld  only stops come out: what is due waits until it may
        @return        those that fall into this block; valid until the next call
        [audio thread] allocates nothing, locks nothing */
    std::span<const FocusEvent> process (std::span<const FocusEvent> events, int count, std::int64_t delay,
                                         bool isHeld = false);

    /** As if no event had come. [audio thread] */
    void reset() { first = waiting = 0; }

private:
    struct Waiting
    {
        std::int64_t due = 0; ///< Sample of the clock.
        FocusEvent event;
    };

    void takeDue (std::int64_t end);

    std::array<Waiting, mostWaiting> ring {};
    std::array<FocusEvent, mostPerBlock> out {};
    std::size_t taken = 0;               ///< Of `out`.
    std::size_t first = 0, waiting = 0;  ///< In the ring.
    std::int64_t clock = 0, lastDue = 0; ///< Samples.
};
} // namespace antinode
