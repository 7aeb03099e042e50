#include "TouchSession.h"

#include "NoteBank.h"

#include <chrono>
#include <memory>
#include <utility>

// What of a touch session follows the device and the fingers that rest: its follower, its designer and its foci.
namespace antinode
{
namespace
{
constexpr auto focusRest = std::chrono::milliseconds (500); // for which fingers stay before foci are designed for them
} // namespace

/** Fingers that load the surface make other modes of it. */
void TouchSession::takeFollowing()
{
    deviceFollowing.take (present.model.get());

    if (present.model != nullptr && followingRequests->settings().isOn())
    {
        const auto focus = foci.focus();
        const auto loads = restingFingers (waveformsFor (present.model->surface, settings, format.inputs));
        const auto areLoads = ! loads.empty() || (focus != nullptr && ! focus->description.fingers.empty());
        deviceFollowing.setHindrance (areLoads ? "Fingers load the surface and change its modes." : "");
    }

    deviceFollowing.read (present.model.get());
}

/** New filters for a device that has drifted, while fingers rest: what plays is better for those that move. */
void TouchSession::takeDrift()
{
    const auto areMade = designedFor == settings && designer->design (settings.latency) != nullptr;

    if (! deviceFollowing.needsDesigns (areMade) || movement.isAnyMoving (FingerMovement::Clock::now()))
        return;

    makeDesigner();
    isRetuned = true;
    designedFor.reset();
}

void TouchSession::makeDesigner()
{
    designer =
        std::make_unique<FilterDesigner> (deviceFollowing.driven (present.model), format.sampleRate, format.inputs);
    deviceFollowing.noteDesigned();
}

/** Notes that somebody waits for are designed for the fingers as they are, others where fingers rest. */
void TouchSession::serveFoci()
{
    const auto notes = awaited();
    const auto areNotesAwaited = notes && notes->size() > 1;
    const auto& places = areNotesAwaited ? settings : movement.rest();
    const FociSurface surface { playedDevice,
                                amplifiers,
                                restingFingers (waveformsFor (present.model->surface, places, format.inputs)),
                                areNotesAwaited || movement.restedFor (FingerMovement::Clock::now()) >= focusRest,
                                deviceFollowing.device (present.model.get()),
                                deviceFollowing.shift() };
    foci.serve (*path, surface, std::exchange (isPathNew, false),
                [this, areNotesAwaited] { return areNotesAwaited || owner.settings (settings) == settings; });
    setNotes (foci.notes());
}
} // namespace antinode
