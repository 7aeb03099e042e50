#include "DesignWorker.h"

#include <antinode_focus/DesignFocus.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace antinode
{
namespace
{
constexpr auto partInterval = std::chrono::milliseconds (100); ///< Between parts of a bank that are handed over.

/** The places in the order of their distance, by number, from the wanted one. */
std::vector<int> orderFrom (int first, std::size_t count)
{
    std::vector<int> order (count);
    std::iota (order.begin(), order.end(), 0);
    std::stable_sort (order.begin(), order.end(),
                      [first] (int a, int b) { return std::abs (a - first) < std::abs (b - first); });
    return order;
}

FocusDescription movedTo (FocusDescription focus, double x, double y)
{
    const auto shiftX = x - focus.targets.front().x, shiftY = y - focus.targets.front().y;

    for (auto& target : focus.targets)
    {
        target.x += shiftX;
        target.y += shiftY;
    }

    return focus;
}
} // namespace

DesignWorker::DesignWorker (BankHandOver& handOverToUse) : handOver (handOverToUse), thread ([this] { run(); }) {}

DesignWorker::~DesignWorker()
{
    {
        const std::lock_guard lock (mutex);
        isStopping = true;
    }
    changed.notify_all();
    thread.join();
}

void DesignWorker::request (DesignRequest request)
{
    request.places.resize (std::min<std::size_t> (request.places.size(), FocusBank::places));
    {
        const std::lock_guard lock (mutex);
        state = {};
        state.wanted = static_cast<int> (request.places.size());
        next = std::move (request);
        nextAsked = Clock::now();
    }
    changed.notify_all();
}

void DesignWorker::waitUntilDone()
{
    std::unique_lock lock (mutex);
    changed.wait (lock, [this] { return ! next && ! isWorking; });
}

DesignProgress DesignWorker::progress() const
{
    const std::lock_guard lock (mutex);
    return state;
}

bool DesignWorker::isOutdated() const
{
    const std::lock_guard lock (mutex);
    return next.has_value() || isStopping;
}

void DesignWorker::run()
{
    for (;;)
    {
        DesignRequest request;
        Clock::time_point asked;
        {
            std::unique_lock lock (mutex);
            isWorking = false;
            changed.notify_all();
            changed.wait (lock, [this] { return next.has_value() || isStopping; });

            if (isStopping)
                return;

            request = std::move (*next);
            next.reset();
            asked = nextAsked;
            isWorking = true;
        }
        designBank (request, asked);
    }
}

void DesignWorker::designBank (const DesignRequest& request, Clock::time_point asked)
{
    auto lastPart = Clock::now() - partInterval;

    for (auto place = request.places.size(); place < bank.foci.size(); ++place)
        bank.foci[place].reset();

    for (const auto place : orderFrom (request.first, request.places.size()))
    {
        if (isOutdated())
            return;

        designPlace (request, place);

        if (Clock::now() - lastPart >= partInterval)
        {
            handOverBank();
            lastPart = Clock::now();
            const std::chrono::duration<double, std::milli> elapsed = lastPart - asked;
            const std::lock_guard lock (mutex);

            if (state.firstMilliseconds == 0)
                state.firstMilliseconds = elapsed.count();
        }
    }

    handOverBank();
}

void DesignWorker::designPlace (const DesignRequest& request, int place)
{
    std::shared_ptr<const PlayableFocus> focus;
    std::string error;

    try
    {
        const auto [x, y] = request.places[static_cast<std::size_t> (place)];
        const auto design =
            designFocus (*request.model, movedTo (request.focus, x, y), request.playback, DesignExtent::playable);
        focus = std::make_shared<const PlayableFocus> (design.program, request.playback);
    }
    catch (const std::exception& failure)
    {
        error = failure.what();
    }

    bank.foci[static_cast<std::size_t> (place)] = std::move (focus);
    const std::lock_guard lock (mutex);

    if (next)
        return; // The state is the next request's already.

    ++state.designed;

    if (! error.empty())
    {
        ++state.failed;
        state.error = error;
    }
}

void DesignWorker::handOverBank()
{
    handOver.give (std::make_unique<const FocusBank> (bank));
}
} // namespace antinode
