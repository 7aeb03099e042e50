#include "FocusSettings.h"
#include "Session.h"

#include <antinode_base/InputError.h>
#include <antinode_focus/FocusMoments.h>
#include <antinode_library/Library.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto lookInterval = std::chrono::milliseconds (4); // between looks at the parameters
constexpr double traceEntriesPerSecond = 2000;

PlayerSettings playerSettingsOf (const PlaySettings& settings)
{
    PlayerSettings player;
    player.noteOff = static_cast<NoteOffBehaviour> (settings.noteOff);
    player.retrigger = static_cast<RetriggerBehaviour> (settings.retrigger);
    player.focusOnNote = settings.focusOnNote;
    return player;
}

bool needNewPath (const PlaySettings& one, const PlaySettings& other)
{
    return one.noteOff != other.noteOff || one.retrigger != other.retrigger || one.focusOnNote != other.focusOnNote;
}
} // namespace

void Session::run()
{
    for (;;)
    {
        std::uint64_t round = 0;
        auto waitsForDesigns = false;
        std::vector<int> places;
        {
            std::unique_lock lock (mutex);
            wake.wait_for (lock, lookInterval,
                           [this] {
                               return isStopping || nextDevice || nextFocus || ! touches.empty()
                                      || roundsAsked > roundsDone;
                           });

            if (isStopping)
                return;

            round = roundsAsked;
            waitsForDesigns = settleAsked > roundsDone;
            places = settlePlaces;
        }

        step();

        if (waitsForDesigns && path != nullptr)
            path->worker().waitFor (places);

        const std::lock_guard lock (mutex);
        designs = path != nullptr ? path->worker().progress() : DesignProgress {};
        roundsDone = round;
        settled.notify_all();
    }
}

/** One round: what was loaded, then what the parameters say, then what was touched. */
void Session::step()
{
    takeDocuments();
    paths.collect();
    const auto read = readSettings();
    const auto wanted = wantedSampleRate();

    if (model != nullptr && wanted > 0)
    {
        const auto isOtherGraph = takeGraphChoice();
        const auto needsPath =
            path == nullptr || isModelNew || rate != wanted || isOtherGraph || needNewPath (read, settings);
        const auto needsDesigns = needsPath || isFocusNew || read != settings;
        settings = read;

        if (needsPath)
            buildPath (wanted);

        if (needsDesigns && path != nullptr)
            requestDesigns();

        if (needsDesigns)
            publish();
    }

    forwardTouches();
}

void Session::takeDocuments()
{
    std::shared_ptr<const DeviceDocument> newDevice;
    {
        const std::lock_guard lock (mutex);
        newDevice = std::exchange (nextDevice, nullptr);
        // Another order makes another request too.
        isFocusNew = nextFocus != nullptr || std::exchange (isFirstNew, false) || isFocusNew;

        if (nextFocus != nullptr)
            focus = std::exchange (nextFocus, nullptr);

        isSolving = newDevice != nullptr;
    }

    if (newDevice == nullptr)
        return;

    device = newDevice;
    publish();
    solve (*newDevice);
    {
        const std::lock_guard lock (mutex);
        isSolving = false;
        designs = {}; // They belong to the previous device.
    }
    publish();
}

void Session::solve (const DeviceDocument& document)
{
    try
    {
        auto solved = std::make_shared<const ModalModel> (solveDevice (document.description, {}, true));

        if (solved->actuators() == 0)
            throw InputError ("device '" + document.description.name + "'", "has no ceramics; nothing can be played");

        model = std::move (solved);
        isModelNew = true;
        deviceError.clear();
    }
    catch (const std::exception& failure)
    {
        deviceError = failure.what();
    }
}

void Session::buildPath (double sampleRate)
{
    try
    {
        auto made = std::make_unique<AudioPath> (model, sampleRate, playerSettingsOf (settings), probeShapes(), graph);
        path = made.get();
        rate = sampleRate;
        isModelNew = false;
        trace.prepare (std::max (1, static_cast<int> (sampleRate / traceEntriesPerSecond)));
        paths.give (std::move (made));
        tail = latestFocusTime (focus->description) + std::log (1000) / decayRates (*model).minCoeff();
    }
    catch (const std::exception& failure)
    {
        deviceError = failure.what();
        isModelNew = false;
    }
}

/** @return  whether a path must be made for it */
bool Session::takeGraphChoice()
{
    const std::lock_guard lock (mutex);
    const auto wasOpen = std::exchange (graph.isOpen, wantsOpenGraph.load());

    if (std::exchange (isInsertionNew, false))
    {
        graph.insert = insertion;
        return graph.isOpen || wasOpen;
    }

    return graph.isOpen != wasOpen;
}

double Session::wantedSampleRate() const
{
    const std::lock_guard lock (mutex);
    return wantedRate;
}

void Session::publish()
{
    auto now = std::make_shared<SessionSnapshot>();
    now->device = device;
    now->focusDocument = focus;
    now->model = model;
    now->settings = settings;
    now->deviceError = deviceError;
    now->playback = { Reconstruction::bandLimited, rate };

    if (model != nullptr)
    {
        now->focus = withSettings (focus->description, settings, model->surface);
        now->notePlaces = notePlaces();
    }

    {
        const std::lock_guard lock (mutex);
        now->isSolving = isSolving;
        now->generation = published->generation + 1;
        published = std::move (now);
    }
    onChange();
}
} // namespace antinode
