#pragma once

namespace antinode
{
/** The program `antinode`: one sub-command, its result on standard output or in files.
    @return  0 done, 1 bad input (one line on standard error), 2 wrong usage
    [worker] */
int runCommandLine (int argumentCount, const char* const* arguments);
} // namespace antinode
