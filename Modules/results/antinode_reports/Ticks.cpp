#include "Ticks.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace antinode
{
namespace
{
// Beyond this, differences and products of two values would overflow.
constexpr double largest = 1e150;

// Below this fraction of its values a span has too few digits left to tell ticks apart.
constexpr double minimumRelativeSpan = 1e-9;
} // namespace

AxisRange usableRange (AxisRange range)
{
    if (! std::isfinite (range.minimum) || ! std::isfinite (range.maximum))
        return {};

    const auto low = std::clamp (std::min (range.minimum, range.maximum), -largest, largest);
    const auto high = std::clamp (std::max (range.minimum, range.maximum), -largest, largest);
    const auto magnitude = std::max (std::abs (low), std::abs (high));
    if (magnitude < 1 / largest)
        return { -1, 1 };
    if (high - low >= minimumRelativeSpan * magnitude)
        return { low, high };
    return { low - 0.1 * magnitude, high + 0.1 * magnitude };
}

double niceStep (double span, int maximumParts)
{
    const auto raw = span / std::max (1, maximumParts);
    const auto decade = std::pow (10.0, std::floor (std::log10 (raw)));
    for (const auto factor : { 1.0, 2.0, 5.0 })
        if (factor * decade >= raw * (1 - 1e-9))
            return factor * decade;
    return 10 * decade;
}

std::vector<double> linearTicks (AxisRange range, int maximumTicks)
{
    const auto [low, high] = usableRange (range);
    std::vector<double> ticks;
    for (auto parts = std::max (1, maximumTicks); ticks.size() < 2 && parts <= 4 * std::max (1, maximumTicks); ++parts)
    {
        const auto step = niceStep (high - low, parts);
        const auto first = std::ceil (low / step - 1e-6);
        const auto count = static_cast<std::size_t> (std::max (0.0, std::floor (high / step + 1e-6) - first + 1));
        ticks.resize (count);
        for (std::size_t k = 0; k < count; ++k)
            ticks[k] = (first + static_cast<double> (k)) * step;
    }
    return ticks;
}

std::vector<double> decadeTicks (AxisRange range, int maximumTicks)
{
    const auto first = static_cast<int> (std::ceil (std::log10 (range.minimum) - 1e-9));
    const auto last = static_cast<int> (std::floor (std::log10 (range.maximum) + 1e-9));
    const auto parts = std::max (1, maximumTicks);
    const auto stride = std::max (1, (last - first + parts) / parts);
    std::vector<double> ticks;
    for (auto exponent = first; exponent <= last; exponent += stride)
        ticks.push_back (std::pow (10.0, exponent));
    return ticks;
}

AxisRange niceRange (AxisRange range, int maximumParts)
{
    const auto [low, high] = usableRange (range);
    const auto step = niceStep (high - low, maximumParts);
    return { std::floor (low / step + 1e-6) * step, std::ceil (high / step - 1e-6) * step };
}

namespace
{
constexpr auto minus = "\u2212";
constexpr auto thinSpace = "\u202F";

std::string plainDigits (double magnitude, int decimals)
{
    // 309 digits before the point, and the decimals.
    std::array<char, 400> text {};
    const auto places = std::clamp (decimals, 0, 60);
    const auto end =
        std::to_chars (text.data(), text.data() + text.size(), magnitude, std::chars_format::fixed, places).ptr;
    return { text.data(), end };
}

std::string withThousands (const std::string& digits)
{
    const auto whole = std::min (digits.find ('.'), digits.size());
    if (whole < 5)
        return digits;
    std::string spaced;
    for (std::size_t k = 0; k < whole; ++k)
    {
        if (k > 0 && (whole - k) % 3 == 0)
            spaced += thinSpace;
        spaced += digits[k];
    }
    return spaced + digits.substr (whole);
}

int decimalExponent (double value)
{
    return static_cast<int> (std::floor (std::log10 (std::abs (value)) + 1e-12));
}
} // namespace

std::string formatFixed (double value, int decimals)
{
    if (! std::isfinite (value))
        return "\u2013";
    const auto digits = plainDigits (std::abs (value), decimals);
    const auto isZero = digits.find_first_not_of ("0.") == std::string::npos;
    return (value < 0 && ! isZero ? minus : "") + withThousands (digits);
}

std::string formatNumber (double value, int significantDigits)
{
    if (! std::isfinite (value) || value == 0)
        return formatFixed (value, 0);
    // The exponent after rounding: 9.996 is 10.0, not 10.00.
    std::array<char, 80> text {};
    const auto decimals = std::clamp (significantDigits, 1, 17) - 1;
    const auto end =
        std::to_chars (text.data(), text.data() + text.size(), value, std::chars_format::scientific, decimals).ptr;
    const std::string scientific (text.data(), end);
    const auto split = scientific.find ('e');
    const auto exponent = std::stoi (scientific.substr (split + 1));
    if (exponent >= -3 && exponent < 5)
        return formatFixed (value, std::max (0, decimals - exponent));
    const auto digits = scientific.substr (value < 0 ? 1 : 0, split - (value < 0 ? 1 : 0));
    return (value < 0 ? minus : "") + digits + powerOfTen (exponent);
}

int commonExponent (AxisRange range)
{
    const auto magnitude = std::max (std::abs (range.minimum), std::abs (range.maximum));
    if (! std::isfinite (magnitude) || magnitude == 0 || (magnitude >= 0.01 && magnitude < 1e5))
        return 0;
    return 3 * static_cast<int> (std::floor (decimalExponent (magnitude) / 3.0));
}

std::string superscript (int exponent)
{
    constexpr std::array<const char*, 10> raised { "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹" };
    std::string text = exponent < 0 ? "⁻" : "";
    for (const auto digit : std::to_string (std::abs (exponent)))
        text += raised[static_cast<std::size_t> (digit - '0')];
    return text;
}

std::string powerOfTen (int exponent)
{
    return exponent == 0 ? std::string() : "×10" + superscript (exponent);
}

std::vector<std::string> tickLabels (const std::vector<double>& ticks, int exponent)
{
    const auto factor = std::pow (10.0, -exponent);
    const auto step = ticks.size() > 1 ? std::abs (ticks[1] - ticks[0]) * factor : 1.0;
    const auto decimals = step > 0 ? std::max (0, -decimalExponent (step)) : 0;
    std::vector<std::string> labels;
    labels.reserve (ticks.size());
    for (const auto tick : ticks)
        labels.push_back (formatFixed (tick * factor, decimals));
    return labels;
}
} // namespace antinode
