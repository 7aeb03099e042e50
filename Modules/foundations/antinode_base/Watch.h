#pragma once

#include <functional>

namespace antinode
{
/** Whether to go on. Asked every few milliseconds, by every thread that takes part in the work, also by several at
   once: it must be quick and safe for that, and must not throw. */
using Watch = std::function<bool()>;

/** Thrown where a watch says no: there is no result, and nothing is wrong. No std::exception, so that what handles
   errors, a cache that cannot be read for one, lets it pass. */
class Cancelled
{
};

/** As long as it lives, the work of the thread that made it looks at a watch, and at those of the scopes around it.
    Docs/Design/session.md. [worker] */
class WatchScope
{
public:
    /** @param watch  none: only those around it are asked */
    explicit WatchScope (Watch watch);
    ~WatchScope();

    WatchScope (const WatchScope&) = delete;
    WatchScope& operator= (const WatchScope&) = delete;

private:
    friend void checkWatch();
    friend Watch threadWatch();
    static bool allGoOn (const WatchScope* innermost);

    Watch watch;
    const WatchScope* around;
};

/** Looks at the watches of this thread. Work calls it at least every 20 ms, better every 2 ms; without a watch it costs
   1 ns.
    @throws Cancelled  where one says no
    [worker] */
void checkWatch();

/** All watches of this thread as one, for threads that work for it; valid as long as their scopes. [worker] */
Watch threadWatch();
} // namespace antinode
