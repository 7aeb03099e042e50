#include "Interruption.h"

#include <antinode_base/Processes.h>

#include <csignal>

namespace antinode
{
namespace
{
volatile std::sig_atomic_t arrived = 0, answered = 0;

void note (int signal)
{
    arrived = signal;
}
} // namespace

void catchInterruptions()
{
    handleOnce (SIGINT, note);
    handleOnce (SIGTERM, note);
}

bool isInterrupted()
{
    return arrived != answered;
}

void answerInterruption()
{
    answered = arrived;
}

int interruptingSignal()
{
    return arrived;
}
} // namespace antinode
