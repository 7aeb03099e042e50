#pragma once

#include "TouchFault.h"

#include <cstdint>
#include <optional>

namespace antinode
{
enum class TouchKind
{
    focusAt, ///< Plays a focus at a place.
    stopAll, ///< Fades every voice out; place and amplitude mean nothing.
    rest,    ///< A finger rests at a place, or has moved there.
    lift     ///< A finger has left; the place means nothing.
};

/** What a finger, or a program in its place, requests. Units are those of the sender. */
struct Touch
{
    TouchKind kind = TouchKind::focusAt;
    bool inMillimetres = false; ///< Else x and y are fractions of the surface, 0 to 1, y upwards.
    double x = 0, y = 0;
    double amplitude = 1;    ///< Times the velocity that the focus was designed for, 0 to 1.
    std::int64_t finger = 0; ///< Of `rest` and `lift`: which one, the same from touch to touch.

    bool operator== (const Touch&) const = default;
};

/** The fault of a touch: numbers that are not finite, fractions outside the surface. [any] */
std::optional<TouchFault> findFault (const Touch&);
} // namespace antinode
