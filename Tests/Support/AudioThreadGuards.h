#pragma once

#include "AllocationCount.h"

#include <Support/RealtimeScope.h>
#include <Support/SyscallTrap.h>

#include <cstdlib>
#include <mutex>

#include <sys/syscall.h>
#include <unistd.h>

namespace antinode::test
{
/** Whether the guards see what they are there for: a system call, memory and a lock. */
inline bool guardsSee()
{
    const auto memoryBefore = mallocCalls(), locksBefore = lockCalls();
    std::mutex mutex;
    void* const volatile memory = std::malloc (1); // volatile: else the compiler leaves it out
    std::free (memory);
    mutex.lock();
    mutex.unlock();

    if (SyscallTrap::isAvailable())
    {
        const SyscallTrap trap;
        syscall (SYS_getppid);
    }

    const auto isSeen = (! mallocIsCounted() || (mallocCalls() > memoryBefore && lockCalls() > locksBefore))
                        && (! SyscallTrap::isAvailable() || SyscallTrap::firstCaught() == SYS_getppid);
    SyscallTrap::clear();
    return isSeen;
}
} // namespace antinode::test
