#include "SessionRequests.h"

#include <utility>

namespace antinode
{
namespace
{
constexpr auto lookInterval = std::chrono::milliseconds (4); // between looks at the parameters
} // namespace

SessionRequests::SessionRequests (std::shared_ptr<const DeviceDocument> device,
                                  std::shared_ptr<const FocusDocument> focus, int firstNote)
    : newest (focus), published (std::make_shared<const SessionSnapshot>())
{
    asked.device = std::move (device);
    asked.focus = std::move (focus);
    asked.firstNotes = { firstNote };
}

void SessionRequests::load (std::shared_ptr<const DeviceDocument> device, std::shared_ptr<const FocusDocument> focus)
{
    const std::lock_guard lock (mutex);

    if (device != nullptr)
    {
        asked.device = std::move (device);
        asked.choosesFocus = true;
    }

    if (focus != nullptr)
    {
        asked.choosesFocus = false;
        asked.focus = newest = std::move (focus);
    }

    wake.notify_all();
}

std::shared_ptr<const FocusDocument> SessionRequests::newestFocus() const
{
    const std::lock_guard lock (mutex);
    return newest;
}

void SessionRequests::adopt (std::shared_ptr<const FocusDocument> focus)
{
    const std::lock_guard lock (mutex);
    newest = std::move (focus);
}

void SessionRequests::designFirst (std::vector<int> notes)
{
    const std::lock_guard lock (mutex);
    asked.firstNotes = std::move (notes);
    asked.isOrderNew = true;
}

void SessionRequests::insertNodes (InsertNodes insert)
{
    const std::lock_guard lock (mutex);
    asked.graph.insert = std::move (insert);
    asked.isInsertionNew = true;
}

void SessionRequests::setAmplifiers (std::vector<double> volts)
{
    const std::lock_guard lock (mutex);
    asked.amplifiers = std::move (volts);
}

bool SessionRequests::touch (const SessionTouch& touch)
{
    const std::lock_guard lock (mutex);
    std::erase_if (asked.touches, [&touch] (const auto& earlier) { return earlier.askedAt < touch.askedAt; });

    if (asked.touches.size() >= FocusBank::touchPlaces)
        return false;

    asked.touches.push_back (touch);
    wake.notify_all();
    return true;
}

void SessionRequests::prepare (double sampleRate, Milliseconds patience)
{
    std::unique_lock lock (mutex);
    asked.sampleRate = sampleRate;
    const auto round = ++roundsRequested;
    wake.notify_all();
    settled.wait_for (lock, patience,
                      [&] { return roundsDone >= round && (designs.designed > 0 || designs.wanted == 0); });
}

void SessionRequests::waitUntilSettled (std::vector<int> places)
{
    std::unique_lock lock (mutex);
    settlePlaces = std::move (places);
    const auto round = settleRequested = ++roundsRequested;
    wake.notify_all();
    settled.wait (lock, [&] { return roundsDone >= round; });
}

void SessionRequests::stop()
{
    const std::lock_guard lock (mutex);
    stopping = true;
    wake.notify_all();
}

bool SessionRequests::hasDevice() const
{
    const std::lock_guard lock (mutex);
    return asked.device != nullptr;
}

bool SessionRequests::hasFocus() const
{
    const std::lock_guard lock (mutex);
    return asked.focus != nullptr;
}

std::optional<SessionRound> SessionRequests::next()
{
    std::unique_lock lock (mutex);
    wake.wait_for (lock, lookInterval,
                   [this] {
                       return stopping || asked.device || asked.focus || ! asked.touches.empty()
                              || roundsRequested > roundsDone;
                   });

    if (stopping)
        return {};

    asked.number = roundsRequested;
    asked.graph.isOpen = wantsOpenGraph;
    auto round = asked;

    if (settleRequested > roundsDone)
        round.awaited = settlePlaces;

    asked.device = nullptr;
    asked.focus = nullptr;
    asked.choosesFocus = false;
    asked.touches.clear();
    asked.isInsertionNew = asked.isOrderNew = false;
    return round;
}

void SessionRequests::finish (std::uint64_t round, DesignProgress progress)
{
    const std::lock_guard lock (mutex);
    designs = std::move (progress);
    roundsDone = round;
    settled.notify_all();
}

void SessionRequests::publish (SessionSnapshot snapshot)
{
    const std::lock_guard lock (mutex);
    snapshot.generation = published->generation + 1;
    published = std::make_shared<const SessionSnapshot> (std::move (snapshot));
}

std::shared_ptr<const SessionSnapshot> SessionRequests::snapshot() const
{
    const std::lock_guard lock (mutex);
    return published;
}

DesignProgress SessionRequests::progress() const
{
    const std::lock_guard lock (mutex);
    return designs;
}

void SessionRequests::setProgress (DesignProgress progress)
{
    const std::lock_guard lock (mutex);
    designs = std::move (progress);
}
} // namespace antinode
