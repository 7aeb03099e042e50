#include "TouchWorker.h"

#include "Amplifiers.h"
#include "NoteBank.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_library/Library.h>
#include <antinode_library/SkinThresholds.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto focusRest = std::chrono::milliseconds (500); // for which fingers stay before foci are designed for them
constexpr double usualTouchRate = 48000;                    // Hz, before a host says its own

/** With the static share of the modes beyond: without it the points between which filters tell apart would leak.
    @throws InputError  where it cannot be solved, or has nothing that moves it */
std::shared_ptr<const ModalModel> solvedForTouch (const DeviceDocument& document)
{
    auto model = std::make_shared<const ModalModel> (solveDeviceWithStaticShare (document.description, {}, true));
    const auto where = "device '" + document.description.name + "'";

    if (model->actuators() == 0)
        throw InputError (where, "has no ceramics, so nothing can move it");

    requireRealModes (*model, "filters for fingers");
    return model;
}
} // namespace

TouchWorker::TouchWorker (std::shared_ptr<const DeviceDocument> device, std::shared_ptr<Owner> ownerToAsk)
    : DeviceRounds (std::move (device), std::move (ownerToAsk)), threshold (findSkinThreshold ({}))
{
}

void TouchWorker::prepare (double sampleRate, int inputs)
{
    preparedRate = sampleRate;
    paths.reset();
    ask ({ sampleRate, inputs });
}

std::int64_t TouchWorker::latencySamples (std::size_t latency) const
{
    const auto rate = preparedRate > 0 ? preparedRate.load() : usualTouchRate;

    try
    {
        return filterTiming ({}, TouchDesigner::filterSettings (rate, latency)).latencySamples();
    }
    catch (const InputError&)
    {
        return 0; // There is silence at such a rate.
    }
}

void TouchWorker::run()
{
    const WatchScope scope ([this] { return ! isStopping; });

    try
    {
        for (std::uint64_t round = 0; awaitRound (round);)
        {
            do
                step();
            while (! isSettled());

            waitForFoci();
            finish (round);
            compare();
        }
    }
    catch (const Cancelled&)
    {
        // It is stopping.
    }

    tracked.stop();
    paths.clear();
}

/** What the parameters say now. */
TouchSettings TouchWorker::look()
{
    const auto now = owner->settings (settings);
    movement.note (now, FingerMovement::Clock::now());
    return now;
}

/** One round: what was loaded, then the format, then what the parameters say. */
void TouchWorker::step()
{
    if (const auto before = present.model; takeDocument())
    {
        solve (solvedForTouch);

        if (present.model != before)
        {
            playedDevice = present.device;
            tracked.forget();
        }
    }

    takeAmplifiers();
    takeTracking();
    paths.collect();

    if (path != nullptr)
        path->banks().collect();

    settings = look();
    const auto wanted = askedFor();

    if (present.model == nullptr || ! (wanted.sampleRate > 0))
        return;

    if (const auto isFormatNew = std::exchange (format, wanted) != wanted;
        std::exchange (isModelNew, false) || isFormatNew || tracked.isSensorNew())
        buildPath();

    if (path != nullptr)
        takeDrift();

    if (path != nullptr)
        serveFoci();

    if (path != nullptr && designedFor != settings)
        design();
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
                                tracked.changes() };
    foci.serve (*path, surface, std::exchange (isPathNew, false),
                [this, areNotesAwaited] { return areNotesAwaited || owner->settings (settings) == settings; });
}

void TouchWorker::setAmplifiers (std::vector<double> volts)
{
    const std::lock_guard lock (mutex);
    wantedAmplifiers = std::move (volts);
}

/** A path has limits of its own: another one is built where these change. */
void TouchWorker::takeAmplifiers()
{
    const auto isSolvedNew = present.model != limited;

    if (isSolvedNew)
        solved = present.model;

    {
        const std::lock_guard lock (mutex);

        if (solved == nullptr || (! isSolvedNew && amplifiers == wantedAmplifiers))
            return;

        amplifiers = wantedAmplifiers;
    }

    if (auto made = withAmplifiers (solved, amplifiers);
        isSolvedNew || voltageLimits (*made) != voltageLimits (*limited))
    {
        present.model = limited = std::move (made);
        isModelNew = true;
        publish();
    }
}

/** Fingers that load the surface make other modes of it. */
void TouchWorker::takeTracking()
{
    tracked.take (present.model.get());

    if (present.model != nullptr)
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
    isRetuned = present.playedFingers == settings;
    designedFor.reset();
}

void TouchWorker::makeDesigner()
{
    designer = std::make_unique<TouchDesigner> (tracked.driven (present.model), format.sampleRate, format.inputs);
    tracked.noteDesigned();
}

void TouchWorker::buildPath()
{
    path = nullptr; // Whatever played plays on until there is another one.
    designer = nullptr;
    designedFor.reset();
    isRetuned = false;
    present.designs = {};
    present.formatError.clear();

    try
    {
        auto made = std::make_unique<TouchPath> (present.model, format.inputs, TrackBand {},
                                                 TouchDesigner::filterSettings (format.sampleRate, settings.latency),
                                                 threshold, tracked.listen (present.model, format.sampleRate));
        makeDesigner();
        path = made.get();
        isPathNew = true;
        tail = std::log (1000) / decayRates (*present.model).minCoeff() + FilterSettings().length;
        paths.give (std::move (made));
    }
    catch (const std::exception& failure)
    {
        present.formatError = failure.what();
    }

    publish();
}

void TouchWorker::waitUntilSettled (std::span<const FocusEvent> notes)
{
    const auto await = [this] (std::optional<std::vector<int>> awaited)
    {
        const std::lock_guard lock (mutex);
        awaitedNotes = std::move (awaited);
    };
    std::vector<int> numbers { spotNote };

    for (const auto& event : notes)
        if (event.kind == FocusEventKind::trigger)
            numbers.push_back (event.place);

    await (std::move (numbers));
    DeviceRounds::waitUntilSettled();
    await ({});
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

template <typename Sample>
void TouchWorker::process (const TouchBlock<Sample>& block, const TouchControls& controls)
{
    if (auto* const current = paths.current (preparedRate, block.count))
    {
        fullScale.store (current->fullScaleVolts(), std::memory_order_relaxed);
        auto now = controls;
        now.notes = foci.notes();
        current->process (block, now, paths.isLeaving(), levels, fingerLevels);
        return;
    }

    for (auto* const channel : block.ceramics)
        std::fill_n (channel, block.count, Sample (0));
}

template void TouchWorker::process (const TouchBlock<float>&, const TouchControls&);
template void TouchWorker::process (const TouchBlock<double>&, const TouchControls&);
} // namespace antinode
