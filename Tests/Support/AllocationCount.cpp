#include "AllocationCount.h"

#include <cstddef>

#ifndef _WIN32
#include <dlfcn.h>
#include <pthread.h>
#endif

namespace
{
thread_local long calls = 0;
thread_local long locks = 0;
} // namespace

long antinode::test::mallocCalls()
{
    return calls;
}

long antinode::test::lockCalls()
{
    return locks;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(ANTINODE_RTSAN) || defined(_WIN32)

bool antinode::test::mallocIsCounted()
{
    return false;
}

#else

bool antinode::test::mallocIsCounted()
{
    return true;
}

// The C library's functions under the names by which they may be replaced: Eigen allocates by malloc, operator new
// calls it. NOLINTBEGIN (bugprone-reserved-identifier, readability-identifier-naming)
extern "C" void* __libc_malloc (std::size_t);
extern "C" void* __libc_calloc (std::size_t, std::size_t);
extern "C" void* __libc_realloc (void*, std::size_t);
extern "C" void* __libc_memalign (std::size_t, std::size_t);
extern "C" void __libc_free (void*);
// NOLINTEND

extern "C" void* malloc (std::size_t size)
{
    ++calls;
    return __libc_malloc (size);
}

extern "C" void* calloc (std::size_t count, std::size_t size)
{
    ++calls;
    return __libc_calloc (count, size);
}

extern "C" void* realloc (void* memory, std::size_t size)
{
    ++calls;
    return __libc_realloc (memory, size);
}

extern "C" void* memalign (std::size_t alignment, std::size_t size)
{
    ++calls;
    return __libc_memalign (alignment, size);
}

extern "C" void* aligned_alloc (std::size_t alignment, std::size_t size)
{
    ++calls;
    return __libc_memalign (alignment, size);
}

extern "C" void free (void* memory)
{
    calls += memory != nullptr ? 1 : 0;
    __libc_free (memory);
}

extern "C" int pthread_mutex_lock (pthread_mutex_t* mutex)
{
    using Lock = int (*) (pthread_mutex_t*);
    static const auto lock = reinterpret_cast<Lock> (dlsym (RTLD_NEXT, "pthread_mutex_lock"));
    ++locks;
    return lock (mutex);
}

#endif
