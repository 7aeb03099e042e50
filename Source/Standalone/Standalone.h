#pragma once

namespace antinode
{
/** The program `antinode-standalone`, with windows or without.
    @return  0 done, 1 bad input (one line on standard error), 2 wrong usage
    [message thread] */
int runStandalone (int argumentCount, const char* const* arguments);
} // namespace antinode
