#pragma once

#include <antinode_tasks/Field.h>

#include <string>
#include <vector>

namespace antinode
{
/** The docstring of a task's function, which begins with its signature as inspect reads it; its stub is kept for
    `_stubs`. [any] */
std::string documented (const std::string& function, const TaskText&, const std::vector<Field>&,
                        const std::string& result);
} // namespace antinode
