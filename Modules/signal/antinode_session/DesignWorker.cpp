#include "DesignWorker.h"

#include "Documents.h"

#include <antinode_base/Watch.h>
#include <antinode_documents/FocusFile.h>
#include <antinode_documents/SkinThresholds.h>
#include <antinode_focus/DesignFocus.h>
#include <antinode_focus/FeltLevels.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_focus/FocusPlaces.h>
#include <antinode_focus/FocusScore.h>
#include <antinode_model/Surface.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace antinode
{
namespace
{
/** Where more of a field than this is in modes beyond, a place guards all that are known of. */
constexpr double mostSpillOver = 1.5 * allowedSpillOver;

/** A request without its limits. */
std::string textWithoutLimits (FocusDescription focus, Playback playback)
{
    focus.allocation.voltageLimit.reset();
    return focusToJson (focus).dump() + std::to_string (playback.sampleRate);
}
} // namespace

void PlaceDesigner::begin (const DesignRequest& request)
{
    auto text = textWithoutLimits (request.focus, request.playback);

    if (known != request.model)
        wide.reset();

    if (known != request.model || guardedFocus != text)
        guarded.reset();

    known = request.model;
    guardedFocus = std::move (text);
    areGuardsSure = false;
}

FocusDesign PlaceDesigner::design (const DesignRequest& request, const FocusDescription& focus)
{
    if (focus.allocation.method == AllocationMethod::leastVoltage && request.widen)
        return designSamples (request, focus);

    return designFocus (*request.model, focus, request.playback, DesignExtent::playable);
}

FocusDesign PlaceDesigner::designSamples (const DesignRequest& request, const FocusDescription& focus)
{
    if (! wide)
        wide = request.widen();

    try
    {
        if (guarded)
            return designKeepingGuards (focus, request.playback);
    }
    catch (const LimitError&)
    {
        // The limits may leave room for fewer guards.
    }

    auto design = designWithin (*wide, focus, request.playback, DesignExtent::playable);

    if (! guarded && design.spillOver)
    {
        guarded = firstModes (wide->model, wide->known + design.spillOver->guardedBeyond);
        areGuardsSure = true;
    }

    return design;
}

/** The first place after limits moved says whether its guards still do; where not, the next one looks for others. A
   place that needs more than the first one has them for itself. */
FocusDesign PlaceDesigner::designKeepingGuards (const FocusDescription& focus, Playback playback)
{
    auto design = designGuarding (*guarded, wide->known, focus, playback);
    const auto share = spillOverShare (*wide, design);
    const auto mayGuardMore = guarded->modes() < wide->model.modes();

    if (! std::exchange (areGuardsSure, true) && share > allowedSpillOver)
        guarded.reset();

    if (share > mostSpillOver && mayGuardMore)
        return withAllGuards (std::move (design), share, focus, playback);

    return design;
}

/** Guards all modes that are known of where that leaves less in them and no more elsewhere, and limits allow it. */
FocusDesign PlaceDesigner::withAllGuards (FocusDesign design, double share, const FocusDescription& focus,
                                          Playback playback) const
{
    try
    {
        auto more = designGuarding (wide->model, wide->known, focus, playback);
        const auto isBetter = spillOverShare (*wide, more) < share
                              && largestFieldError (wide->model, more) <= largestFieldError (wide->model, design);
        return isBetter ? std::move (more) : std::move (design);
    }
    catch (const LimitError&)
    {
        return design;
    }
}

namespace
{
constexpr auto partInterval = std::chrono::milliseconds (100); ///< Between parts of a bank that are handed over.

/** Designs younger than this are finished even if outdated, so that a moving parameter is audible. */
constexpr auto longDesign = std::chrono::milliseconds (250);

constexpr auto lookInterval = std::chrono::milliseconds (5); ///< Between looks at the watch of those who wait.

/** Whether a bank has room for a focus: the live one comes first, then those that are touched, then those of notes, all
    of them or none. Asked of the live one before another one is designed: they are alike. */
void requireRoom (const PlayableFocus* focus, const DesignRequest& request, int place)
{
    constexpr std::size_t liveAndTouched = FocusBank::places - FocusBank::notePlaces;
    const auto others = liveAndTouched + (place < FocusBank::notePlaces ? request.places.size() : 0);

    if (focus != nullptr)
        requireRoomInBank (*focus, place == FocusBank::livePlace ? 1 : others);
}
} // namespace

PrepareDesign preparesFocus (FocusDescription description)
{
    return [description = std::move (description)] (const ModalModel& model, Playback playback)
    {
        const auto design = designFocus (model, description, playback, DesignExtent::playable);
        const auto& target = design.description.targets.front();
        return PreparedDesign { design.program, peakVoltage (design), design.captured, { target.x, target.y } };
    };
}

DesignWorker::DesignWorker (BankHandOver& handOverToUse) : handOver (handOverToUse), thread ([this] { run(); }) {}

DesignWorker::~DesignWorker()
{
    {
        const std::lock_guard lock (mutex);
        isStopping = true;
        changed.notify_all();
    }
    thread.join();
}

void DesignWorker::request (DesignRequest request)
{
    request.places.resize (std::min<std::size_t> (request.places.size(), FocusBank::notePlaces));
    const std::lock_guard lock (mutex);
    const auto end = state.endSeconds;
    state = {};
    state.endSeconds = end;
    state.wanted = static_cast<int> (request.places.size()) + 1;
    state.volts.resize (request.places.size());
    isReady.fill (false);
    next = std::move (request);
    nextRequestTime = Clock::now();
    isAbandoned = false;
    changed.notify_all();
}

void DesignWorker::abandon()
{
    const std::lock_guard lock (mutex);
    next.reset();
    isAbandoned = true;
    state.wanted = state.designed;
    changed.notify_all();
}

bool DesignWorker::touch (double x, double y, std::function<void (int)> ready, std::function<bool()> isWanted)
{
    const std::lock_guard lock (mutex);
    std::erase_if (touches, [] (const auto& waiting) { return waiting.isVoid(); });

    if (touches.size() >= FocusBank::touchPlaces)
        return false;

    touches.push_back ({ x, y, std::move (ready), std::move (isWanted) });
    changed.notify_all();
    return true;
}

void DesignWorker::waitFor (std::span<const int> places)
{
    std::unique_lock lock (mutex);
    urgent.assign (places.begin(), places.end()); // those of a wait that was cancelled are not needed any longer
    const auto isPlaceReady = [this] (int place) { return isReady[static_cast<std::size_t> (place)]; };
    const auto isReadyOrIdle = [&]
    {
        const auto isIdle = ! next && ! isWorking;
        return isIdle || (! next && std::all_of (places.begin(), places.end(), isPlaceReady));
    };

    while (! changed.wait_for (lock, lookInterval, isReadyOrIdle))
        checkWatch();

    urgent.clear();
}

void DesignWorker::prepare (int place, PrepareDesign design, std::function<void (const PreparedFocus&)> ready)
{
    const std::lock_guard lock (mutex);
    prepared[place] = { std::move (design), std::move (ready) };
    changed.notify_all();
}

/** Under the mutex. */
bool DesignWorker::isAnyUnprepared() const
{
    return accepted
           && std::any_of (prepared.begin(), prepared.end(),
                           [] (const auto& each) { return ! each.second.isDesigned; });
}

/** Before the notes' places that are not designed yet, until something else is asked for. */
void DesignWorker::designPrepared()
{
    for (;;)
    {
        int place = 0;
        Prepared wanted;
        {
            const std::lock_guard lock (mutex);
            const auto found = std::find_if (prepared.begin(), prepared.end(),
                                             [] (const auto& each) { return ! each.second.isDesigned; });

            if (! accepted || found == prepared.end() || next || ! touches.empty() || isStopping)
                return;

            found->second.isDesigned = true;
            place = found->first;
            wanted = found->second;
        }

        if (const auto result = designPreparedPlace (place, wanted.design))
            wanted.ready (*result);
    }
}

/** @return  none where the worker ends */
std::optional<PreparedFocus> DesignWorker::designPreparedPlace (int place, const PrepareDesign& prepareDesign)
{
    const auto index = static_cast<std::size_t> (place - FocusBank::firstPreparedPlace);
    bank.prepared.resize (std::max (bank.prepared.size(), index + 1));
    auto& kept = bank.prepared[index];
    kept = nullptr;
    PreparedFocus result;
    const WatchScope scope (
        [this]
        {
            const std::lock_guard lock (mutex);
            return ! isStopping;
        });

    try
    {
        const auto design = prepareDesign (*accepted->model, accepted->playback);
        auto made = std::make_shared<const PlayableFocus> (design.program, accepted->playback);
        requireRoomBeside (bank, *made);
        result.endSeconds = static_cast<double> (made->endSample) / accepted->playback.sampleRate;
        result.focusSeconds = design.program.focusTime;
        result.peakVoltage = design.peakVoltage;
        result.captured = design.captured;
        result.sensationLevel = feltLevels (*accepted->model, design.program, accepted->playback,
                                            std::max (result.endSeconds, 2 * design.program.focusTime), { design.at },
                                            findSkinThreshold ({}))
                                    .front();
        kept = std::move (made);
    }
    catch (const Cancelled&)
    {
        return std::nullopt;
    }
    catch (const std::exception& failure)
    {
        result.error = failure.what();
    }

    handOverBank();
    return result;
}

DesignProgress DesignWorker::progress() const
{
    const std::lock_guard lock (mutex);
    return state;
}

bool DesignWorker::isOutdated() const
{
    const std::lock_guard lock (mutex);
    return next.has_value() || isStopping || isAbandoned;
}

void DesignWorker::run()
{
    for (;;)
    {
        Clock::time_point asked;
        auto isNew = false;
        {
            std::unique_lock lock (mutex);
            isWorking = false;
            changed.notify_all();
            changed.wait (lock,
                          [this] { return next.has_value() || ! touches.empty() || isAnyUnprepared() || isStopping; });

            if (isStopping)
                return;

            isNew = next.has_value();
            isWorking = true;

            if (isNew)
            {
                const auto isSame = accepted && accepted->model == next->model
                                    && accepted->playback.sampleRate == next->playback.sampleRate;

                for (auto& [place, each] : prepared)
                    each.isDesigned = each.isDesigned && isSame;

                accepted = std::move (*next);
            }

            next.reset();
            asked = nextRequestTime;
        }

        if (isNew)
            designBank (*accepted, asked);

        designTouches();
        designPrepared();
    }
}

void DesignWorker::designBank (const DesignRequest& request, Clock::time_point asked)
{
    std::fill (bank.foci.begin() + static_cast<std::ptrdiff_t> (request.places.size()),
               bank.foci.begin() + FocusBank::livePlace, nullptr);
    std::fill (bank.foci.begin() + FocusBank::firstTouchPlace, bank.foci.end(), nullptr);
    Places isDone {};
    designer.begin (request);

    if (! designPlace (request, FocusBank::livePlace, request.focus))
        return;

    isDone[FocusBank::livePlace] = true;
    handOverBank();
    noteReady (request, isDone, asked);
    auto lastPart = Clock::now();

    for (BankOrder order (request.first, request.places.size()); ! order.isEmpty() && ! isOutdated();)
    {
        const auto [place, isAwaited] = nextPlace (order);
        const auto [x, y] = request.places[static_cast<std::size_t> (place)];

        if (! designPlace (request, place, movedTo (request.focus, x, y)))
            return;

        isDone[static_cast<std::size_t> (place)] = true;

        if (isAwaited || Clock::now() - lastPart >= partInterval || order.isEmpty())
        {
            handOverBank();
            noteReady (request, isDone, asked);
            lastPart = Clock::now();
        }

        designTouches();
        designPrepared();
    }
}

BankOrder::Next DesignWorker::nextPlace (BankOrder& order) const
{
    const std::lock_guard lock (mutex);
    return order.take (urgent);
}

void DesignWorker::noteReady (const DesignRequest& request, const Places& isDone, Clock::time_point asked)
{
    const std::chrono::duration<double, std::milli> elapsed = Clock::now() - asked;
    const std::lock_guard lock (mutex);

    if (next)
        return; // The state is the next request's already.

    isReady = isDone;
    state.hasFirst = std::all_of (request.first.begin(), request.first.end(),
                                  [&] (int place) {
                                      return place >= static_cast<int> (request.places.size())
                                             || isDone[static_cast<std::size_t> (place)];
                                  });

    if (state.firstMilliseconds == 0)
        state.firstMilliseconds = elapsed.count();

    changed.notify_all();
}

void DesignWorker::designTouches()
{
    std::vector<Touch> asked;
    {
        const std::lock_guard lock (mutex);
        asked.swap (touches);
    }

    for (const auto& touch : asked)
        if (! touch.isVoid())
            designTouch (touch);
}

void DesignWorker::designTouch (const Touch& touch)
{
    const WatchScope scope ([&touch] { return ! touch.isVoid(); });
    const auto place = FocusBank::firstTouchPlace + nextTouchPlace;
    const auto isDesigned = accepted && designPlace (*accepted, place, movedTo (accepted->focus, touch.x, touch.y))
                            && bank.foci[static_cast<std::size_t> (place)] != nullptr;
    nextTouchPlace = (nextTouchPlace + 1) % FocusBank::touchPlaces;
    handOverBank();
    touch.ready (isDesigned ? place : -1);
}

/** Touches are outdated by a stop alone: who asked waits for an answer. */
bool DesignWorker::mayContinue (int place, Clock::time_point begin) const
{
    const std::lock_guard lock (mutex);
    const auto isReplaced = isAbandoned || (next && Clock::now() - begin > longDesign);
    return ! isStopping && (place >= FocusBank::firstTouchPlace || ! isReplaced);
}

/** @return  false where it was given up: the place keeps what it has */
bool DesignWorker::designPlace (const DesignRequest& request, int place, const FocusDescription& description)
{
    std::shared_ptr<const PlayableFocus> focus;
    std::string error;
    PlaceVolts volts;
    const WatchScope scope ([this, place, begin = Clock::now()] { return mayContinue (place, begin); });

    try
    {
        requireRoom (bank.foci[FocusBank::livePlace].get(), request, place);
        const auto design = place == FocusBank::livePlace && request.written != nullptr
                                ? designAsWritten (*request.written, *request.model)
                                : designer.design (request, description);
        auto made = std::make_shared<const PlayableFocus> (design.program, request.playback);
        requireRoom (made.get(), request, place);
        volts = { peakVoltage (design), design.minimumPeakVoltage };
        focus = std::move (made);
    }
    catch (const Cancelled&)
    {
        return false;
    }
    catch (const std::exception& failure)
    {
        error = failure.what();
    }

    const auto failed = focus == nullptr;
    bank.foci[static_cast<std::size_t> (place)] = std::move (focus);
    const std::lock_guard lock (mutex);

    if (next || isAbandoned || place >= FocusBank::firstTouchPlace)
        return true; // The state is the next request's already, or does not count this place.

    ++state.designed;

    if (place < static_cast<int> (state.volts.size()))
        state.volts[static_cast<std::size_t> (place)] = volts;

    if (! failed)
        return true;

    ++state.failed;
    state.error = error;

    if (place == FocusBank::livePlace)
        state.liveError = error;
    else
        state.failedNotes.insert (std::upper_bound (state.failedNotes.begin(), state.failedNotes.end(), place), place);

    return true;
}

void DesignWorker::handOverBank()
{
    if (accepted)
    {
        const std::lock_guard lock (mutex);
        state.endSeconds = static_cast<double> (bank.latestEndSample()) / accepted->playback.sampleRate;
    }

    handOver.give (std::make_unique<const FocusBank> (bank));
}
} // namespace antinode
