#include "FocusDescription.h"

#include <antinode_base/MessageText.h>

#include <vector>

namespace antinode
{
std::string methodsThat (bool AllocationTraits::*has, std::string_view joint)
{
    std::vector<std::string_view> words;

    for (const auto& each : allocationMethods)
        if (each.*has)
            words.emplace_back (each.word);

    const auto last = inQuotes (words.back());
    words.pop_back();
    return words.empty() ? last : listed (words) + " " + std::string (joint) + " " + last;
}
} // namespace antinode
