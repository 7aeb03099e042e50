#include "ChangeMessages.h"

#include <juce_events/juce_events.h>

#include <atomic>
#include <mutex>
#include <utility>

namespace antinode
{
struct ChangeMessages::Link
{
    std::recursive_mutex mutex; ///< What is called may free us.
    std::function<void()> toCall;
    std::atomic<bool> isPosted { false };
    bool isOpen = false;
};

ChangeMessages::ChangeMessages (std::function<void()> toCall) : link (std::make_shared<Link>())
{
    link->toCall = std::move (toCall);
}

ChangeMessages::~ChangeMessages()
{
    end();
}

void ChangeMessages::begin()
{
    {
        const std::lock_guard lock (link->mutex);
        link->isOpen = true;
    }
    post();
}

void ChangeMessages::end()
{
    const std::lock_guard lock (link->mutex);
    link->isOpen = false;
}

void ChangeMessages::post()
{
    if (link->isPosted.exchange (true))
        return;

    juce::MessageManager::callAsync (
        [kept = link]
        {
            kept->isPosted = false;
            const std::lock_guard lock (kept->mutex);

            if (kept->isOpen)
                kept->toCall();
        });
}
} // namespace antinode
