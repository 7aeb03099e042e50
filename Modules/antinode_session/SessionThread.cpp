#include "FocusSettings.h"
#include "Session.h"

#include <antinode_focus/BankPlaces.h>
#include <antinode_focus/FocusMoments.h>
#include <antinode_library/Library.h>
#include <antinode_model/InputError.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace antinode
{
namespace
{
constexpr auto interval = std::chrono::milliseconds (4); // between looks at the parameters
constexpr double traceEntriesPerSecond = 2000;
constexpr double bankMargin = 0.1; // of the surface's shorter side, kept from its edges

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
            wake.wait_for (lock, interval,
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
        const auto needsPath = path == nullptr || isModelNew || rate != wanted || needNewPath (read, settings);
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
        isFocusNew = nextFocus != nullptr || isFocusNew;

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
    }
    publish();
}

void Session::solve (const DeviceDocument& document)
{
    try
    {
        auto solved = std::make_shared<const ModalModel> (solveDevice (document.description, {}, true));

        if (solved->actuators() == 0)
            throw InputError ("device '" + document.description.name + "'",
                              "has no ceramics, so nothing can be played");

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
        auto made = std::make_unique<AudioPath> (model, sampleRate, playerSettingsOf (settings), probeShapes());
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

void Session::requestDesigns()
{
    const auto description = withSettings (focus->description, settings, model->surface);
    latency = settings.focusOnNote ? std::llround (earliestFocusTime (description) * rate) : 0;
    playsSpotOnly = settings.noteLayout == static_cast<int> (NoteLayout::spot);
    isFocusNew = false;

    try
    {
        path->plate().setProbes (probeShapes());
    }
    catch (const InputError&)
    {
        // A focus of another device may have probes beside this surface: the monitor stays where it was.
    }

    path->worker().request ({ model, description, notePlaces(), spotNote, { Reconstruction::bandLimited, rate } });
}

std::vector<std::pair<double, double>> Session::notePlaces() const
{
    if (settings.noteLayout == static_cast<int> (NoteLayout::spot))
        return {};

    const auto& surface = model->surface;
    const auto width = surface.xMaximum - surface.xMinimum, height = surface.yMaximum - surface.yMinimum;
    const auto shorter = height > 0 ? std::min (width, height) : width;
    auto places = bankPlaces (surface, FocusBank::notePlaces, bankMargin * shorter);
    const auto spot = withSettings (focus->description, settings, surface).targets.front();
    places[spotNote] = { spot.x, spot.y };
    return places;
}

Eigen::MatrixXd Session::probeShapes() const
{
    const auto places = probePlaces (focus->description, settings, model->surface);
    Eigen::MatrixXd shapes (AudioPath::probes, model->modes());
    const auto& surface = model->surface;

    for (std::size_t i = 0; i < places.size(); ++i)
        shapes.row (static_cast<Eigen::Index> (i)) =
            shapesAt (*model, std::clamp (places[i].first, surface.xMinimum, surface.xMaximum),
                      std::clamp (places[i].second, surface.yMinimum, surface.yMaximum));

    return shapes;
}

void Session::forwardTouches()
{
    std::vector<Touch> waiting;
    {
        const std::lock_guard lock (mutex);
        waiting.swap (touches);
    }

    for (const auto& touch : waiting)
        if (path != nullptr)
            path->worker().touch (touch.x, touch.y,
                                  [this, amplitude = touch.amplitude] (int place)
                                  {
                                      if (place >= 0)
                                          triggers.push ({ 0, FocusEventKind::trigger, place, amplitude });
                                  });
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
