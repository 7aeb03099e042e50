#pragma once

namespace antinode::test
{
/** Sees every system call of the current thread while an instance lives, and keeps it from happening: what runs on an
   audio thread must not make any. Linux' syscall user dispatch. One instance at a time in the program. */
class SyscallTrap
{
public:
    /** Whether the kernel can do it. */
    static bool isAvailable();

    SyscallTrap();
    ~SyscallTrap();
    SyscallTrap (const SyscallTrap&) = delete;
    SyscallTrap& operator= (const SyscallTrap&) = delete;

    /** The number of the first system call that was caught in this or any earlier instance, or -1. */
    static long firstCaught();

    /** Forgets it. */
    static void clear();
};
} // namespace antinode::test
