#include "HeadlessRun.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>
#include <antinode_base/MessageText.h>
#include <antinode_base/Prefixes.h>
#include <antinode_session/UserMessages.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace antinode
{
/** What is lost says another number with every window: only the first is news. */
std::string FollowingReport::news (const FollowingStatus& now)
{
    const auto isOtherState = std::exchange (state, now.state) != now.state;
    const auto isOtherReason = std::exchange (reason, now.reason) != now.reason;
    const auto hasJumped = state == FollowingState::following && ! reason.empty() && isOtherReason;

    if (! now.trace.empty())
        drift = now.trace.back().common;

    if (! isOtherState && ! hasJumped)
        return {};

    if (state == FollowingState::off)
        return "following off";

    return summary() + (reason.empty() ? std::string() : ": " + reason);
}

void FollowingReport::print (const FollowingStatus& now, double seconds)
{
    if (const auto what = news (now); ! what.empty())
    {
        std::printf ("%.2f s: %s\n", std::max (0.0, seconds), what.c_str());
        std::fflush (stdout);
    }
}

std::string FollowingReport::ending() const
{
    const auto drifted = summary();
    return drifted.empty() ? std::string() : "; " + drifted;
}

std::string FollowingReport::summary() const
{
    if (state == FollowingState::off)
        return {};

    return (drift ? formatted ("drift %+.2f %%, ", 100 * *drift) : std::string ("drift unknown, "))
           + std::string (wordFor (followingStateWords, state));
}

namespace
{
constexpr int tickMilliseconds = 10;
} // namespace

std::string HeadlessRun::counted (std::int64_t count, const std::string& what)
{
    return std::to_string (count) + " " + what + (count == 1 ? "" : "s");
}

void HeadlessRun::complain (const std::string& sentence)
{
    std::fprintf (stderr, "antinode-standalone: %s\n", sentence.c_str());
}

HeadlessRun::HeadlessRun (AudioHost& hostToPlay, double seconds, bool isArmed)
    : host (hostToPlay), duration (seconds), arms (isArmed)
{
}

void HeadlessRun::run()
{
    std::printf ("%s\n", waitingFor().c_str());
    std::fflush (stdout);
    startTimer (tickMilliseconds);
    juce::MessageManager::getInstance()->runDispatchLoop();

    if (! failureText.empty())
        throw InputError ("", failureText);

    std::printf ("%s\n", ending.c_str());
}

/** What there is to tell is asked for while ports and device are open. */
void HeadlessRun::end (const std::string& failure)
{
    failureText = failure;
    stopTimer();
    ending = endText();
    host.shutDown();
    juce::MessageManager::getInstance()->stopDispatchLoop();
}

void HeadlessRun::timerCallback()
{
    if (host.hasDeviceStopped())
        end ("the audio device has stopped");

    if (isTimerRunning() && ! hasBegun)
        beginWhenReady();

    const auto rate = host.callback().sampleRate(); // 0 where the device has gone

    if (isTimerRunning() && hasBegun && rate > 0)
        following.print (*followed().status(), secondsPlayed (rate));

    const auto played = static_cast<double> (host.callback().samplesPlayed() - beginSamples);
    const auto isOver = hasBegun && duration > 0 && rate > 0 && played >= (armTime + duration) * rate;

    // Libraries of audio may block the signal of a pipe that nobody reads any more.
    const auto isUnread = std::ferror (stdout) != 0;

    if (isTimerRunning() && (isOver || isInterrupted() || isUnread))
        end ({});
}

double HeadlessRun::secondsPlayed (double rate) const
{
    return static_cast<double> (host.callback().samplesPlayed() - beginSamples) / rate;
}

void HeadlessRun::beginWhenReady()
{
    try
    {
        if (! isReady())
            return;
    }
    catch (const InputError& failure)
    {
        return end (failure.what());
    }

    if (arms)
        host.arm().setValueNotifyingHost (1);

    hasBegun = true;
    beginSamples = host.callback().samplesPlayed();
    begin(); // Before anybody is told: who reads it may let the device's time pass at once.
    std::printf ("%s\n", startText().c_str());
    std::fflush (stdout);

    if (const auto warning = host.silentCeramics(); warning.isNotEmpty())
        complain (warning.toStdString());
}

std::string HeadlessRun::startText() const
{
    const auto audio = openedAudio (host.devices());
    const auto model = host.model();
    return "playing on " + audio.type + " device '" + audio.device
           + "': " + std::to_string (std::lround (audio.sampleRate)) + " Hz, " + counted (audio.blockSize, "sample")
           + " per block, " + counted (std::ssize (audio.outputs), "output") + "; '" + model->name + "' with "
           + counted (model->actuators(), "ceramic") + ", "
           + (arms ? "armed" : "disarmed: use --arm to drive the outputs") + designsText();
}

std::string HeadlessRun::endText()
{
    char volts[32];
    std::snprintf (volts, sizeof volts, "%.1f", static_cast<double> (host.takePeakVolts()));
    return "ended: " + playedText() + ", at most " + volts + " V, " + clampedText() + ", "
           + counted (host.router().meters().badNumbers(), "block") + " with invalid samples, "
           + counted (std::max (0, host.devices().getXRunCount()), "xrun") + following.ending() + touchText();
}

/** What was held at the limits of ceramics and at the full scale of outputs, and where. */
std::string HeadlessRun::clampedText()
{
    std::int64_t all = 0;
    std::string places;
    const auto add = [&] (const std::string& place, int index, std::int64_t samples)
    {
        if (samples == 0)
            return;

        all += samples;
        places += (places.empty() ? " (" : ", ") + place + std::to_string (index + 1) + ": " + std::to_string (samples);
    };

    for (int i = 0; i < LevelMeters::ceramics; ++i)
        add ("ceramic ", i, host.meters().limitedSamples (i));

    for (int i = 0; i < OutputRouting::maximumOutputs; ++i)
        add ("output ", i, host.router().meters().clampedSamples (i));

    return counted (all, "clamped sample") + (places.empty() ? "" : places + ")");
}

/** Nothing if no touch came in. */
std::string HeadlessRun::touchText()
{
    const auto outcome = host.touchOutcome();
    return outcome.empty() ? std::string() : "; " + outcome;
}

FociRun::FociRun (StandaloneHost& hostToPlay, std::vector<TimedNote> notes, double seconds, bool isArmed)
    : HeadlessRun (hostToPlay, seconds, isArmed), foci (hostToPlay)
{
    for (auto& note : notes)
        note.seconds += armTime;

    EventSchedule schedule (std::move (notes));

    if (auto numbers = schedule.noteNumbers(); ! numbers.empty())
        foci.processor().session().designFirst (std::move (numbers));

    foci.callback().setSchedule (std::move (schedule));
}

std::string FociRun::waitingFor() const
{
    return "solving the device and designing the foci; the notes start after that";
}

bool FociRun::isReady()
{
    auto& session = foci.processor().session();
    const auto now = session.snapshot();
    const auto progress = session.progress();

    for (const auto* const failure : { &now->error, &now->fingerError, &progress.liveError })
        if (! failure->empty())
            throw InputError ("", *failure);

    const auto isOtherDevice = now->device == nullptr || now->device->text != foci.processor().device()->text;
    return ! now->isSolving && ! isOtherDevice && progress.hasFirst;
}

std::string FociRun::designsText() const
{
    const auto progress = foci.processor().session().progress();
    return progress.isDone() ? std::string()
                             : "; " + std::to_string (progress.designed) + " of " + std::to_string (progress.wanted)
                                   + " positions are designed, the others follow";
}

void FociRun::begin()
{
    auto& session = foci.processor().session();

    if (const auto sentence = unplayableNotes (session.progress(), session.snapshot()->playback.sampleRate);
        ! sentence.empty())
        complain (sentence);

    foci.callback().startSchedule();
}

/** Times are those of the schedule. */
double FociRun::secondsPlayed (double rate) const
{
    return static_cast<double> (foci.callback().scheduleSamples()) / rate - armTime;
}

std::string FociRun::playedText()
{
    return counted (foci.processor().session().meters().triggered(), "trigger");
}

std::string TouchRun::waitingFor() const
{
    return "solving the device and designing the filters of the fingers; the inputs play after that";
}

bool TouchRun::isReady()
{
    const auto now = touch.processor().session().snapshot();

    for (const auto* const failure : { &now->error, &now->formatError, &touch.fingersError(), &now->designError })
        if (! failure->empty())
            throw InputError ("", *failure);

    const auto& settings = touch.processor().parameters().settings();
    const auto isDesigned = now->designs[settings.latency] != nullptr && now->playedFingers == settings;
    return touch.hasFingers() && now->model != nullptr && ! now->isSolving && isDesigned
           && now->device->text == touch.processor().device()->text;
}

std::string TouchRun::designsText() const
{
    const auto settings = touch.processor().parameters().settings();
    const auto count = [&] (FingerPresence presence)
    {
        return std::count_if (settings.fingers.begin(), settings.fingers.end(),
                              [presence] (const auto& finger) { return finger.presence == presence; });
    };
    return "; " + counted (count (FingerPresence::plays), "finger") + " from "
           + counted (std::ssize (openedAudio (touch.devices()).inputs), "input") + ", "
           + std::to_string (count (FingerPresence::silent)) + " silent, "
           + inWords (milli * touchLatencies[settings.latency]) + " ms of latency";
}

std::string TouchRun::playedText()
{
    auto& meters = touch.processor().session().fingerMeters();
    std::string text;

    for (int k = 0; k < mostFingers; ++k)
        if (const auto asked = static_cast<double> (meters.displacements.take (k)); asked > 0)
            text += (text.empty() ? "" : ", ") + ("finger " + std::to_string (k + 1)) + " asked for "
                    + fixedText (micro * asked, 2) + " um";

    return text.empty() ? "no finger was asked for anything" : text;
}
} // namespace antinode
