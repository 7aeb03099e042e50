#pragma once

namespace antinode
{
/** From now on the first SIGINT or SIGTERM only sets a flag; a second one ends the program as usual. [message thread]
 */
void catchInterruptions();

/** Whether such a signal has arrived. [any] */
bool isInterrupted();

/** The signal that has arrived; 0: none. [any] */
int interruptingSignal();
} // namespace antinode
