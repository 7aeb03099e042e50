#include "Session.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto preparePatience = std::chrono::milliseconds (200); // of a host that prepares us
} // namespace

Session::Session (DeviceDocument deviceToLoad, FocusDocument focusToLoad, ReadSettings read,
                  std::function<void()> changed)
    : readSettings (std::move (read)), onChange (std::move (changed)),
      nextDevice (std::make_shared<const DeviceDocument> (std::move (deviceToLoad))),
      nextFocus (std::make_shared<const FocusDocument> (std::move (focusToLoad))),
      published (std::make_shared<const SessionSnapshot>())
{
    thread = std::thread ([this] { run(); });
}

Session::~Session()
{
    {
        const std::lock_guard lock (mutex);
        isStopping = true;
    }
    wake.notify_all();
    thread.join();
}

void Session::load (std::shared_ptr<const DeviceDocument> newDevice, std::shared_ptr<const FocusDocument> newFocus)
{
    {
        const std::lock_guard lock (mutex);

        if (newDevice != nullptr)
            nextDevice = std::move (newDevice);

        if (newFocus != nullptr)
            nextFocus = std::move (newFocus);
    }
    wake.notify_all();
}

void Session::prepare (double sampleRate, bool isOffline)
{
    preparedRate = sampleRate;
    paths.reset();
    {
        std::unique_lock lock (mutex);
        wantedRate = sampleRate;
        const auto round = ++roundsAsked;
        wake.notify_all();
        settled.wait_for (lock, preparePatience,
                          [&] { return roundsDone >= round && (designs.designed > 0 || designs.wanted == 0); });
    }

    if (isOffline)
        waitUntilSettled (std::array { FocusEvent { 0, FocusEventKind::trigger, spotNote, 1 } });
}

void Session::waitUntilSettled (std::span<const FocusEvent> events)
{
    std::unique_lock lock (mutex);
    settlePlaces.clear();

    for (const auto& event : events)
        if (event.kind == FocusEventKind::trigger)
            settlePlaces.push_back (placeOf (event));

    const auto round = settleAsked = ++roundsAsked;
    wake.notify_all();
    settled.wait (lock, [&] { return roundsDone >= round; });
}

void Session::designFirst (std::vector<int> notes)
{
    const std::lock_guard lock (mutex);
    firstNotes = std::move (notes);
    isFirstNew = true;
}

void Session::insertNodes (InsertNodes insert)
{
    const std::lock_guard lock (mutex);
    insertion = std::move (insert);
    isInsertionNew = true;
}

void Session::fire (double amplitude)
{
    triggers.push ({ 0, FocusEventKind::trigger, FocusBank::livePlace, amplitude });
}

Session::TouchResult Session::fireAt (double x, double y, double amplitude)
{
    const auto now = snapshot();

    if (now->model == nullptr)
        return TouchResult::notTaken;

    const auto& surface = now->model->surface;
    const auto isInside = x >= surface.xMinimum && x <= surface.xMaximum
                          && (surface.kind == SurfaceKind::line || (y >= surface.yMinimum && y <= surface.yMaximum));

    if (! isInside)
        return TouchResult::besideSurface;

    {
        const std::lock_guard lock (mutex);

        if (touches.size() >= FocusBank::touchPlaces)
            return TouchResult::notTaken;

        touches.push_back ({ x, surface.kind == SurfaceKind::line ? 0.0 : y, amplitude });
    }
    wake.notify_all();
    return TouchResult::taken;
}

void Session::stopAll()
{
    isStopAsked = true;
}

std::shared_ptr<const SessionSnapshot> Session::snapshot() const
{
    const std::lock_guard lock (mutex);
    return published;
}

DesignProgress Session::progress() const
{
    const std::lock_guard lock (mutex);
    return designs;
}

int Session::placeOf (const FocusEvent& event) const
{
    const auto playsSpot = playsSpotOnly || event.place == spotNote;
    return playsSpot ? FocusBank::livePlace : std::clamp (event.place, 0, FocusBank::places - 1);
}

/** The events of the block with those that came from elsewhere before them; a note's place becomes the bank's. */
std::span<const FocusEvent> Session::gather (std::span<const FocusEvent> events)
{
    std::size_t waiting = 0;

    if (isStopAsked.exchange (false))
        blockEvents[waiting++] = { 0, FocusEventKind::stopAll, 0, 0 };

    waiting +=
        static_cast<std::size_t> (triggers.pop (std::span (blockEvents).subspan (waiting, blockEvents.size() / 2)));
    const auto count = std::min (events.size(), blockEvents.size() - waiting);
    std::copy_n (events.begin(), count, blockEvents.begin() + static_cast<std::ptrdiff_t> (waiting));

    for (auto& event : std::span (blockEvents).subspan (waiting, count))
        event.place = placeOf (event);

    return { blockEvents.data(), waiting + count };
}

template <typename Sample>
void Session::process (const OutputBlock<Sample>& block, std::span<const FocusEvent> events,
                       const PlayControls& controls)
{
    if (auto* const current = paths.current (preparedRate, block.count))
    {
        auto now = controls;
        now.isArmed = controls.isArmed && ! paths.isLeaving();
        fullScale = current->model().fullScaleVoltage;
        current->process (block, gather (events), now, levels, trace);
        return;
    }

    for (auto* const channel : block.ceramics)
        std::fill_n (channel, block.count, Sample (0));

    for (auto* const channel : block.monitor)
        std::fill_n (channel, block.count, Sample (0));
}

template void Session::process (const OutputBlock<float>&, std::span<const FocusEvent>, const PlayControls&);
template void Session::process (const OutputBlock<double>&, std::span<const FocusEvent>, const PlayControls&);
} // namespace antinode
