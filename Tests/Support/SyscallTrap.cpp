#include "SyscallTrap.h"

#include <cerrno>
#include <csignal>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#ifndef PR_SET_SYSCALL_USER_DISPATCH
#define PR_SET_SYSCALL_USER_DISPATCH 59
#define PR_SYS_DISPATCH_OFF 0
#define PR_SYS_DISPATCH_ON 1
#endif

namespace
{
constexpr char allow = 0, block = 1; // What the kernel's selector byte means.
thread_local volatile char selector = allow;
volatile long caught = -1;

void onSystemCall (int, siginfo_t* info, [[maybe_unused]] void* context)
{
    selector = allow; // The handler's own return is a system call.

#if defined(__x86_64__)
    // The call is made after all: a lock whose release was left out would belong to a thread that is gone.
    auto& registers = static_cast<ucontext_t*> (context)->uc_mcontext.gregs;
    const auto errorBefore = errno;
    const auto result = syscall (info->si_syscall, registers[REG_RDI], registers[REG_RSI], registers[REG_RDX],
                                 registers[REG_R10], registers[REG_R8], registers[REG_R9]);
    registers[REG_RAX] = result == -1 ? -errno : result;
    errno = errorBefore;
#endif

    if (caught < 0)
        caught = info->si_syscall;
}

// Sanitizers hold signals back until the thread is in no system call, which this one would never be.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(ANTINODE_RTSAN)
bool dispatch (int, volatile char*)
{
    return false;
}
#else
bool dispatch (int mode, volatile char* byte)
{
    return prctl (PR_SET_SYSCALL_USER_DISPATCH, mode, 0, 0, byte) == 0;
}
#endif
} // namespace

bool antinode::test::SyscallTrap::isAvailable()
{
    if (! dispatch (PR_SYS_DISPATCH_ON, &selector))
        return false;

    dispatch (PR_SYS_DISPATCH_OFF, nullptr);
    return true;
}

antinode::test::SyscallTrap::SyscallTrap()
{
    struct sigaction action
    {
    };
    action.sa_sigaction = onSystemCall;
    action.sa_flags = SA_SIGINFO;
    sigaction (SIGSYS, &action, nullptr);
    dispatch (PR_SYS_DISPATCH_ON, &selector);
    selector = block;
}

antinode::test::SyscallTrap::~SyscallTrap()
{
    selector = allow;
    dispatch (PR_SYS_DISPATCH_OFF, nullptr);
}

long antinode::test::SyscallTrap::firstCaught()
{
    return caught;
}

void antinode::test::SyscallTrap::clear()
{
    caught = -1;
}
