#include "SvgNumbers.h"

#include <charconv>
#include <cmath>
#include <numbers>

namespace antinode
{
namespace
{
bool isBlank (char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

bool isLetter (char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

Eigen::Affine2d affine (double a, double b, double c, double d, double e, double f)
{
    Eigen::Affine2d map;
    map.matrix() << a, c, e, b, d, f, 0, 0, 1;
    return map;
}

/** One transform by its name and values; nothing where their number is wrong. */
std::optional<Eigen::Affine2d> namedTransform (std::string_view name, const std::vector<double>& v)
{
    const auto radians = [] (double degrees) { return degrees * std::numbers::pi / 180; };
    const auto count = v.size();

    if (name == "matrix" && count == 6)
        return affine (v[0], v[1], v[2], v[3], v[4], v[5]);

    if (name == "translate" && (count == 1 || count == 2))
        return affine (1, 0, 0, 1, v[0], count == 2 ? v[1] : 0);

    if (name == "scale" && (count == 1 || count == 2))
        return affine (v[0], 0, 0, count == 2 ? v[1] : v[0], 0, 0);

    if (name == "rotate" && (count == 1 || count == 3))
    {
        const auto sine = std::sin (radians (v[0])), cosine = std::cos (radians (v[0]));
        const Eigen::Translation2d centre (count == 3 ? v[1] : 0, count == 3 ? v[2] : 0);
        return centre * affine (cosine, sine, -sine, cosine, 0, 0) * centre.inverse();
    }

    if (name == "skewX" && count == 1)
        return affine (1, 0, std::tan (radians (v[0])), 1, 0, 0);

    if (name == "skewY" && count == 1)
        return affine (1, std::tan (radians (v[0])), 0, 1, 0, 0);

    return std::nullopt;
}
} // namespace

void SvgNumbers::skipBlanks (bool andComma)
{
    for (; ! rest.empty() && (isBlank (rest.front()) || (andComma && rest.front() == ',')); rest.remove_prefix (1))
        andComma = andComma && rest.front() != ',';
}

std::optional<double> SvgNumbers::number()
{
    skipBlanks (true);
    auto digits = rest;

    if (! digits.empty() && digits.front() == '+')
        digits.remove_prefix (1);

    // from_chars also reads "inf" and "nan".
    const auto sign = ! digits.empty() && digits.front() == '-' ? std::size_t { 1 } : 0;

    if (digits.size() <= sign || isLetter (digits[sign]))
        return std::nullopt;

    double value = 0;
    const auto [end, error] = std::from_chars (digits.data(), digits.data() + digits.size(), value);

    if (error != std::errc() || ! std::isfinite (value))
        return std::nullopt;

    rest.remove_prefix (static_cast<std::size_t> (end - rest.data()));
    return value;
}

std::optional<bool> SvgNumbers::flag()
{
    skipBlanks (true);

    if (rest.empty() || (rest.front() != '0' && rest.front() != '1'))
        return std::nullopt;

    const auto value = rest.front() == '1';
    rest.remove_prefix (1);
    return value;
}

char SvgNumbers::letter()
{
    skipBlanks (false);

    if (rest.empty() || ! isLetter (rest.front()))
        return 0;

    const auto found = rest.front();
    rest.remove_prefix (1);
    return found;
}

bool SvgNumbers::isAtEnd()
{
    skipBlanks (false);
    return rest.empty();
}

std::optional<std::vector<double>> svgNumberList (std::string_view text)
{
    SvgNumbers numbers (text);
    std::vector<double> values;

    while (! numbers.isAtEnd())
    {
        const auto value = numbers.number();

        if (! value)
            return std::nullopt;

        values.push_back (*value);
    }

    return values;
}

std::optional<Eigen::Affine2d> svgTransform (std::string_view text)
{
    Eigen::Affine2d whole = Eigen::Affine2d::Identity();

    while (true)
    {
        const auto begin = text.find_first_not_of (" \t\r\n\f,");

        if (begin == std::string_view::npos)
            return whole;

        const auto open = text.find ('(', begin), close = text.find (')', begin);

        if (open == std::string_view::npos || close == std::string_view::npos || close < open)
            return std::nullopt;

        auto name = text.substr (begin, open - begin);
        name = name.substr (0, name.find_last_not_of (" \t\r\n\f") + 1);
        const auto values = svgNumberList (text.substr (open + 1, close - open - 1));
        const auto next = values ? namedTransform (name, *values) : std::nullopt;

        if (! next)
            return std::nullopt;

        whole = whole * *next;
        text.remove_prefix (close + 1);
    }
}
} // namespace antinode
