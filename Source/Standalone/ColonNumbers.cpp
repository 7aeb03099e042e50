#include "ColonNumbers.h"

#include <charconv>
#include <cmath>

namespace antinode
{
std::optional<std::vector<double>> colonNumbers (std::string_view text)
{
    std::vector<double> numbers;
    const auto* at = text.data();
    const auto* const end = at + text.size();

    for (;;)
    {
        auto& number = numbers.emplace_back();
        const auto [behind, error] = std::from_chars (at, end, number);

        if (error != std::errc() || ! std::isfinite (number) || (behind != end && *behind != ':'))
            return std::nullopt;

        if (behind == end)
            return numbers;

        at = behind + 1;
    }
}
} // namespace antinode
