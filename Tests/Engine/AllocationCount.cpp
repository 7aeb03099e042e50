#include "AllocationCount.h"

#include <cstddef>

namespace
{
thread_local long calls = 0;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)

bool antinode::test::mallocIsCounted()
{
    return false;
}

#else

// The C library's malloc under the name by which it may be replaced: Eigen allocates by malloc, operator new calls it.
extern "C" void* __libc_malloc (std::size_t); // NOLINT (bugprone-reserved-identifier, readability-identifier-naming)

extern "C" void* malloc (std::size_t size)
{
    ++calls;
    return __libc_malloc (size);
}

bool antinode::test::mallocIsCounted()
{
    return true;
}

#endif

long antinode::test::mallocCalls()
{
    return calls;
}
