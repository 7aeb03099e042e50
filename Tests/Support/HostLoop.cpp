#include "HostLoop.h"

#include <thread>

#ifdef _WIN32
#include <windows.h>
#endif

namespace antinode::test
{
void runHostLoop (std::chrono::milliseconds time)
{
    std::this_thread::sleep_for (time);
#ifdef _WIN32
    for (MSG message; PeekMessageW (&message, nullptr, 0, 0, PM_REMOVE) != 0;)
        DispatchMessageW (&message);
#endif
}
} // namespace antinode::test
