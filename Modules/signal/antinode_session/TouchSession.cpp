#include "TouchSession.h"

#include "NoteBank.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/SkinThresholds.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <memory>
#include <utility>

namespace antinode
{
namespace
{
constexpr double usualTouchRate = 48000; // Hz, before a host says its own

NoteDelays noteDelays (double rate)
{
    NoteDelays delays {};

    for (std::size_t i = 0; i < delays.size(); ++i)
        delays[i] = filterTiming ({}, FilterDesigner::filterSettings (rate, i)).latencySamples();

    return delays;
}

} // namespace

/** With the static share of the modes beyond: without it the points between which filters tell apart would leak. */
ModalModel TouchSession::solvedModel (const DeviceDescription& device) const
{
    auto model = solveDeviceWithStaticShare (device, {}, true);
    requireRealModes (model, "filters for fingers");
    return model;
}

TouchSession::TouchSession (DeviceDocument device, std::function<TouchSettings()> readSettings,
                            std::function<void()> onChange)
    : InstrumentSession (std::move (device), std::move (readSettings), std::move (onChange)),
      threshold (findSkinThreshold ({}))
{
}

void TouchSession::prepare (const TouchFormat& wanted)
{
    AudioEntry::prepare (wanted.sampleRate);
    ask (wanted);
}

std::int64_t TouchSession::latencySamples (std::size_t latency) const
{
    const auto rate = AudioEntry::sampleRate() > 0 ? AudioEntry::sampleRate() : usualTouchRate;

    try
    {
        return filterTiming ({}, FilterDesigner::filterSettings (rate, latency)).latencySamples() + late;
    }
    catch (const InputError&)
    {
        return 0; // There is silence at such a rate.
    }
}

/** Notes wait as long as the filters take. */
double TouchSession::tailSeconds (std::size_t latency) const
{
    const auto rate = AudioEntry::sampleRate() > 0 ? AudioEntry::sampleRate() : usualTouchRate;
    const auto delay = static_cast<double> (latencySamples (latency)) / rate, lag = static_cast<double> (late) / rate;
    return std::max (lag + FilterSettings().length, delay + focusProgress().endSeconds) + ringing;
}

void TouchSession::work()
{
    do
        step();
    while (! isSettled());

    // Only who renders offline waits for foci: filters have to come soon.
    if (waitForNotes())
        serveFoci();
}

/** What the parameters say now. */
TouchSettings TouchSession::look()
{
    const auto now = owner.settings (settings);
    movement.note (now, FingerMovement::Clock::now());
    return now;
}

/** One round: what was loaded, then the format, then what the parameters say. */
void TouchSession::step()
{
    if (takeDocument())
        solve (
            [this]
            {
                playedDevice = present.device;
                deviceFollowing.forget();
            });

    takeAmplifiers();
    takeFollowing();
    collect();

    if (path != nullptr)
        path->banks().collect();

    settings = look();
    const auto wanted = askedFor();

    if (present.model == nullptr || ! (wanted.sampleRate > 0))
        return;

    if (const auto isFormatNew = std::exchange (format, wanted) != wanted;
        std::exchange (isModelNew, false) || isFormatNew || deviceFollowing.isSensorNew())
        buildPath();

    if (path != nullptr)
        takeDrift();

    if (path != nullptr)
        serveFoci();

    servePrepared();
    tellOfEnd (focusProgress().endSeconds);

    if (path != nullptr && designedFor != settings)
        design();
}

void TouchSession::buildPath()
{
    path = nullptr; // Whatever played plays on until there is another one.
    designer = nullptr;
    designedFor.reset();
    isRetuned = false;
    present.designs = {};
    present.formatError.clear();

    try
    {
        const auto rate = format.sampleRate;
        InstrumentNodes nodes;
        nodes.filters =
            std::make_unique<FilterNode> (static_cast<int> (present.model->actuators()), format.inputs, TrackBand {},
                                          FilterDesigner::filterSettings (rate, settings.latency), threshold);
        auto made = std::make_unique<InstrumentPath> (present.model, rate, std::move (nodes),
                                                      deviceFollowing.listen (present.model, rate), noteDelays (rate));
        makeDesigner();
        isPathNew = true;
        ringing = made->ringingSeconds();
        late = made->lateSamples();
        playOn (std::move (made));
    }
    catch (const std::exception& failure)
    {
        present.formatError = failure.what();
    }

    publish();
}

namespace
{
using MovementClock = FingerMovement::Clock;

constexpr auto touchRest = std::chrono::milliseconds (20); // for which fingers have stayed where they are
constexpr auto quickLook = std::chrono::milliseconds (1);  // between looks at fingers while quick filters are designed
constexpr auto longestQuick = std::chrono::milliseconds (40); // that quick filters may take to be foretold for
} // namespace

/** Whether what was asked for before this round is there, or cannot be. */
bool TouchSession::isSettled() const
{
    return path == nullptr || designedFor == settings;
}

/** Filters for what the parameters say, unless there are some, and plays them. Those of these places that play for the
   device before it drifted are better than quick ones. */
void TouchSession::design()
{
    designer->setFingers (settings);
    designedFor = settings;
    present.designError.clear();

    try
    {
        if (designer->design (settings.latency) == nullptr)
        {
            const auto arePlayed = isRetuned && present.playedFingers == settings;

            if ((! arePlayed && playQuickly()) || ! areFingersResting())
                throw Cancelled();

            makeDesign();
        }

        play (std::make_unique<const FilterBank> (designer->design (settings.latency)->bank), settings);
        isRetuned = false;
    }
    catch (const Cancelled&)
    {
        checkWatch();
        designedFor.reset();
    }
    catch (const std::exception& failure)
    {
        present.designError = failure.what();
    }

    present.isDesigning = false;

    for (std::size_t i = 0; i < touchLatencies.size(); ++i)
        present.designs[i] = designer->design (i);

    publish();
}

/** Filters for places that may move on before better ones are there: for where fingers will be in the middle of the
    time for which these filters play, until the next ones do.
    @return  whether some play that are for other places than the present ones */
bool TouchSession::playQuickly()
{
    const auto begin = MovementClock::now();
    const auto fade =
        std::chrono::duration_cast<MovementClock::duration> (std::chrono::duration<double> (FilterNode::fadeTime));
    const auto expected = isAwaited() ? settings : movement.expected (begin, quickTime + (quickTime + fade) / 2);
    auto looked = begin;
    const WatchScope scope (
        [this, &looked]
        {
            if (const auto now = MovementClock::now(); now - looked >= quickLook)
            {
                looked = now;
                look();
            }

            return ! hasOtherPath();
        });
    auto bank = designer->quickBank (settings.latency, expected);

    if (bank == nullptr)
        return false;

    play (std::move (bank), expected);
    quickTime = std::min<MovementClock::duration> (MovementClock::now() - begin, longestQuick);
    return expected != settings;
}

/** Whether fingers stay where they are for a moment, or somebody waits for their filters. While they move, quick
   filters have the processor for themselves. */
bool TouchSession::areFingersResting()
{
    for (const auto end = MovementClock::now() + touchRest; ! isAwaited();)
    {
        if (look() != settings)
            return false;

        if (const auto now = MovementClock::now(); now >= end && ! movement.isAnyMoving (now))
            return true;

        std::unique_lock lock (mutex);
        wake.wait_for (lock, interval, [this] { return isStopping || isAnythingNew(); });
    }

    return true;
}

/** Whether somebody waits for what is asked for now, or for the end. */
bool TouchSession::isAwaited() const
{
    const std::lock_guard lock (mutex);
    return isStopping || isAnythingNew();
}

/** Another device or format ends it, and other places, since quick filters for them sound better than none. */
void TouchSession::makeDesign()
{
    present.isDesigning = true;
    present.progress = 0;
    publish();
    const WatchScope scope ([this] { return ! hasOtherPath() && owner.settings (settings) == settings; });
    designer->makeDesign (settings.latency,
                          [this] (const std::string&, double share)
                          {
                              present.progress = share;
                              publish();
                          });
}

void TouchSession::play (std::unique_ptr<const FilterBank> bank, const TouchSettings& places)
{
    path->banks().give (std::move (bank));
    present.playedFingers = places;
    publish();
}

bool TouchSession::hasOtherPath()
{
    const std::lock_guard lock (mutex);
    return nextDevice != nullptr || wantedFormat != format;
}

/** One more latency, so that their volts can be compared; whatever else there is to do ends it. */
void TouchSession::compare()
{
    if (! isComparing || designer == nullptr || ! present.designError.empty() || hasNews())
        return;

    try
    {
        const WatchScope scope ([this] { return ! hasNews(); });

        for (std::size_t i = 0; i < touchLatencies.size(); ++i)
            if (designer->design (i) == nullptr)
            {
                designer->makeDesign (i, {});
                present.designs[i] = designer->design (i);
                publish();
            }
    }
    catch (const Cancelled&)
    {
        checkWatch();
    }
    catch (const std::exception&)
    {
        isComparing = false; // The one that was chosen plays all the same.
    }
}

bool TouchSession::hasNews()
{
    {
        const std::lock_guard lock (mutex);

        if (roundsRequested > roundsDone)
            return true;
    }

    return hasOtherPath() || owner.settings (settings) != settings || designedFor != settings;
}

// What of a touch session follows the device and the fingers that rest: its follower, its designer and its foci.
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
    setNotes (foci.notes(), foci.noteLevel());
}
} // namespace antinode
