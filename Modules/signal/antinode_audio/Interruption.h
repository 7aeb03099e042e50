#pragma once

namespace antinode
{
/** From now on the first signal of each kind that would end the program only sets a flag: of the keyboard, a closed
    terminal, other programs. A second one of its kind ends the program as usual. [message thread] */
void catchInterruptions();

/** From now on outputs are driven, which must ramp to 0 V before the program ends: a second signal that follows the
   first too soon for that does nothing, and a standard output that nobody reads any more is an interruption too.
   [message thread] after catchInterruptions */
void protectRamps();

/** Whether such a signal has arrived and has not been answered yet. [any] */
bool isInterrupted();

/** The answer to a signal: the work has stopped, and what it has done may be kept, which looks at the watch as well. A
   further signal ends the program as usual. [any] */
void answerInterruption();

/** The signal that has arrived; 0: none. [any] */
int interruptingSignal();
} // namespace antinode
