#include "SessionWorker.h"

#include "Amplifiers.h"
#include "FocusSettings.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_focus/FocusMoments.h>
#include <antinode_focus/SuitableFocus.h>
#include <antinode_focus/WideDesign.h>
#include <antinode_library/Library.h>
#include <antinode_model/IdleCeramics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr double traceEntriesPerSecond = 2000;
constexpr double usualRate = 48000; // Hz, before a host says it
} // namespace

SessionWorker::SessionWorker (std::shared_ptr<SessionRequests> requestsToServe,
                              std::shared_ptr<FollowingRequests> followingToServe,
                              std::shared_ptr<AudioEntry> entryToUse, std::shared_ptr<Owner> ownerToAsk,
                              TakeFocus takeFocusToCall)
    : requests (std::move (requestsToServe)), entry (std::move (entryToUse)), owner (std::move (ownerToAsk)),
      takeFocus (std::move (takeFocusToCall)), following (std::move (followingToServe))
{
}

void SessionWorker::run()
{
    const WatchScope scope ([this] { return ! requests->isStopping(); });

    try
    {
        while (const auto round = requests->next())
        {
            step (*round);

            if (round->awaited && path != nullptr)
                path->worker().waitFor (*round->awaited);

            const auto now = designs();
            requests->finish (round->number, now);

            if (std::exchange (toldEnd, now.endSeconds) != now.endSeconds)
                owner->tell();
        }
    }
    catch (const Cancelled&)
    {
        // It is stopping.
    }

    following.stop();
    entry->clear();
}

/** One round: what was loaded, then what the parameters say, then what was touched. */
void SessionWorker::step (const SessionRound& round)
{
    takeAmplifiers (round);
    takeDocuments (round);
    following.take (model.get());
    takeFingers();
    takeGraphChoice (round);
    entry->collect();
    following.read (model.get());
    const auto read = owner->settings (settings);

    if (model != nullptr && round.sampleRate > 0)
    {
        const auto needsPath = isModelNew || rate != round.sampleRate || isGraphNew || following.isSensorNew();
        const auto needsDesigns = needsPath || isFocusNew || read != settings || hasDrifted();
        settings = read;
        rate = round.sampleRate;

        if (needsPath)
            buildPath();

        if (needsDesigns && path != nullptr)
            requestDesigns (round.firstNotes);

        if (needsDesigns)
            publish();
    }

    forwardTouches (round.touches);
}

void SessionWorker::takeDocuments (const SessionRound& round)
{
    // Another order makes another request too.
    isFocusNew = isFocusNew || round.focus != nullptr || round.isOrderNew;

    if (round.focus != nullptr)
        focus = round.focus;

    if (round.device == nullptr)
        return;

    device = round.device;
    isSolving = true;
    publish();

    if (solve (*device) && round.choosesFocus && takeFocus)
        chooseFocus();

    isSolving = false;
    requests->setProgress ({}); // It belongs to the previous device.
    publish();
}

/** A newer device ends this one's solving; the next round takes it. */
bool SessionWorker::solve (const DeviceDocument& document)
{
    try
    {
        const WatchScope scope ([this] { return ! requests->hasDevice(); });
        auto made = std::make_shared<const ModalModel> (solveDevice (document.description, {}, true));

        if (made->actuators() == 0)
            throw InputError ("device '" + document.description.name + "'", "has no ceramics; nothing can be played");

        solved = std::move (made);
        model = withAmplifiers (solved, amplifiers);
        isModelNew = true;
        following.forget();
        deviceError.clear();
        return true;
    }
    catch (const Cancelled&)
    {
        checkWatch();
    }
    catch (const std::exception& failure)
    {
        deviceError = failure.what();
    }

    return false;
}

