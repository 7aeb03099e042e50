#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace antinode
{
/** A struct of type T, const or not: what `fields` functions are written for. `void fields (auto& stream, Struct<T>
    auto&)` calls the stream with all fields of a struct, which it takes apart by a structured binding: a field that is
    added to the struct and forgotten there does not compile. */
template <typename Type, typename T>
concept Struct = std::same_as<std::remove_const_t<Type>, T>;

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
