#include "ResponseUnit.h"

#include <antinode_universal/UniversalRecordText.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace antinode
{
namespace
{
/** A product of powers of units: its size in SI units and the exponents of metre, second, newton and volt. */
struct Dimensions
{
    double factor = 1;
    std::array<int, 4> exponents {};
};

struct UnitSymbol
{
    std::string_view symbol;
    Dimensions unit;
};

constexpr double gravity = 9.80665, inch = 0.0254, poundForce = 4.4482216152605;

const std::array symbols {
    UnitSymbol { "m", { 1, { 1, 0, 0, 0 } } },
    UnitSymbol { "cm", { 1e-2, { 1, 0, 0, 0 } } },
    UnitSymbol { "mm", { 1e-3, { 1, 0, 0, 0 } } },
    UnitSymbol { "um", { 1e-6, { 1, 0, 0, 0 } } },
    UnitSymbol { "nm", { 1e-9, { 1, 0, 0, 0 } } },
    UnitSymbol { "pm", { 1e-12, { 1, 0, 0, 0 } } },
    UnitSymbol { "in", { inch, { 1, 0, 0, 0 } } },
    UnitSymbol { "s", { 1, { 0, 1, 0, 0 } } },
    UnitSymbol { "sec", { 1, { 0, 1, 0, 0 } } },
    UnitSymbol { "g", { gravity, { 1, -2, 0, 0 } } },
    UnitSymbol { "gn", { gravity, { 1, -2, 0, 0 } } },
    UnitSymbol { "N", { 1, { 0, 0, 1, 0 } } },
    UnitSymbol { "mN", { 1e-3, { 0, 0, 1, 0 } } },
    UnitSymbol { "kN", { 1e3, { 0, 0, 1, 0 } } },
    UnitSymbol { "lbf", { poundForce, { 0, 0, 1, 0 } } },
    UnitSymbol { "V", { 1, { 0, 0, 0, 1 } } },
    UnitSymbol { "mV", { 1e-3, { 0, 0, 0, 1 } } },
    UnitSymbol { "kV", { 1e3, { 0, 0, 0, 1 } } },
    UnitSymbol { "kg", { 1, { -1, 2, 1, 0 } } },
    UnitSymbol { "1", {} },
};

/** Reads products and quotients of powers, with brackets; a blank multiplies. */
class UnitText
{
public:
    explicit UnitText (std::string_view unit) : text (unit) {}

    std::optional<Dimensions> all()
    {
        auto found = product (0);
        return at == text.size() ? found : std::nullopt;
    }

private:
    static Dimensions power (Dimensions unit, int exponent)
    {
        unit.factor = std::pow (unit.factor, exponent);

        for (auto& each : unit.exponents)
            each *= exponent;

        return unit;
    }

    static bool isOpening (char character) { return character == '(' || character == '['; }
    static bool isClosing (char character) { return character == ')' || character == ']'; }
    bool isLetter() const { return at < text.size() && std::isalpha (static_cast<unsigned char> (text[at])) != 0; }
    bool isDigit() const { return at < text.size() && text[at] >= '0' && text[at] <= '9'; }

    std::optional<Dimensions> product (int depth)
    {
        std::optional<Dimensions> result = Dimensions {};
        auto sign = 1;

        while (result && at < text.size() && ! isClosing (text[at]))
        {
            if (text[at] == '/' || text[at] == '*' || text[at] == ' ' || text[at] == '.')
            {
                sign = text[at] == '/' ? -1 : text[at] == ' ' ? sign : 1;
                ++at;
                continue;
            }

            const auto next = factor (depth);
            result = next ? multiplied (*result, power (*next, sign)) : std::optional<Dimensions> {};
            sign = 1;
        }

        return result;
    }

    static std::optional<Dimensions> multiplied (Dimensions one, const Dimensions& other)
    {
        one.factor *= other.factor;

        for (std::size_t i = 0; i < one.exponents.size(); ++i)
            one.exponents[i] += other.exponents[i];

        return one;
    }

    std::optional<Dimensions> factor (int depth)
    {
        constexpr int deepest = 8;
        std::optional<Dimensions> found;

        if (isOpening (text[at]) && depth < deepest)
        {
            ++at;
            found = product (depth + 1);

            if (at >= text.size())
                return std::nullopt;

            ++at;
        }
        else
            found = symbol();

        return found ? power (*found, exponent()) : found;
    }

    std::optional<Dimensions> symbol()
    {
        const auto begin = at;

        while (isLetter())
            ++at;

        if (at == begin && at < text.size() && text[at] == '1')
            ++at;

        const auto name = text.substr (begin, at - begin);
        const auto* const found =
            std::find_if (symbols.begin(), symbols.end(), [&] (const auto& each) { return each.symbol == name; });
        return found == symbols.end() ? std::nullopt : std::optional (found->unit);
    }

    /** "^2", "2", "^-1", "-1"; else 1. */
    int exponent()
    {
        at += at < text.size() && text[at] == '^' ? 1 : 0;
        const auto isNegative = at + 1 < text.size() && text[at] == '-';
        at += isNegative ? 1 : 0;

        if (! isDigit())
            return 1;

        const auto number = text[at++] - '0';
        return isNegative ? -number : number;
    }

    std::string_view text;
    std::size_t at = 0;
};

std::optional<Dimensions> parseDimensions (std::string_view text)
{
    constexpr std::size_t longest = 60;
    auto plain = plainText (text, longest);

    for (auto stars = plain.find ("**"); stars != std::string::npos; stars = plain.find ("**"))
        plain.replace (stars, 2, "^");

    return plain.empty() || plain.size() == longest ? std::nullopt : UnitText (plain).all();
}

std::optional<DriveQuantity> findDrive (const std::array<int, 4>& exponents, int sign)
{
    if (exponents[2] == sign && exponents[3] == 0)
        return DriveQuantity::force;

    return exponents[2] == 0 && exponents[3] == sign ? std::optional (DriveQuantity::voltage) : std::nullopt;
}
} // namespace

std::optional<ResponseUnit> responseUnit (std::string_view text)
{
    const auto found = parseDimensions (text);

    if (! found || found->exponents[0] != 1 || found->exponents[1] > 0 || found->exponents[1] < -2)
        return std::nullopt;

    const auto drive = findDrive (found->exponents, -1);

    if (! drive && (found->exponents[2] != 0 || found->exponents[3] != 0))
        return std::nullopt;

    constexpr ResponseQuantity quantities[] = { ResponseQuantity::displacement, ResponseQuantity::velocity,
                                                ResponseQuantity::acceleration };
    return ResponseUnit { quantities[-found->exponents[1]], found->factor, drive };
}

std::optional<ResponseUnit> driveUnit (std::string_view text)
{
    const auto found = parseDimensions (text);

    if (! found || found->exponents[0] != 0 || found->exponents[1] != 0)
        return std::nullopt;

    const auto drive = findDrive (found->exponents, 1);
    return drive ? std::optional (ResponseUnit { std::nullopt, found->factor, drive }) : std::nullopt;
}

std::optional<ResponseUnit> quantityWord (std::string_view word)
{
    struct Word
    {
        std::string_view text;
        ResponseUnit unit;
    };

    static constexpr std::array words {
        Word { "displacement", { ResponseQuantity::displacement, 1, {} } },
        Word { "receptance", { ResponseQuantity::displacement, 1, DriveQuantity::force } },
        Word { "compliance", { ResponseQuantity::displacement, 1, DriveQuantity::force } },
        Word { "velocity", { ResponseQuantity::velocity, 1, {} } },
        Word { "mobility", { ResponseQuantity::velocity, 1, DriveQuantity::force } },
        Word { "acceleration", { ResponseQuantity::acceleration, 1, {} } },
        Word { "accelerance", { ResponseQuantity::acceleration, 1, DriveQuantity::force } },
        Word { "inertance", { ResponseQuantity::acceleration, 1, DriveQuantity::force } },
    };
    std::string lower (word);
    std::transform (lower.begin(), lower.end(), lower.begin(),
                    [] (unsigned char c) { return static_cast<char> (std::tolower (c)); });
    const auto* const found =
        std::find_if (words.begin(), words.end(), [&] (const auto& each) { return each.text == lower; });
    return found == words.end() ? std::nullopt : std::optional (found->unit);
}
} // namespace antinode
