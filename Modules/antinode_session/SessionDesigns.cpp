#include "FocusSettings.h"
#include "Session.h"

#include <antinode_base/InputError.h>
#include <antinode_focus/BankPlaces.h>
#include <antinode_focus/FocusMoments.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
namespace
{
constexpr double bankMargin = 0.1; // of the surface's shorter side, kept from its edges
} // namespace

void Session::requestDesigns()
{
    const auto description = withSettings (focus->description, settings, model->surface);
    latency = settings.focusOnNote ? std::llround (earliestFocusTime (description) * rate) : 0;
    playsSpotOnly = settings.noteLayout == static_cast<int> (NoteLayout::spot);
    isFocusNew = false;

    try
    {
        path->plate().setProbes (probeShapes());
    }
    catch (const InputError&)
    {
        // A focus of another device may have probes outside this surface: the monitor stays where it was.
    }

    path->worker().request ({ model, description, notePlaces(), wantedFirst(), { Reconstruction::bandLimited, rate } });
}

std::vector<std::pair<double, double>> Session::notePlaces() const
{
    if (settings.noteLayout == static_cast<int> (NoteLayout::spot))
        return {};

    const auto& surface = model->surface;
    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto shorter = height > 0 ? std::min (width, height) : width;
    auto places = bankPlaces (surface, FocusBank::notePlaces, bankMargin * shorter);
    const auto spot = withSettings (focus->description, settings, surface).targets.front();
    places[spotNote] = { spot.x, spot.y };
    return places;
}

Eigen::MatrixXd Session::probeShapes() const
{
    const auto places = probePlaces (focus->description, settings, model->surface);
    Eigen::MatrixXd shapes (AudioPath::probes, model->modes());
    const auto& surface = model->surface;

    for (std::size_t i = 0; i < places.size(); ++i)
        shapes.row (static_cast<Eigen::Index> (i)) =
            shapesAt (*model, std::clamp (places[i].first, surface.xMinimum, surface.xMaximum),
                      std::clamp (places[i].second, surface.yMinimum, surface.yMaximum));

    return shapes;
}

void Session::forwardTouches()
{
    std::vector<Touch> waiting;
    {
        const std::lock_guard lock (mutex);
        waiting.swap (touches);
    }

    for (const auto& touch : waiting)
        if (path != nullptr)
            path->worker().touch (touch.x, touch.y,
                                  [this, amplitude = touch.amplitude] (int place)
                                  {
                                      if (place >= 0)
                                          triggers.push ({ 0, FocusEventKind::trigger, place, amplitude });
                                  });
}

std::vector<int> Session::wantedFirst() const
{
    const std::lock_guard lock (mutex);
    return firstNotes;
}
} // namespace antinode
