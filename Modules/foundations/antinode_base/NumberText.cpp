#include "NumberText.h"

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace antinode
{
std::string formatted (const char* format, ...)
{
    std::va_list arguments, again;
    va_start (arguments, format);
    va_copy (again, arguments);
    std::string text (static_cast<std::size_t> (std::vsnprintf (nullptr, 0, format, arguments)), ' ');
    va_end (arguments);
    std::vsnprintf (text.data(), text.size() + 1, format, again);
    va_end (again);
    return text;
}

std::string fixedText (double value, int decimals)
{
    auto text = formatted ("%.*f", decimals, value);

    // Zero has no sign.
    if (text.front() == '-' && text.find_first_of ("123456789") == std::string::npos)
        text.erase (0, 1);

    return text;
}

std::string inWords (double value)
{
    std::array<char, 32> text {};
    std::snprintf (text.data(), text.size(), std::abs (value) >= 1000 && std::abs (value) < 1e7 ? "%.0f" : "%.4g",
                   value);
    return text.data();
}
} // namespace antinode
