#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** A cursor of TUIO 1.1 where it is now. */
struct TuioCursor
{
    std::int32_t session = 0;
    double x = 0, y = 0; ///< Fractions of the surface; y points down.
};

/** The content of the messages of the profile 2Dcur up to an fseq. */
struct TuioFrame
{
    std::string source; ///< application@address; empty if the sender does not say.
    std::optional<std::vector<std::int32_t>> alive;
    std::vector<TuioCursor> cursors; ///< Those that are new or have moved.
    std::int32_t sequence = -1;
};
} // namespace antinode
