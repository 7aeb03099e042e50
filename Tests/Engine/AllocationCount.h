#pragma once

namespace antinode::test
{
/** How often this thread has called malloc so far; always 0 under sanitizers, which bring a malloc of their own. */
long mallocCalls();

/** Whether mallocCalls counts in this build. */
bool mallocIsCounted();
} // namespace antinode::test
