#include "Session.h"

#include "FocusSettings.h"
#include "NoteBank.h"
#include "WrittenDesign.h"

#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
void Session::requestDesigns (const std::vector<int>& firstNotes)
{
    const auto description = withSettings (focus->description, settings, present.model->surface);
    auto asWritten = written();
    latency = estimateLatency (focus->description, settings, rate) + path->lateSamples();
    setNotes (settings.noteLayout == NoteLayout::spot || asWritten != nullptr ? NoteMeaning::spotOnly
                                                                              : NoteMeaning::spread);
    path->setFocusLimits (limitsInPlay (*present.model, description, asWritten.get()));
    isFocusNew = false;

    try
    {
        path->plate().setProbes (probeShapes());
    }
    catch (const InputError&)
    {
        // A focus of another device may have probes outside this surface: the monitor stays where it was.
    }

    deviceFollowing.noteDesigned();
    path->foci().request ({ fingers.empty() ? deviceFollowing.driven (designedModel) : designedModel,
                            description,
                            notePlaces(),
                            firstNotes,
                            { Reconstruction::bandLimited, rate },
                            widen(),
                            std::move (asWritten) });
}

/** The design that was written for the focus, while the parameters say what it says. */
std::shared_ptr<const DesignDocument> Session::written() const
{
    return writtenFor (*focus, withSettings (focus->description, settings, present.model->surface));
}

/** Under fingers the modes beyond the device's own are not known. */
std::function<WideModel()> Session::widen() const
{
    if (! fingers.empty())
        return {};

    return
        [beyond = modesBeyond (present.device, present.model, rate), now = deviceFollowing.device (present.model.get())]
    {
        auto wide = beyond();
        wide.model = now.asDriven (std::move (wide.model));
        return wide;
    };
}

/** Under fingers the drift is not known. */
bool Session::hasDrifted() const
{
    return path != nullptr && fingers.empty() && deviceFollowing.needsDesigns (path->foci().progress().isDone());
}

std::vector<std::pair<double, double>> Session::notePlaces() const
{
    // A written design has one place.
    if (settings.noteLayout == NoteLayout::spot || written() != nullptr)
        return {};

    const auto spot = withSettings (focus->description, settings, present.model->surface).targets.front();
    return spreadNotes (present.model->surface, { spot.x, spot.y });
}

Eigen::MatrixXd Session::probeShapes() const
{
    const auto places = probePlaces (focus->description, settings, present.model->surface);
    Eigen::MatrixXd shapes (probes, loadedModel->coordinates());
    const auto& surface = present.model->surface;

    for (std::size_t i = 0; i < places.size(); ++i)
    {
        const auto place = nearestOn (surface, places[i].first, places[i].second);
        shapes.row (static_cast<Eigen::Index> (i)) = shapesAt (*loadedModel, place.x(), place.y());
    }

    return shapes;
}

void Session::designFired (const std::vector<FiredFocus>& fired)
{
    if (path == nullptr)
        return;

    AudioEntry& entry = *this;

    // The path is the entry's: it outlives the path's thread, which calls back.
    for (const auto& each : fired)
        path->foci().touch (
            each.x, each.y,
            [&entry, each] (int place)
            {
                if (place >= 0)
                    entry.fire (place, each.amplitude, each.askedAt);
            },
            [&entry, each] { return entry.stops().now() == each.askedAt; });
}
} // namespace antinode
