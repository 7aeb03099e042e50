#pragma once

#include <array>
#include <string>

namespace antinode
{
/** The input of the audio device that each finger of Antinode Touch feels, counted from 0. Several may feel one. */
struct FingerInputs
{
    static constexpr int none = -1, fingers = 8;

    std::array<int, fingers> inputs { 0, 1, 2, 3, 4, 5, 6, 7 }; ///< Of each finger; `none`: it feels nothing.

    bool operator== (const FingerInputs&) const = default;
};

/** From a list "1,2,5" that counts from 1, 0 for none, and leaves out the last fingers, which then have none.
    @throws InputError  where it is no such list [any] */
FingerInputs readFingerInputs (const std::string& list);
} // namespace antinode
