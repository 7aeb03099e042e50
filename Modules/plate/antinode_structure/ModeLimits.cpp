#include "ModeLimits.h"

#include <antinode_base/InputError.h>

#include <string>

namespace antinode
{
void requirePlateModes (int count)
{
    if (count < 1 || count > maximumPlateModes)
        throw InputError ("device", "number of modes is " + std::to_string (count) + "; allowed: 1 to "
                                        + std::to_string (maximumPlateModes));
}
} // namespace antinode
