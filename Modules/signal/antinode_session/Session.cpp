#include "Session.h"

#include "Documents.h"
#include "FocusSettings.h"
#include "NoteBank.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/Library.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_model/ModalModel.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

// What front ends ask of a session, and what they are told.
namespace antinode
{
Session::Session (DeviceDocument device, FocusDocument focusToPlay, std::function<PlaySettings()> readSettings,
                  std::function<void()> onChange, TakeFocus takeFocusToCall)
    : InstrumentSession (std::move (device), std::move (readSettings), std::move (onChange)),
      takeFocus (std::move (takeFocusToCall)), newest (std::make_shared<const FocusDocument> (std::move (focusToPlay)))
{
    asked.focus = newest;
    setNotes (NoteMeaning::spread, 0);
}

void Session::load (std::shared_ptr<const DeviceDocument> device, std::shared_ptr<const FocusDocument> wanted)
{
    const std::lock_guard lock (mutex);

    if (device != nullptr)
    {
        nextDevice = std::move (device);
        asked.choosesFocus = true;
    }

    if (wanted != nullptr)
    {
        asked.choosesFocus = false;
        asked.focus = newest = std::move (wanted);
    }

    wake.notify_all();
}

std::shared_ptr<const FocusDocument> Session::newestFocus() const
{
    const std::lock_guard lock (mutex);
    return newest;
}

void Session::prepare (double sampleRate)
{
    AudioEntry::prepare (sampleRate);
    // At once, although the path may come later: hosts ask for it now.
    latency = estimateLatency (newestFocus()->description, owner.settings ({}), sampleRate);
    ask (sampleRate);
}

void Session::insertNodes (InsertNodes insert)
{
    const std::lock_guard lock (mutex);
    asked.isInsertionNew = true;
    asked.insert = {};

    if (insert)
        asked.insert = [this, insert = std::move (insert)] (NodeGraph& nodes, GraphPlace place, int last)
        {
            owner.call ([&] { last = insert (nodes, place, last); });
            return last;
        };
}

void Session::designFirst (std::vector<int> notes)
{
    const std::lock_guard lock (mutex);
    asked.firstNotes = std::move (notes);
    asked.isOrderNew = true;
}

void Session::fire (double amplitude)
{
    AudioEntry::fire (FocusBank::livePlace, amplitude, stops().now());
}

Session::FireResult Session::fireAt (double x, double y, double amplitude)
{
    const auto askedAt = stops().now();
    const auto now = snapshot();

    if (now->model == nullptr)
        return FireResult::notAccepted;

    const auto& surface = now->model->surface;

    if (! liesOn (surface, x, y))
        return FireResult::outsideSurface;

    // Those from before the last stop wait no longer.
    const std::lock_guard lock (mutex);
    std::erase_if (asked.fired, [askedAt] (const auto& earlier) { return earlier.askedAt < askedAt; });

    if (asked.fired.size() >= FocusBank::touchPlaces)
        return FireResult::notAccepted;

    asked.fired.push_back ({ x, surface.kind == SurfaceKind::line ? 0.0 : y, amplitude, askedAt });
    wake.notify_all();
    return FireResult::taken;
}

DesignProgress Session::progress() const
{
    const std::lock_guard lock (mutex);
    return designs;
}

double Session::tailSeconds()
{
    const auto end = estimateEnd (newestFocus()->description, owner.settings ({}));
    return std::max (end, progress().endSeconds) + ringing;
}

void Session::requestDesigns (const std::vector<int>& firstNotes)
{
    const auto description = withSettings (focus->description, settings, present.model->surface);
    auto asWritten = written();
    latency = estimateLatency (focus->description, settings, rate) + path->lateSamples();
    setNotes (settings.noteLayout == NoteLayout::spot || asWritten != nullptr ? NoteMeaning::spotOnly
                                                                              : NoteMeaning::spread,
              description.targets.front().level.value_or (0));
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

// The work of a session's thread: takes documents, solves devices, builds paths.
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

    servePrepared();
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
        played.trace.prepare (std::max (1, static_cast<int> (rate / traceEntriesPerSecond)));
        playOn (std::move (made));
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
