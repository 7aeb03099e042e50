#pragma once

#include <algorithm>
#include <functional>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace antinode
{
/** Values that several threads need: each is made once, by the first that asks, while others wait. The latest are kept.
    An exception of the one who makes it reaches all who ask. */
template <typename Value>
class SharedValues
{
public:
    /** @param mostToKeep  at least 1 */
    explicit SharedValues (std::size_t mostToKeep) : most (mostToKeep) {}

    /** @param make  gives the value of a key @throws  what it throws [worker] */
    std::shared_ptr<const Value> get (const std::string& key, const std::function<Value()>& make)
    {
        std::promise<std::shared_ptr<const Value>> promise;
        auto [future, isFirst] = find (key, promise);

        if (isFirst)
        {
            try
            {
                promise.set_value (std::make_shared<const Value> (make()));
            }
            catch (...)
            {
                promise.set_exception (std::current_exception());
            }
        }

        return future.get();
    }

private:
    using Future = std::shared_future<std::shared_ptr<const Value>>;

    std::pair<Future, bool> find (const std::string& key, std::promise<std::shared_ptr<const Value>>& promise)
    {
        const std::lock_guard lock (mutex);
        const auto found =
            std::find_if (latest.begin(), latest.end(), [&] (const auto& each) { return each.first == key; });

        if (found != latest.end())
        {
            latest.splice (latest.begin(), latest, found);
            return { found->second, false };
        }

        latest.emplace_front (key, promise.get_future().share());

        if (latest.size() > most)
            latest.pop_back();

        return { latest.front().second, true };
    }

    const std::size_t most;
    std::mutex mutex;
    std::list<std::pair<std::string, Future>> latest;
};
} // namespace antinode
