#pragma once

namespace antinode
{
/** From now on SIGINT and SIGTERM only say so; a second one ends the program as ever. [message thread] */
void catchInterruptions();

/** Whether one has come. [any] */
bool isInterrupted();
} // namespace antinode
