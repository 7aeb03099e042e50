#pragma once

#include <initializer_list>
#include <optional>
#include <string_view>

namespace antinode
{
/** A number as a person types it, with a decimal point or a decimal comma, and a unit or none: "0.5", "0,5", " -3 mm".
    @param units  what may stand behind it; whether letters are small does not matter, a micro sign may be a u
    @return       none where the text says anything else, or no finite number [any] */
std::optional<double> typedNumber (std::string_view text, std::initializer_list<std::string_view> units = {});
} // namespace antinode
