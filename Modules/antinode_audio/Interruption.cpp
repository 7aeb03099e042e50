#include "Interruption.h"

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
    struct sigaction action = {};
    action.sa_handler = note;
    action.sa_flags = static_cast<int> (SA_RESETHAND);
    sigaction (SIGINT, &action, nullptr);
    sigaction (SIGTERM, &action, nullptr);
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
