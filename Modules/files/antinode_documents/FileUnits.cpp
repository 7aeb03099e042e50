#include "FileUnits.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace antinode
{
namespace
{
double roundedToDigits (double value, int digits)
{
    std::array<char, 40> buffer {};
    const auto written =
        std::to_chars (buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    std::from_chars (buffer.data(), written.ptr, value);
    return value;
}

/** The value whose conversion gives `wanted`, searched around a guess that is off by rounding only. */
double inverted (double (*convert) (double), double wanted, double guess)
{
    const auto infinity = std::numeric_limits<double>::infinity();
    const auto below = std::nextafter (guess, -infinity);
    const auto above = std::nextafter (guess, infinity);
    auto best = guess;

    for (const auto candidate : { roundedToDigits (guess, 15), roundedToDigits (guess, 16), guess, below, above })
    {
        if (convert (candidate) == wanted)
            return candidate;

        if (std::abs (convert (candidate) - wanted) < std::abs (convert (best) - wanted))
            best = candidate;
    }

    return best;
}
} // namespace

double fromMillimetres (double millimetres)
{
    return millimetres / 1000;
}

double fromMilliseconds (double milliseconds)
{
    return milliseconds / 1000;
}

double fromMicroseconds (double microseconds)
{
    return microseconds / 1e6;
}

double fromDegrees (double degrees)
{
    return degrees * std::numbers::pi / 180;
}

double fromVoltsPerMicrosecond (double voltsPerMicrosecond)
{
    return voltsPerMicrosecond * 1e6;
}

double fromMilliamperes (double milliamperes)
{
    return milliamperes / 1000;
}

double fromGrams (double grams)
{
    return grams / 1000;
}

double fromNewtonsPerMillimetre (double newtonsPerMillimetre)
{
    return newtonsPerMillimetre * 1000;
}

double fromNanofarads (double nanofarads)
{
    return nanofarads / 1e9;
}

double fromHertz (double hertz)
{
    return 2 * std::numbers::pi * hertz;
}

double fromPercent (double percent)
{
    return percent / 100;
}

double toMillimetres (double metres)
{
    return inverted (fromMillimetres, metres, metres * 1000);
}

double toMilliseconds (double seconds)
{
    return inverted (fromMilliseconds, seconds, seconds * 1000);
}

double toMicroseconds (double seconds)
{
    return inverted (fromMicroseconds, seconds, seconds * 1e6);
}

double toDegrees (double radians)
{
    return inverted (fromDegrees, radians, radians * 180 / std::numbers::pi);
}

double toVoltsPerMicrosecond (double voltsPerSecond)
{
    return inverted (fromVoltsPerMicrosecond, voltsPerSecond, voltsPerSecond / 1e6);
}

double toGrams (double kilograms)
{
    return inverted (fromGrams, kilograms, kilograms * 1000);
}

double toNewtonsPerMillimetre (double newtonsPerMetre)
{
    return inverted (fromNewtonsPerMillimetre, newtonsPerMetre, newtonsPerMetre / 1000);
}

double toNanofarads (double farads)
{
    return inverted (fromNanofarads, farads, farads * 1e9);
}

double toPercent (double share)
{
    return inverted (fromPercent, share, share * 100);
}

double toHertz (double angularFrequency)
{
    return inverted (fromHertz, angularFrequency, angularFrequency / (2 * std::numbers::pi));
}
} // namespace antinode
