#include "TouchSession.h"

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
constexpr double usualTouchRate = 48000; // Hz, before a host says its own

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

TouchSession::TouchSession (DeviceDocument device, std::function<TouchSettings()> readSettings,
                            std::function<void()> onChange)
    : DeviceRounds (std::move (device), std::move (readSettings), std::move (onChange)),
      threshold (findSkinThreshold ({}))
{
}

void TouchSession::prepare (double sampleRate, int inputs)
{
    preparedRate = sampleRate;
    paths.reset();
    stopCount.stop();
    noteDelay.reset();
    ask ({ sampleRate, inputs });
}

std::int64_t TouchSession::latencySamples (std::size_t latency) const
{
    const auto rate = preparedRate > 0 ? preparedRate.load() : usualTouchRate;

    try
    {
        return filterTiming ({}, TouchDesigner::filterSettings (rate, latency)).latencySamples() + late;
    }
    catch (const InputError&)
    {
        return 0; // There is silence at such a rate.
    }
}

/** Notes wait as long as the filters take. */
double TouchSession::tailSeconds (std::size_t latency) const
{
    const auto rate = preparedRate > 0 ? preparedRate.load() : usualTouchRate;
    const auto delay = static_cast<double> (latencySamples (latency)) / rate, lag = static_cast<double> (late) / rate;
    return std::max (lag + FilterSettings().length, delay + focusProgress().endSeconds) + ringing;
}

void TouchSession::run()
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

    deviceFollowing.stop();
    paths.clear();
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
        solve (solvedForTouch,
               [this]
               {
                   playedDevice = present.device;
                   deviceFollowing.forget();
               });

    takeAmplifiers();
    takeFollowing();
    paths.collect();

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

    if (const auto end = focusProgress().endSeconds; std::exchange (toldEnd, end) != end)
        owner.tell();

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
        auto made = std::make_unique<TouchPath> (present.model, format.inputs, TrackBand {},
                                                 TouchDesigner::filterSettings (format.sampleRate, settings.latency),
                                                 threshold, deviceFollowing.listen (present.model, format.sampleRate));
        makeDesigner();
        path = made.get();
        isPathNew = true;
        ringing = std::log (1000) / decayRates (*present.model).minCoeff();
        late = made->lateSamples();
        paths.give (std::move (made));
    }
    catch (const std::exception& failure)
    {
        present.formatError = failure.what();
    }

    publish();
}

void TouchSession::waitUntilSettled (std::span<const FocusEvent> notes)
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

template <typename Sample>
void TouchSession::process (const AudioBlock<Sample>& block, const TouchControls& controls)
{
    if (auto* const current = paths.current (preparedRate, block.count))
    {
        fullScale.store (current->model().fullScaleVoltage, std::memory_order_relaxed);
        auto now = controls;
        now.notes = foci.notes();
        const auto stop = stopCount.now();
        now.stops = std::exchange (playedStop, stop) != stop;
        current->process (block, now, noteDelay, paths.isLeaving(), levels, fingerLevels);
        return;
    }

    block.silence();
}

template void TouchSession::process (const AudioBlock<float>&, const TouchControls&);
template void TouchSession::process (const AudioBlock<double>&, const TouchControls&);
} // namespace antinode
