#include "FieldNames.h"

#include <array>
#include <cctype>
#include <string_view>
#include <utility>

namespace antinode
{
namespace
{
/** The fields that errors name, and what the user writes for them. A field that begins like another one stands before
    it. */
constexpr auto namedFields = std::to_array<std::pair<std::string_view, std::string_view>> ({
    { "focus: targets", "focus: /targets" },
    { "focus: focus time", "focus: /focus_time_ms" },
    { "focus: controlled modes", "focus: /modes" },
    { "focus: number of modes", "focus: /modes/count" },
    { "focus: captured fraction", "focus: /modes/captured" },
    { "focus: maximum frequency", "focus: /modes/maximum_frequency_Hz" },
    { "focus: growth", "focus: /transients/growth" },
    { "focus: cycles", "focus: /transients/cycles" },
    { "focus: brake duration", "focus: /transients/brake_duration_ms" },
    { "focus: allocation method", "focus: /allocation/method" },
    { "focus: voltage limit", "focus: /allocation/voltage_limit_V" },
    { "focus: robustness", "focus: /allocation/robust" },
    { "device: voltage limit", "device: /limits/voltage_V" },
    { "device: full scale", "device: /limits/full_scale_V" },
    { "device: current limit", "device: /limits/current_mA" },
    { "device: slew limit", "device: /limits/slew_V_per_us" },
    { "placement: keep-out zones", "--keep-out-mm" },
    { "placement: edge distance", "--rim-mm" },
    { "placement: step", "--step-mm" },
    { "placement: ceramic size", "--size-mm" },
    { "placement: number of ceramics", "--count" },
    { "placement: number of modes", "--modes" },
    { "measurement: reference names", "--drivers" },
    { "measurement: point positions", "--points" },
    { "model orders", "--orders" },
});

void replace (std::string& text, std::string_view field, std::string_view word)
{
    for (auto at = text.find (field); at != std::string::npos; at = text.find (field, at + word.size()))
        text.replace (at, field.size(), word);
}

/** "focus: target 1 x" becomes "focus: /targets/0/x_mm": errors count from 1, JSON pointers from 0. */
void replaceTarget (std::string& text)
{
    constexpr std::string_view begin = "focus: target ";

    if (! text.starts_with (begin))
        return;

    auto end = begin.size();

    while (end < text.size() && end < begin.size() + 6 && std::isdigit (static_cast<unsigned char> (text[end])) != 0)
        ++end;

    if (end == begin.size() || end + 1 >= text.size() || text[end] != ' '
        || (text[end + 1] != 'x' && text[end + 1] != 'y'))
        return;

    const auto index = std::stoi (text.substr (begin.size(), end - begin.size())) - 1;
    text.replace (0, end + 2, "focus: /targets/" + std::to_string (index) + '/' + text[end + 1] + "_mm");
}
} // namespace

std::string withKeysAndOptions (std::string message)
{
    replaceTarget (message);

    for (const auto& [field, word] : namedFields)
        replace (message, field, word);

    return message;
}
} // namespace antinode
