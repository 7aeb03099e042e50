#pragma once

#include <antinode_base/InputError.h>

#include <string>

namespace antinode
{
/** The text of the InputError that an action throws; empty where it throws none. Other exceptions pass. */
template <typename Action>
std::string errorText (Action&& action)
{
    try
    {
        action();
    }
    catch (const InputError& error)
    {
        return error.what();
    }

    return {};
}
} // namespace antinode
