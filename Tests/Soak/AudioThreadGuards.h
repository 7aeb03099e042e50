#pragma once

#include <Engine/AllocationCount.h>
#include <Support/SyscallTrap.h>

#include <cstdlib>
#include <mutex>

#include <sys/syscall.h>
#include <unistd.h>

#if defined(ANTINODE_RTSAN)
// NOLINTBEGIN (bugprone-reserved-identifier, readability-identifier-naming): RealtimeSanitizer's own names.
extern "C" void __rtsan_realtime_enter();
extern "C" void __rtsan_realtime_exit();
// NOLINTEND
#endif

namespace antinode::test
{
/** Tells RealtimeSanitizer, where it is linked, that the thread is a real-time one while an instance lives. */
struct RealtimeScope
{
#if defined(ANTINODE_RTSAN)
    RealtimeScope()
    {
        __rtsan_realtime_enter();
    }
    ~RealtimeScope()
    {
        __rtsan_realtime_exit();
    }
#else
    RealtimeScope() = default;
    ~RealtimeScope() {} // NOLINT (modernize-use-equals-default): so that no compiler calls an instance unused.
#endif
    RealtimeScope (const RealtimeScope&) = delete;
    RealtimeScope& operator= (const RealtimeScope&) = delete;
};

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
