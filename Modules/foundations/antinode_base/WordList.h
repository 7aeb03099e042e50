#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace antinode
{
/** Words of a file and their values. */
template <typename T, std::size_t count>
using WordList = std::array<std::pair<std::string_view, T>, count>;

/** The words alone. [any] */
template <typename T, std::size_t count>
std::vector<std::string_view> listWords (const WordList<T, count>& list)
{
    std::vector<std::string_view> words;

    for (const auto& [word, value] : list)
        words.push_back (word);

    return words;
}

/** The word for a value that the list has. [any] */
template <typename T, std::size_t count>
constexpr std::string_view wordFor (const WordList<T, count>& list, T wanted)
{
    return std::find_if (list.begin(), list.end(), [&] (const auto& entry) { return entry.second == wanted; })->first;
}
} // namespace antinode
