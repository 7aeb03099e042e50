#pragma once

namespace antinode::test
{
/** How often this thread has asked for memory, in whatever way, or given some back; always 0 under sanitizers, which
   bring functions of their own. */
long mallocCalls();

/** How often this thread has locked a mutex; the same. */
long lockCalls();

/** Whether they count in this build. */
bool mallocIsCounted();
} // namespace antinode::test
