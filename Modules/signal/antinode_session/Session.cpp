#include "Session.h"

#include "FocusSettings.h"

#include <algorithm>
#include <utility>

// What front ends ask of a session, and what they are told.
namespace antinode
{
Session::Session (DeviceDocument device, FocusDocument focusToPlay, std::function<PlaySettings()> readSettings,
                  std::function<void()> onChange, TakeFocus takeFocusToCall)
    : InstrumentSession (std::move (device), std::move (readSettings), std::move (onChange)),
      takeFocus (std::move (takeFocusToCall)), newest (std::make_shared<const FocusDocument> (std::move (focusToPlay)))
{
    asked.focus = newest;
    setNotes (NoteMeaning::spread);
}

void Session::load (std::shared_ptr<const DeviceDocument> device, std::shared_ptr<const FocusDocument> wanted)
{
    const std::lock_guard lock (mutex);

    if (device != nullptr)
    {
        nextDevice = std::move (device);
        asked.choosesFocus = true;
    }

    if (wanted != nullptr)
    {
        asked.choosesFocus = false;
        asked.focus = newest = std::move (wanted);
    }

    wake.notify_all();
}

std::shared_ptr<const FocusDocument> Session::newestFocus() const
{
    const std::lock_guard lock (mutex);
    return newest;
}

void Session::prepare (double sampleRate)
{
    AudioEntry::prepare (sampleRate);
    // At once, although the path may come later: hosts ask for it now.
    latency = estimateLatency (newestFocus()->description, owner.settings ({}), sampleRate);
    ask (sampleRate);
}

void Session::insertNodes (InsertNodes insert)
{
    const std::lock_guard lock (mutex);
    asked.isInsertionNew = true;
    asked.insert = {};

    if (insert)
        asked.insert = [this, insert = std::move (insert)] (NodeGraph& nodes, GraphPlace place, int last)
        {
            owner.call ([&] { last = insert (nodes, place, last); });
            return last;
        };
}

void Session::designFirst (std::vector<int> notes)
{
    const std::lock_guard lock (mutex);
    asked.firstNotes = std::move (notes);
    asked.isOrderNew = true;
}

void Session::fire (double amplitude)
{
    AudioEntry::fire (FocusBank::livePlace, amplitude, stops().now());
}

Session::FireResult Session::fireAt (double x, double y, double amplitude)
{
    const auto askedAt = stops().now();
    const auto now = snapshot();

    if (now->model == nullptr)
        return FireResult::notAccepted;

    const auto& surface = now->model->surface;

    if (! liesOn (surface, x, y))
        return FireResult::outsideSurface;

    // Those from before the last stop wait no longer.
    const std::lock_guard lock (mutex);
    std::erase_if (asked.fired, [askedAt] (const auto& earlier) { return earlier.askedAt < askedAt; });

    if (asked.fired.size() >= FocusBank::touchPlaces)
        return FireResult::notAccepted;

    asked.fired.push_back ({ x, surface.kind == SurfaceKind::line ? 0.0 : y, amplitude, askedAt });
    wake.notify_all();
    return FireResult::taken;
}

DesignProgress Session::progress() const
{
    const std::lock_guard lock (mutex);
    return designs;
}

double Session::tailSeconds()
{
    const auto end = estimateEnd (newestFocus()->description, owner.settings ({}));
    return std::max (end, progress().endSeconds) + ringing;
}
} // namespace antinode
