#include "ResponseUnit.h"

#include "PhysicalUnit.h"

#include <antinode_base/MessageText.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

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
} // namespace antinode
