#include "OscMessage.h"

#include <type_traits>

namespace antinode
{
std::optional<double> toNumber (const OscArgument& argument)
{
    return std::visit (
        [] (const auto& value) -> std::optional<double>
        {
            using Value = std::decay_t<decltype (value)>;

            if constexpr (std::is_arithmetic_v<Value> && ! std::is_same_v<Value, bool>)
                return static_cast<double> (value);
            else
                return std::nullopt;
        },
        argument);
}
} // namespace antinode
