#include "Session.h"

#include "FocusSettings.h"
#include "SessionWorker.h"

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto preparePatience = std::chrono::milliseconds (40); // of a host that prepares us
} // namespace

Session::Session (DeviceDocument device, FocusDocument focus, ReadSettings read, std::function<void()> changed,
                  TakeFocus takeFocus)
    : owner (std::make_shared<SessionOwner<PlaySettings>> (std::move (read), std::move (changed))),
      requests (std::make_shared<SessionRequests> (std::make_shared<const DeviceDocument> (std::move (device)),
                                                   std::make_shared<const FocusDocument> (std::move (focus)),
                                                   spotNote)),
      entry (std::make_shared<AudioEntry>()),
      thread ([worker = std::make_shared<SessionWorker> (requests, followingRequests, entry, owner,
                                                         std::move (takeFocus))] { worker->run(); })
{
}

Session::~Session()
{
    requests->stop();
    owner->leave();
}

void Session::load (std::shared_ptr<const DeviceDocument> device, std::shared_ptr<const FocusDocument> focus)
{
    requests->load (std::move (device), std::move (focus));
}

void Session::prepare (double sampleRate)
{
    entry->prepare (sampleRate);
    // At once, although the path may come later: hosts ask for it now.
    requests->setLatencySamples (
        estimateLatency (requests->newestFocus()->description, owner->settings ({}), sampleRate));
    requests->prepare (sampleRate, preparePatience);
}

void Session::waitUntilSettled (std::span<const FocusEvent> events)
{
    std::vector places { FocusBank::livePlace };

    for (const auto& event : events)
        if (event.kind == FocusEventKind::trigger)
            places.push_back (entry->eventPlace (event));

    requests->waitUntilSettled (std::move (places));
}

void Session::designFirst (std::vector<int> notes)
{
    requests->designFirst (std::move (notes));
}

void Session::insertNodes (InsertNodes insert)
{
    if (! insert)
        return requests->insertNodes ({});

    requests->insertNodes (
        [kept = owner, insert = std::move (insert)] (NodeGraph& graph, GraphPlace place, int last)
        {
            kept->call ([&] { last = insert (graph, place, last); });
            return last;
        });
}

void Session::fire (double amplitude)
{
    entry->fire (FocusBank::livePlace, amplitude, stops().now());
}

Session::TouchResult Session::fireAt (double x, double y, double amplitude)
{
    const auto askedAt = stops().now();
    const auto now = snapshot();

    if (now->model == nullptr)
        return TouchResult::notAccepted;

    const auto& surface = now->model->surface;
    const auto isLine = surface.kind == SurfaceKind::line;

    if (! liesOn (surface, x, y))
        return TouchResult::outsideSurface;

    return requests->touch ({ x, isLine ? 0.0 : y, amplitude, askedAt }) ? TouchResult::taken
                                                                         : TouchResult::notAccepted;
}

void Session::stopAll()
{
    stops().stop();
}

double Session::tailSeconds() const
{
    const auto end = estimateEnd (requests->newestFocus()->description, owner->settings ({}));
    return std::max (end, progress().endSeconds) + requests->ringingSeconds();
}

std::shared_ptr<const SessionSnapshot> Session::snapshot() const
{
    return requests->snapshot();
}

DesignProgress Session::progress() const
{
    return requests->progress();
}
} // namespace antinode
