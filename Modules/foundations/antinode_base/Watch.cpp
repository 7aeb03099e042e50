#include "Watch.h"

#include <utility>

namespace antinode
{
namespace
{
thread_local const WatchScope* innermostScope = nullptr;
} // namespace

WatchScope::WatchScope (Watch watchToUse) : watch (std::move (watchToUse)), around (innermostScope)
{
    innermostScope = this;
}

WatchScope::~WatchScope()
{
    innermostScope = around;
}

bool WatchScope::allGoOn (const WatchScope* innermost)
{
    for (const auto* scope = innermost; scope != nullptr; scope = scope->around)
        if (scope->watch && ! scope->watch())
            return false;

    return true;
}

void checkWatch()
{
    if (! WatchScope::allGoOn (innermostScope))
        throw Cancelled();
}

Watch threadWatch()
{
    return [scope = innermostScope] { return WatchScope::allGoOn (scope); };
}
} // namespace antinode
