#pragma once

namespace antinode
{
/** From now on the first SIGINT or SIGTERM only sets a flag; a second one ends the program as usual. [message thread]
 */
void catchInterruptions();

/** Whether such a signal has arrived and has not been answered yet. [any] */
bool isInterrupted();

/** The answer to a signal: the work has stopped, and what it has done may be kept, which looks at the watch as well. A
   further signal ends the program as usual. [any] */
void answerInterruption();

/** The signal that has arrived; 0: none. [any] */
int interruptingSignal();
} // namespace antinode
