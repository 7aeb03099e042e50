#include "ResponseUnit.h"

#include "UniversalRecords.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

namespace antinode
{
namespace
{
std::optional<DriveQuantity> findDrive (const std::array<int, 4>& exponents, int sign)
{
    if (exponents[2] == sign && exponents[3] == 0)
        return DriveQuantity::force;

    return exponents[2] == 0 && exponents[3] == sign ? std::optional (DriveQuantity::voltage) : std::nullopt;
}

/** "(m/s^2)(N)": the units of motion and drive side by side, which stand for their ratio. */
std::optional<ResponseUnit> unitSideBySide (std::string_view text)
{
    const auto end = text.find_first_of (")]"),
               begin = text.find_first_not_of (' ', std::min (end, text.size() - 1) + 1);

    if (text.empty() || begin == std::string_view::npos || (text[begin] != '(' && text[begin] != '['))
        return std::nullopt;

    const auto motion = responseUnit (text.substr (0, end + 1));
    const auto drive = driveUnit (text.substr (begin));

    if (! motion || ! drive || motion->drive)
        return std::nullopt;

    return ResponseUnit { motion->quantity, motion->factor / drive->factor, drive->drive };
}
} // namespace

std::optional<ResponseUnit> responseUnit (std::string_view text)
{
    const auto found = physicalUnit (text);

    if (! found || found->exponents[0] != 1 || found->exponents[1] > 0 || found->exponents[1] < -2)
        return std::nullopt;

    const auto drive = findDrive (found->exponents, -1);

    if (! drive && (found->exponents[2] != 0 || found->exponents[3] != 0))
        return unitSideBySide (text);

    constexpr ResponseQuantity quantities[] = { ResponseQuantity::displacement, ResponseQuantity::velocity,
                                                ResponseQuantity::acceleration };
    return ResponseUnit { quantities[-found->exponents[1]], found->factor, drive };
}

std::optional<ResponseUnit> driveUnit (std::string_view text)
{
    const auto found = physicalUnit (text);

    if (! found || found->exponents[0] != 0 || found->exponents[1] != 0)
        return std::nullopt;

    const auto drive = findDrive (found->exponents, 1);
    return drive ? std::optional (ResponseUnit { std::nullopt, found->factor, drive }) : std::nullopt;
}

bool isUnknownUnit (std::string_view label)
{
    constexpr std::array<std::string_view, 11> none { "none", "ratio", "unknown",  "n/a",           "eu",  "si",
                                                      "1",    "-",     "unitless", "dimensionless", "a.u." };
    auto lower = trimmedText (label);
    std::transform (lower.begin(), lower.end(), lower.begin(),
                    [] (unsigned char c) { return static_cast<char> (std::tolower (c)); });
    return ! lower.empty() && std::find (none.begin(), none.end(), lower) == none.end() && ! responseUnit (label)
           && ! driveUnit (label);
}

std::string unknownUnitRemark (const std::string& source, const std::string& label)
{
    return source + ": " + inQuotes (label)
           + " is not a known unit of a motion, a force or a voltage, so it counts as not stated; options such as "
             "--response-unit state it.";
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
        Word { "disp", { ResponseQuantity::displacement, 1, {} } },
        Word { "vel", { ResponseQuantity::velocity, 1, {} } },
        Word { "acc", { ResponseQuantity::acceleration, 1, {} } },
        Word { "accel", { ResponseQuantity::acceleration, 1, {} } },
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

namespace
{
struct NamedUnit
{
    std::string_view name;
    PhysicalUnit unit;
};

constexpr double gravity = 9.80665, inch = 0.0254, foot = 0.3048, poundForce = 4.4482216152605, dyne = 1e-5;
constexpr PhysicalUnit metres { 1, { 1, 0, 0, 0 } }, seconds { 1, { 0, 1, 0, 0 } }, newtons { 1, { 0, 0, 1, 0 } },
    volts { 1, { 0, 0, 0, 1 } };

constexpr PhysicalUnit ofLength (double metre)
{
    return { metre, { 1, 0, 0, 0 } };
}

constexpr PhysicalUnit ofSpeed (double metrePerSecond)
{
    return { metrePerSecond, { 1, -1, 0, 0 } };
}

constexpr PhysicalUnit ofAcceleration (double metrePerSecondSquared)
{
    return { metrePerSecondSquared, { 1, -2, 0, 0 } };
}

constexpr PhysicalUnit ofForce (double newton)
{
    return { newton, { 0, 0, 1, 0 } };
}

/** Symbols and names that take no prefix. */
constexpr std::array plainUnits {
    NamedUnit { "1", {} },
    NamedUnit { "rms", {} },
    NamedUnit { "in", ofLength (inch) },
    NamedUnit { "inch", ofLength (inch) },
    NamedUnit { "inche", ofLength (inch) },
    NamedUnit { "mil", ofLength (inch / 1000) },
    NamedUnit { "thou", ofLength (inch / 1000) },
    NamedUnit { "ft", ofLength (foot) },
    NamedUnit { "foot", ofLength (foot) },
    NamedUnit { "feet", ofLength (foot) },
    NamedUnit { "micron", ofLength (1e-6) },
    NamedUnit { "sec", seconds },
    NamedUnit { "ips", ofSpeed (inch) },
    NamedUnit { "fps", ofSpeed (foot) },
    NamedUnit { "mps", ofSpeed (1) },
    NamedUnit { "G", ofAcceleration (gravity) },
    NamedUnit { "g's", ofAcceleration (gravity) },
    NamedUnit { "gs", ofAcceleration (gravity) },
    NamedUnit { "g0", ofAcceleration (gravity) },
    NamedUnit { "g_n", ofAcceleration (gravity) },
    NamedUnit { "gee", ofAcceleration (gravity) },
    NamedUnit { "grav", ofAcceleration (gravity) },
    NamedUnit { "gravity", ofAcceleration (gravity) },
    NamedUnit { "lb", ofForce (poundForce) },
    NamedUnit { "lbf", ofForce (poundForce) },
    NamedUnit { "lb_f", ofForce (poundForce) },
    NamedUnit { "lbsf", ofForce (poundForce) },
    NamedUnit { "pound", ofForce (poundForce) },
    NamedUnit { "kip", ofForce (1000 * poundForce) },
    NamedUnit { "oz", ofForce (poundForce / 16) },
    NamedUnit { "ozf", ofForce (poundForce / 16) },
    NamedUnit { "kgf", ofForce (gravity) },
    NamedUnit { "kg_f", ofForce (gravity) },
    NamedUnit { "kp", ofForce (gravity) },
    NamedUnit { "gf", ofForce (gravity / 1000) },
    NamedUnit { "tf", ofForce (1000 * gravity) },
    NamedUnit { "dyn", ofForce (dyne) },
    NamedUnit { "dyne", ofForce (dyne) },
    NamedUnit { "kg", { 1, { -1, 2, 1, 0 } } },
    NamedUnit { "Nm", { 1, { 1, 0, 1, 0 } } },
};

/** Symbols before which a prefix may stand. */
constexpr std::array prefixedSymbols {
    NamedUnit { "m", metres },
    NamedUnit { "s", seconds },
    NamedUnit { "N", newtons },
    NamedUnit { "V", volts },
    NamedUnit { "Gal", { 0.01, { 1, -2, 0, 0 } } },
    NamedUnit { "gn", { gravity, { 1, -2, 0, 0 } } },
    NamedUnit { "g", { gravity, { 1, -2, 0, 0 } } },
};

constexpr std::array prefixedNames {
    NamedUnit { "meter", metres },   NamedUnit { "metre", metres }, NamedUnit { "second", seconds },
    NamedUnit { "newton", newtons }, NamedUnit { "volt", volts },   NamedUnit { "gal", { 0.01, { 1, -2, 0, 0 } } },
};

using Prefix = std::pair<std::string_view, double>;
constexpr std::array<Prefix, 10> prefixes { {
    { "", 1 },
    { "p", 1e-12 },
    { "n", 1e-9 },
    { "u", 1e-6 },
    { "m", 1e-3 },
    { "c", 1e-2 },
    { "d", 0.1 },
    { "da", 10 },
    { "k", 1e3 },
    { "M", 1e6 },
} };
constexpr std::array<Prefix, 6> prefixNames { {
    { "", 1 },
    { "nano", 1e-9 },
    { "micro", 1e-6 },
    { "milli", 1e-3 },
    { "centi", 1e-2 },
    { "kilo", 1e3 },
} };

bool isSame (std::string_view one, std::string_view other, bool ignoresCase)
{
    const auto lower = [] (char c) { return std::tolower (static_cast<unsigned char> (c)); };
    return ignoresCase ? std::equal (one.begin(), one.end(), other.begin(), other.end(),
                                     [&] (char a, char b) { return lower (a) == lower (b); })
                       : one == other;
}

template <typename Prefixes, typename Units>
std::optional<PhysicalUnit> prefixedUnit (std::string_view name, const Prefixes& prefixList, const Units& units,
                                          bool ignoresCase)
{
    for (const auto& [prefix, factor] : prefixList)
        for (const auto& each : units)
            if (name.size() == prefix.size() + each.name.size()
                && isSame (name.substr (0, prefix.size()), prefix, ignoresCase)
                && isSame (name.substr (prefix.size()), each.name, ignoresCase))
                return PhysicalUnit { factor * each.unit.factor, each.unit.exponents };

    return std::nullopt;
}

std::optional<PhysicalUnit> namedUnit (std::string_view name)
{
    for (const auto ignoresCase : { false, true })
    {
        for (const auto& each : plainUnits)
            if (isSame (name, each.name, ignoresCase))
                return each.unit;

        if (const auto found = prefixedUnit (name, prefixes, prefixedSymbols, ignoresCase))
            return found;

        if (const auto found = prefixedUnit (name, prefixNames, prefixedNames, ignoresCase))
            return found;
    }

    // A plural, or an effective value as in "grms", whose ratio to another one is that of peaks.
    constexpr std::size_t shortest = 2;

    for (const std::string_view ending : { "rms", "s" })
        if (const auto stem = name.substr (0, name.size() - std::min (name.size(), ending.size()));
            isSame (name.substr (stem.size()), ending, true) && (stem.size() >= shortest || ending.size() > 1)
            && ! stem.empty())
            return namedUnit (stem);

    return std::nullopt;
}

PhysicalUnit multiplied (PhysicalUnit one, const PhysicalUnit& other)
{
    one.factor *= other.factor;

    for (std::size_t i = 0; i < one.exponents.size(); ++i)
        one.exponents[i] += other.exponents[i];

    return one;
}

PhysicalUnit raised (PhysicalUnit unit, int exponent)
{
    unit.factor = std::pow (unit.factor, exponent);

    for (auto& each : unit.exponents)
        each *= exponent;

    return unit;
}

/** Reads products and quotients of powers, with brackets; a blank multiplies. */
class UnitText
{
public:
    explicit UnitText (std::string_view unit) : text (unit) {}

    std::optional<PhysicalUnit> all()
    {
        const auto scale = number();
        auto found = product (0);

        if (found)
            found->factor *= scale;

        return at == text.size() ? found : std::nullopt;
    }

private:
    static bool isOpening (char character) { return character == '(' || character == '[' || character == '{'; }
    static bool isClosing (char character) { return character == ')' || character == ']' || character == '}'; }
    bool isDigit() const { return at < text.size() && text[at] >= '0' && text[at] <= '9'; }

    bool isLetter() const
    {
        return at < text.size()
               && (std::isalpha (static_cast<unsigned char> (text[at])) != 0 || text[at] == '\'' || text[at] == '_');
    }

    /** The number before a unit, as in "1e-6 m/s"; 1 where there is none. */
    double number()
    {
        double value = 1;
        const auto read = std::from_chars (text.data(), text.data() + text.size(), value);

        if (! isDigit() || read.ec != std::errc {} || ! (value > 0 && std::isfinite (value)))
            return 1;

        at = static_cast<std::size_t> (read.ptr - text.data());
        return at < text.size() && text[at] == '^' ? std::pow (value, exponent()) : value;
    }

    std::optional<PhysicalUnit> product (int depth)
    {
        std::optional<PhysicalUnit> result = PhysicalUnit {};
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
            result = next ? multiplied (*result, raised (*next, sign)) : std::optional<PhysicalUnit> {};
            sign = 1;
        }

        return result;
    }

    std::optional<PhysicalUnit> factor (int depth)
    {
        constexpr int deepest = 8;
        std::optional<PhysicalUnit> found;

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

        return found ? raised (*found, exponent()) : found;
    }

    std::optional<PhysicalUnit> symbol()
    {
        const auto begin = at;

        while (isLetter())
            ++at;

        // "1", or a name that ends in a digit which is no power: "g0".
        at += at < text.size() && ((at == begin && text[at] == '1') || text.substr (begin, 2) == "g0") ? 1U : 0U;
        return namedUnit (text.substr (begin, at - begin));
    }

    /** "^2", "2", "^-1", "-1"; else 1. */
    int exponent()
    {
        constexpr int largest = 12;
        const auto isMarked = at < text.size() && text[at] == '^';
        at += isMarked ? 1U : 0U;
        const auto isBracketed = isMarked && at < text.size() && text[at] == '(';
        at += isBracketed ? 1U : 0U;
        const auto isNegative = at + 1 < text.size() && text[at] == '-';
        at += isNegative ? 1U : 0U;
        at += isNegative && text[at] == '^' ? 1U : 0U; // A raised minus and a raised digit.

        if (! isDigit())
            return 1;

        auto value = 0;

        while (isDigit() && value <= largest)
            value = 10 * value + (text[at++] - '0');

        at += isBracketed && at < text.size() && text[at] == ')' ? 1U : 0U;
        return std::min (value, largest) * (isNegative ? -1 : 1);
    }

    std::string_view text;
    std::size_t at = 0;
};

void replaceAll (std::string& text, std::string_view from, std::string_view to)
{
    for (auto found = text.find (from); found != std::string::npos; found = text.find (from, found + to.size()))
        text.replace (found, from.size(), to);
}
} // namespace

std::optional<PhysicalUnit> physicalUnit (std::string_view text)
{
    constexpr std::size_t longest = 80;
    auto plain = plainText (trimmedText (text), longest);
    replaceAll (plain, "**", "^");
    replaceAll (plain, " per ", "/");

    if (plain.empty() || plain.size() == longest)
        return std::nullopt;

    const auto found = UnitText (plain).all();
    return found && std::isnormal (found->factor) ? found : std::nullopt;
}
} // namespace antinode
