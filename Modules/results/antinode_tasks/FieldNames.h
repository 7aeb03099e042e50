#pragma once

#include <string>

namespace antinode
{
/** An error of a lower module in the words of this program: the fields that it names become keys and options, for
    example "focus: target 1 x: is 200 mm" becomes "focus: /targets/0/x_mm: is 200 mm". Other text stays. [any] */
std::string withKeysAndOptions (std::string message);
} // namespace antinode
