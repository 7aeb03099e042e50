#include "TouchSession.h"

#include "NoteBank.h"

#include <antinode_base/InputError.h>
#include <antinode_base/Watch.h>
#include <antinode_documents/Library.h>
#include <antinode_documents/SkinThresholds.h>

#include <algorithm>
#include <chrono>
#include <cmath>
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
        path = made.get();
        isPathNew = true;
        ringing = made->ringingSeconds();
        late = made->lateSamples();
        give (std::move (made));
    }
    catch (const std::exception& failure)
    {
        present.formatError = failure.what();
    }

    publish();
}
} // namespace antinode
