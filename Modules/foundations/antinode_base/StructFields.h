#pragma once

#include <concepts>
#include <type_traits>

namespace antinode
{
/** A struct of type T, const or not: what `fields` functions are written for. `void fields (auto& stream, Struct<T>
    auto&)` calls the stream with all fields of a struct, which it takes apart by a structured binding: a field that is
    added to the struct and forgotten there does not compile. */
template <typename Type, typename T>
concept Struct = std::same_as<std::remove_const_t<Type>, T>;
} // namespace antinode
