#pragma once

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
    int place = 0;        ///< Of the bank.
    double amplitude = 1; ///< Of a trigger: times the velocity that the focus was designed for, 0 to 1.
};

/** [any] */
inline bool isStop (const FocusEvent& event)
{
    return event.kind == FocusEventKind::stopAll;
}
} // namespace antinode