/** For a device that came without a focus: the focus of the device before may lie on an edge of this one. */
void SessionWorker::chooseFocus()
{
    try
    {
        const WatchScope scope ([this] { return ! requests->hasDevice() && ! requests->hasFocus(); });
        const Playback playback { Reconstruction::bandLimited, rate > 0 ? rate : usualRate };
        const auto json = focusToJson (suitableFocus (*model, playback));
        auto chosen = std::make_shared<const FocusDocument> (readFocusDocument (nlohmann::json (json), "focus"));
        auto isTaken = false;

        if (owner->call ([&] { isTaken = takeFocus (chosen, *focus); }) && isTaken)
        {
            focus = std::move (chosen);
            requests->adopt (focus);
            isFocusNew = true;
        }
    }
    catch (const Cancelled&)
    {
        checkWatch();
    }
}

/** A path has limits of its own: another one is built where these change. */
void SessionWorker::takeAmplifiers (const SessionRound& round)
{
    if (amplifiers == round.amplifiers)
        return;

    amplifiers = round.amplifiers;

    if (solved == nullptr)
        return;

    if (auto made = withAmplifiers (solved, amplifiers); voltageLimits (*made) != voltageLimits (*model))
    {
        model = std::move (made);
        isModelNew = true;
    }
}

/** Fingers change the modes, and a ceramic that listens drives nothing, so what plays becomes another path. */
void SessionWorker::takeFingers()
{
    const auto& wanted = focus->description.fingers;

    auto listening = following.idleCeramics (model.get());

    if (model == loadedModelOf && wanted == fingers && listening == idle)
        return;

    isModelNew = isModelNew || wanted != fingers;
    loadedModelOf = played = designed = model;
    fingers = wanted;
    idle = std::move (listening);
    fingerError.clear();

    if (model == nullptr)
        return;

    if (! idle.empty())
        played = designed = std::make_shared<const ModalModel> (withoutDrive (*model, idle));

    if (fingers.empty())
        return;

    try
    {
        auto loaded = loadedByFingers ({ *played, played->modes(), {}, {} }, fingers);
        played = std::make_shared<const ModalModel> (std::move (loaded.model));
        designed = std::make_shared<const ModalModel> (std::move (*loaded.designed));
    }
    catch (const InputError& failure)
    {
        fingerError = std::string ("Played without fingers: ") + failure.what();
    }
}

/** One that fails is not tried again before something else is wanted. */
void SessionWorker::buildPath()
{
    path = nullptr;

    try
    {
        // Under fingers the modes are others: the follower says what it cannot follow.
        auto made = std::make_unique<AudioPath> (played, rate, probeShapes(), graph,
                                                 following.listen (fingers.empty() ? model : played, rate));
        path = made.get();
        entry->probeTrace().prepare (std::max (1, static_cast<int> (rate / traceEntriesPerSecond)));
        entry->give (std::move (made));
        requests->setRingingSeconds (static_cast<double> (path->lateSamples()) / rate
                                     + std::log (1000) / decayRates (*played).minCoeff());
    }
    catch (const std::exception& failure)
    {
        deviceError = failure.what();
    }

    isModelNew = isGraphNew = false;
}

void SessionWorker::takeGraphChoice (const SessionRound& round)
{
    const auto wasOpen = std::exchange (graph.isOpen, round.graph.isOpen);
    isGraphNew = isGraphNew || graph.isOpen != wasOpen || (graph.isOpen && round.isInsertionNew);

    if (round.isInsertionNew)
        graph.insert = round.graph.insert;
}

DesignProgress SessionWorker::designs() const
{
    return path != nullptr ? path->worker().progress() : DesignProgress {};
}

void SessionWorker::publish()
{
    SessionSnapshot now;
    now.device = device;
    now.focusDocument = focus;
    now.model = model;
    now.settings = settings;
    now.isSolving = isSolving;
    now.deviceError = deviceError.empty() ? fingerError : deviceError;
    now.playback = { Reconstruction::bandLimited, rate };

    if (model != nullptr)
    {
        now.focus = withSettings (focus->description, settings, model->surface);
        now.isAsWritten = written() != nullptr;
        now.notePlaces = notePlaces();
    }

    requests->publish (std::move (now));
    owner->tell();
}
} // namespace antinode
