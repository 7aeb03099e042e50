#pragma once

/** Before a variable: one of each thread, kept as long as the thread runs. Empty for Windows: mingw's run-time library
   frees the memory of such variables before it calls their destructors, so that a program crashes as a thread ends.
   There the variable is built at each call; only those whose contents may be built again use this. */
#ifdef _WIN32
#define ANTINODE_KEPT_BY_THREAD
#else
#define ANTINODE_KEPT_BY_THREAD static thread_local
#endif
