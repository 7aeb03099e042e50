#include "TouchWorker.h"

#include "NoteBank.h"

#include <chrono>
#include <memory>
#include <utility>

// What of a touch session follows the device and the fingers that rest: its tracker, its designer and its foci.
namespace antinode
{
namespace
{
constexpr auto focusRest = std::chrono::milliseconds (500); // for which fingers stay before foci are designed for them
} // namespace

/** Fingers that load the surface make other modes of it. */
void TouchWorker::takeTracking()
{
    tracked.take (present.model.get());

    if (present.model != nullptr && trackingRequests->settings().isOn())
    {
        const auto focus = foci.focus();
        const auto loads = restingFingers (touchedBy (present.model->surface, settings, format.inputs));
        const auto areLoads = ! loads.empty() || (focus != nullptr && ! focus->description.fingers.empty());
        tracked.setHindrance (areLoads ? "Fingers load the surface and change its modes." : "");
    }

    tracked.read (present.model.get());
}

/** New filters for a device that has drifted, while fingers rest: what plays is better for those that move. */
void TouchWorker::takeDrift()
{
    const auto areMade = designedFor == settings && designer->design (settings.latency) != nullptr;

    if (! tracked.needsDesigns (areMade) || movement.isAnyMoving (FingerMovement::Clock::now()))
        return;

    makeDesigner();
    isRetuned = true;
    designedFor.reset();
}

void TouchWorker::makeDesigner()
{
    designer = std::make_unique<TouchDesigner> (tracked.driven (present.model), format.sampleRate, format.inputs);
    tracked.noteDesigned();
}

/** Notes that somebody waits for are designed for the fingers as they are, others where fingers rest. */
void TouchWorker::serveFoci()
{
    auto areNotesAwaited = false;
    {
        const std::lock_guard lock (mutex);
        areNotesAwaited = awaitedNotes && awaitedNotes->size() > 1;
    }

    const auto& places = areNotesAwaited ? settings : movement.rest();
    const FociSurface surface { playedDevice,
                                amplifiers,
                                restingFingers (touchedBy (present.model->surface, places, format.inputs)),
                                areNotesAwaited || movement.restedFor (FingerMovement::Clock::now()) >= focusRest,
                                tracked.device (present.model.get()),
                                tracked.shift() };
    foci.serve (*path, surface, std::exchange (isPathNew, false),
                [this, areNotesAwaited] { return areNotesAwaited || owner->settings (settings) == settings; });
}

/** Only who renders offline waits for foci: filters have to come soon. */
void TouchWorker::waitForFoci()
{
    std::optional<std::vector<int>> awaited;
    {
        const std::lock_guard lock (mutex);
        awaited = awaitedNotes;
    }

    if (! awaited || path == nullptr || foci.notes() == NoteMeaning::nothing)
        return;

    for (auto& note : *awaited)
        note = bankPlaceOf (note, foci.notes() == NoteMeaning::spotOnly);

    path->foci().waitFor (*awaited);
    serveFoci();
}
} // namespace antinode
