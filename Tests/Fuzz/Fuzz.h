#pragma once

#include "Support/ErrorText.h"

#include <antinode_responses/MeasuredResponse.h>

#include <cstdlib>
#include <string_view>

namespace antinode::test
{
/** Reads bytes of anybody. InputError is the only answer to bad ones that is allowed. */
void fuzz (std::string_view bytes);

inline void require (bool fulfilled)
{
    if (! fulfilled)
        std::abort();
}
} // namespace antinode::test
