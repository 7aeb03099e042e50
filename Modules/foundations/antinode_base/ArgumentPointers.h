#pragma once

#include <string>
#include <vector>

namespace antinode
{
/** Arguments as main() hands them on; they point into the texts. [any] */
inline std::vector<char*> argumentPointers (std::vector<std::string>& texts)
{
    std::vector<char*> pointers;
    pointers.reserve (texts.size());

    for (auto& text : texts)
        pointers.push_back (text.data());

    return pointers;
}
} // namespace antinode
