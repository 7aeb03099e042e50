#include "NoteFoci.h"

#include "Documents.h"
#include "NoteBank.h"

#include <antinode_documents/Library.h>
#include <antinode_focus/SpillOver.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace antinode
{
namespace
{
/** Fingers of a focus's document, and those of a session that rest beside them: where two overlap, the first is meant.
 */
std::vector<Finger> restingTogether (std::vector<Finger> fingers, const std::vector<Finger>& others)
{
    for (const auto& other : others)
        if (std::none_of (fingers.begin(), fingers.end(),
                          [&] (const auto& each)
                          { return std::hypot (each.x - other.x, each.y - other.y) < each.radius + other.radius; }))
            fingers.push_back (other);

    return fingers;
}

/** The modes beyond follow what all frequencies share. */
std::function<WideModel()> beyond (const FociSurface& surface, const std::shared_ptr<const ModalModel>& model,
                                   double rate)
{
    return [solve = modesBeyond (surface.device, model, rate), now = surface.drifted]
    {
        auto wide = solve();
        wide.model = now.asDriven (std::move (wide.model));
        return wide;
    };
}

std::shared_ptr<const ModalModel> loadedBy (const std::shared_ptr<const ModalModel>& model,
                                            const std::vector<Finger>& fingers)
{
    if (fingers.empty())
        return model;

    return std::make_shared<const ModalModel> (*loadedByFingers ({ *model, model->modes(), {}, {} }, fingers).designed);
}
} // namespace

void NoteFoci::load (std::shared_ptr<const FocusDocument> focus)
{
    const std::lock_guard lock (mutex);
    wanted = std::move (focus);
}

std::shared_ptr<const FocusDocument> NoteFoci::focus() const
{
    const std::lock_guard lock (mutex);
    return wanted;
}

DesignProgress NoteFoci::progress() const
{
    const std::lock_guard lock (mutex);
    return designs;
}

FociUnderFingers NoteFoci::underFingers() const
{
    const std::lock_guard lock (mutex);
    return fociUnderFingers;
}

void NoteFoci::serve (InstrumentPath& path, const FociSurface& surface, bool isPathNew, const Watch& goesOn)
{
    if (const auto now = focus(); served != now || isPathNew)
    {
        served = now;
        begin (path, surface);
    }

    if (served != nullptr && error.empty() && meaning != NoteMeaning::spotOnly)
        update (path, surface, goesOn);

    const auto now = served != nullptr && error.empty() ? path.foci().progress() : DesignProgress {};
    const std::lock_guard lock (mutex);
    designs = now;
    fociUnderFingers = knowledge (surface, now);

    if (! error.empty())
        designs.liveError = error;
}

/** Another focus, or another path: at first without the session's fingers, which shall not keep it waiting. */
void NoteFoci::begin (InstrumentPath& path, const FociSurface& surface)
{
    error.clear();
    meaning = NoteMeaning::nothing;
    isWhole = false;
    path.setFocusLimits (served != nullptr ? limitsInPlay (path.model(), served->description, served->design.get())
                                           : voltageLimits (path.model()));

    try
    {
        if (served != nullptr)
            request (path, surface, {}, {});
    }
    catch (const std::exception& failure)
    {
        error = failure.what();
    }
}

/** A bank that is there plays on while fingers move; a part of one is better than none. */
void NoteFoci::update (InstrumentPath& path, const FociSurface& surface, const Watch& goesOn)
{
    const auto isDone = path.foci().progress().isDone();
    isWhole = isWhole || (isDone && designedFor);

    if (designedFor == surface.fingers && ! designedDrift.isOutdated (surface.shift, isDone))
        return;

    if (! surface.areResting)
    {
        if (isWhole && ! isDone)
        {
            path.foci().abandon();
            designedFor.reset();
        }

        return;
    }

    try
    {
        request (path, surface, surface.fingers, goesOn);
    }
    catch (const Cancelled&)
    {
        checkWatch(); // Fingers move on: there will be another time.
    }
    catch (const std::exception&)
    {
        designedFor = surface.fingers;
        designedDrift.note (surface.shift.changes); // The bank plays on, and nobody shall try it again and again.
        isLoadingRefused = true;
    }
}

void NoteFoci::request (InstrumentPath& path, const FociSurface& surface, const std::vector<Finger>& fingers,
                        const Watch& goesOn)
{
    if (solvedDevice != surface.device)
    {
        solved = std::make_shared<const ModalModel> (solveDevice (surface.device->description, {}, true));
        solvedDevice = surface.device;
    }

    const auto& description = served->description;
    const auto model = withAmplifiers (solved, surface.amplifiers);
    const auto rate = path.sampleRate();
    auto written = writtenFor (*served, description);
    const auto& spot = description.targets.front();
    auto places = written != nullptr ? std::vector<std::pair<double, double>>()
                                     : spreadNotes (model->surface, { spot.x, spot.y });
    const auto all = restingTogether (description.fingers, fingers);
    auto widen = all.empty() ? beyond (surface, model, rate) : std::function<WideModel()>();
    const WatchScope scope (goesOn);
    path.foci().request ({ loadedBy (surface.drifted.asDriven (model), all),
                           description,
                           std::move (places),
                           { spotNote },
                           { Reconstruction::bandLimited, rate },
                           std::move (widen),
                           written });
    meaning = written != nullptr ? NoteMeaning::spotOnly : NoteMeaning::spread;
    designedFor = fingers;
    designedDrift.note (surface.shift.changes);
    isLoadingRefused = false;
}

FociUnderFingers NoteFoci::knowledge (const FociSurface& surface, const DesignProgress& progress) const
{
    if (served == nullptr || ! error.empty() || meaning == NoteMeaning::spotOnly)
        return FociUnderFingers::unaffected;

    if (designedFor != surface.fingers || isLoadingRefused)
        return FociUnderFingers::outdated;

    if (surface.fingers.empty())
        return FociUnderFingers::unaffected;

    return progress.isDone() ? FociUnderFingers::known : FociUnderFingers::designing;
}
} // namespace antinode
