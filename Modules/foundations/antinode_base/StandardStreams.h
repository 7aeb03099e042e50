#pragma once

namespace antinode
{
/** Makes errors of writing out of what would end a program or spoil a file: a pipe that nobody reads any more, and
    standard streams that are closed, whose numbers the next file would get. On Windows neither happens.
    [message thread] */
void guardStandardStreams();

/** Writes out what was printed on standard output.
    @throws InputError  where it cannot be written as a whole: a full disk, a pipe that nobody reads [any] */
void requireWholeOutput();
} // namespace antinode
