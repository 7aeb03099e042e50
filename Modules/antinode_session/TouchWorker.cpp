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
constexpr auto touchRest = std::chrono::milliseconds (20); // for which fingers have stayed where they are
constexpr double usualTouchRate = 48000;                   // Hz, before a host says its own

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

    paths.clear();
}

/** One round: what was loaded, then the format, then what the parameters say. */
void TouchWorker::step()
{
    if (takeDocument())
        solve (solvedForTouch);

    takeAmplifiers();
    paths.collect();

    if (path != nullptr)
        path->banks().collect();

    settings = owner->settings (settings);
    const auto wanted = askedFor();

    if (present.model == nullptr || ! (wanted.sampleRate > 0))
        return;

    if (const auto isFormatNew = std::exchange (format, wanted) != wanted;
        std::exchange (isModelNew, false) || isFormatNew)
        buildPath();

    if (path != nullptr)
        foci.serve (*path, present.device, amplifiers, std::exchange (isPathNew, false));

    if (path != nullptr && designedFor != settings)
        design();
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

void TouchWorker::buildPath()
{
    path = nullptr; // Whatever played plays on until there is another one.
    designer = nullptr;
    designedFor.reset();
    present.designs = {};
    present.formatError.clear();

    try
    {
        auto made = std::make_unique<TouchPath> (present.model, format.inputs, TrackBand {},
                                                 TouchDesigner::filterSettings (format.sampleRate, settings.latency),
                                                 threshold);
        designer = std::make_unique<TouchDesigner> (present.model, format.sampleRate, format.inputs);
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
    foci.serve (*path, present.device, amplifiers, false);
}

/** Whether what was asked for before this round is there, or cannot be. */
bool TouchWorker::isSettled() const
{
    return path == nullptr || designedFor == settings;
}

/** Filters for what the parameters say, unless there are some, and plays them. */
void TouchWorker::design()
{
    designer->setFingers (settings);
    designedFor = settings;
    present.designError.clear();

    try
    {
        if (designer->design (settings.latency) == nullptr)
        {
            playQuickly();

            if (! areFingersResting())
                throw Cancelled();

            makeDesign();
        }

        play (std::make_unique<const FilterBank> (designer->design (settings.latency)->bank));
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

/** Filters for places that may move on before better ones are there. */
void TouchWorker::playQuickly()
{
    const WatchScope scope ([this] { return ! hasOtherPath(); });

    if (auto bank = designer->quickBank (settings.latency); bank != nullptr)
        play (std::move (bank));
}

/** Whether fingers stay where they are for a moment, or somebody waits for their filters. While they move, quick
   filters have the processor for themselves. */
bool TouchWorker::areFingersResting()
{
    const auto end = std::chrono::steady_clock::now() + touchRest;

    while (std::chrono::steady_clock::now() < end)
    {
        std::unique_lock lock (mutex);
        wake.wait_for (lock, interval, [this] { return isStopping || nextDevice || roundsRequested > roundsDone; });

        if (isStopping || nextDevice != nullptr || roundsRequested > roundsDone)
            return true;

        lock.unlock();

        if (owner->settings (settings) != settings)
            return false;
    }

    return true;
}

/** Another device or format ends it, and other places, since quick filters for them sound better than none. */
void TouchWorker::makeDesign()
{
    present.isDesigning = true;
    present.progress = 0;
    publish();
    const WatchScope scope ([this] { return ! hasOtherPath() && owner->settings (settings) == settings; });
    designer->makeDesign (settings.latency,
                          [this] (const std::string&, double share)
                          {
                              present.progress = share;
                              publish();
                          });
}

void TouchWorker::play (std::unique_ptr<const FilterBank> bank)
{
    path->banks().give (std::move (bank));
    present.playedFingers = settings;
    publish();
}

bool TouchWorker::hasOtherPath()
{
    const std::lock_guard lock (mutex);
    return nextDevice != nullptr || wantedFormat != format;
}

/** One more latency, so that their volts can be compared; whatever else there is to do ends it. */
void TouchWorker::compare()
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

bool TouchWorker::hasNews()
{
    {
        const std::lock_guard lock (mutex);

        if (roundsRequested > roundsDone)
            return true;
    }

    return hasOtherPath() || owner->settings (settings) != settings || designedFor != settings;
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
