#include "Session.h"

#include "FocusSettings.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Library.h>
#include <antinode_focus/SuitableFocus.h>
#include <antinode_model/IdleCeramics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// The work of a session's thread: takes documents, solves devices, builds paths.
namespace antinode
{
namespace
{
constexpr double traceEntriesPerSecond = 2000;
constexpr double usualRate = 48000; // Hz, before a host says it
} // namespace

void Session::work()
{
    step (take());
    waitForNotes();
    setProgress (path != nullptr ? path->foci().progress() : DesignProgress {});
}

Session::Requests Session::take()
{
    const std::lock_guard lock (mutex);
    auto taken = asked;
    taken.hasDevice = nextDevice != nullptr;

    if (taken.hasDevice)
        present.device = std::exchange (nextDevice, nullptr);

    asked.focus = nullptr;
    asked.choosesFocus = asked.isInsertionNew = asked.isOrderNew = false;
    asked.fired.clear();
    return taken;
}

void Session::setProgress (const DesignProgress& progress)
{
    const std::lock_guard lock (mutex);
    designs = progress;
}

/** One round: what was loaded, then what the parameters say, then what was fired. */
void Session::step (const Requests& wanted)
{
    takeDocuments (wanted);
    takeAmplifiers();
    deviceFollowing.take (present.model.get());
    takeFingers();
    takeGraphChoice (wanted);
    collect();
    deviceFollowing.read (present.model.get());
    const auto read = owner.settings (settings);

    if (const auto wantedRate = askedFor(); present.model != nullptr && wantedRate > 0)
    {
        const auto needsPath = isModelNew || rate != wantedRate || isGraphNew || deviceFollowing.isSensorNew();
        const auto needsDesigns = needsPath || isFocusNew || read != settings || hasDrifted();
        settings = read;
        rate = wantedRate;

        if (needsPath)
            buildPath();

        if (needsDesigns && path != nullptr)
            requestDesigns (wanted.firstNotes);

        if (needsDesigns)
            publish();
    }

    designFired (wanted.fired);
}

void Session::takeDocuments (const Requests& wanted)
{
    // Another order makes another request too.
    isFocusNew = isFocusNew || wanted.focus != nullptr || wanted.isOrderNew;

    if (wanted.focus != nullptr)
        focus = wanted.focus;

    if (! wanted.hasDevice)
        return;

    solve (
        [&]
        {
            deviceFollowing.forget();

            if (wanted.choosesFocus && takeFocus)
                chooseFocus();
        });
}

/** For a device that came without a focus: the focus of the device before may lie on an edge of this one. */
void Session::chooseFocus()
{
    try
    {
        const WatchScope scope (
            [this]
            {
                const std::lock_guard lock (mutex);
                return nextDevice == nullptr && asked.focus == nullptr;
            });
        const Playback playback { Reconstruction::bandLimited, rate > 0 ? rate : usualRate };
        const auto json = focusToJson (suitableFocus (*present.model, playback));
        auto chosen = std::make_shared<const FocusDocument> (readFocusDocument (nlohmann::json (json), "focus"));
        auto isTaken = false;

        if (owner.call ([&] { isTaken = takeFocus (chosen, *focus); }) && isTaken)
        {
            focus = std::move (chosen);
            isFocusNew = true;
            const std::lock_guard lock (mutex);
            newest = focus;
        }
    }
    catch (const Cancelled&)
    {
        checkWatch();
    }
    catch (const std::exception&)
    {
        // The focus of the device before stays: what is wrong with it on this one is said where it is designed.
    }
}

/** Fingers change the modes, and a ceramic that listens drives nothing, so what plays becomes another path. */
void Session::takeFingers()
{
    const auto& model = present.model;
    const auto& wanted = focus->description.fingers;
    auto listening = deviceFollowing.idleCeramics (model.get());

    if (model == loadedModelOf && wanted == fingers && listening == idle)
        return;

    isModelNew = isModelNew || wanted != fingers;
    loadedModelOf = loadedModel = designedModel = model;
    fingers = wanted;
    idle = std::move (listening);
    present.fingerError.clear();

    if (model == nullptr)
        return;

    if (! idle.empty())
        loadedModel = designedModel = std::make_shared<const ModalModel> (withoutDrive (*model, idle));

    if (fingers.empty())
        return;

    try
    {
        auto loaded = loadedByFingers ({ *loadedModel, loadedModel->modes(), {}, {} }, fingers);
        loadedModel = std::make_shared<const ModalModel> (std::move (loaded.model));
        designedModel = std::make_shared<const ModalModel> (std::move (*loaded.designed));
    }
    catch (const InputError& failure)
    {
        present.fingerError = std::string ("Played without fingers: ") + failure.what();
    }
}

/** One that fails is not tried again before something else is wanted. */
void Session::buildPath()
{
    path = nullptr;

    try
    {
        // Under fingers the modes are others: the follower says what it cannot follow.
        auto made = std::make_unique<InstrumentPath> (
            loadedModel, rate, InstrumentNodes { {}, graph, {}, probeShapes() },
            deviceFollowing.listen (fingers.empty() ? present.model : loadedModel, rate));
        path = made.get();
        played.trace.prepare (std::max (1, static_cast<int> (rate / traceEntriesPerSecond)));
        give (std::move (made));
        ringing = static_cast<double> (path->lateSamples()) / rate + path->ringingSeconds();
    }
    catch (const std::exception& failure)
    {
        present.error = failure.what();
    }

    isModelNew = isGraphNew = false;
}

void Session::takeGraphChoice (const Requests& wanted)
{
    const auto wasOpen = std::exchange (graph.isOpen, wantsOpenGraph.load());
    isGraphNew = isGraphNew || graph.isOpen != wasOpen || (graph.isOpen && wanted.isInsertionNew);

    if (wanted.isInsertionNew)
        graph.insert = wanted.insert;
}

void Session::describe()
{
    ++present.generation;
    present.focusDocument = focus;
    present.settings = settings;
    present.playback = { Reconstruction::bandLimited, rate };

    if (present.model != nullptr)
    {
        present.focus = withSettings (focus->description, settings, present.model->surface);
        present.isAsWritten = written() != nullptr;
        present.notePlaces = notePlaces();
    }
}
} // namespace antinode
