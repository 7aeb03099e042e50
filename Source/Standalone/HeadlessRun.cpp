#include "HeadlessRun.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>
#include <antinode_session/DesignSentences.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace antinode
{
namespace
{
constexpr int tickMilliseconds = 10;
constexpr juce::uint32 devicePatience = 3000; // ms without a call
constexpr double armTime = 0.05;              // s, for the ramp of arming to end before the first note

std::string counted (std::int64_t count, const std::string& what)
{
    return std::to_string (count) + " " + what + (count == 1 ? "" : "s");
}

void complain (const std::string& sentence)
{
    std::fprintf (stderr, "antinode-standalone: %s\n", sentence.c_str());
}
} // namespace

HeadlessRun::HeadlessRun (StandaloneHost& hostToPlay, std::vector<TimedNote> notes, double seconds, bool isArmed)
    : host (hostToPlay), duration (seconds), arms (isArmed)
{
    for (auto& note : notes)
        note.seconds += armTime;

    EventSchedule schedule (std::move (notes));

    if (auto numbers = schedule.noteNumbers(); ! numbers.empty())
        host.processor().session().designFirst (std::move (numbers));

    host.callback().setSchedule (std::move (schedule));
}

void HeadlessRun::run()
{
    std::printf ("solving the device and designing the foci; the notes start after that\n");
    std::fflush (stdout);
    seenAt = juce::Time::getMillisecondCounter();
    startTimer (tickMilliseconds);
    juce::MessageManager::getInstance()->runDispatchLoop();

    if (! failureText.empty())
        throw InputError ("", failureText);

    std::printf ("%s\n", endText().c_str());
}

void HeadlessRun::end (const std::string& failure)
{
    failureText = failure;
    stopTimer();
    xruns = std::max (0, host.devices().getXRunCount());
    host.shutDown();
    juce::MessageManager::getInstance()->stopDispatchLoop();
}

void HeadlessRun::timerCallback()
{
    checkDevice();

    if (isTimerRunning() && ! hasBegun)
        beginWhenDesigned();

    const auto rate = host.callback().sampleRate(); // 0 where the device has gone
    const auto played = static_cast<double> (host.callback().scheduleSamples());
    const auto isOver = hasBegun && duration > 0 && rate > 0 && played >= (armTime + duration) * rate;

    if (isTimerRunning() && (isOver || isInterrupted()))
        end ({});
}

void HeadlessRun::checkDevice()
{
    const auto now = juce::Time::getMillisecondCounter();

    if (const auto samples = host.callback().samplesPlayed(); samples != seenSamples)
    {
        seenSamples = samples;
        seenAt = now;
    }

    if (now - seenAt > devicePatience)
        end ("the audio device has stopped");
}

void HeadlessRun::beginWhenDesigned()
{
    auto& session = host.processor().session();
    const auto now = session.snapshot();
    const auto progress = session.progress();

    if (! now->deviceError.empty())
        return end (now->deviceError);

    if (! progress.liveError.empty())
        return end (progress.liveError);

    const auto isOtherDevice = now->device == nullptr || now->device->text != host.processor().device()->text;

    if (now->isSolving || isOtherDevice || ! progress.hasFirst)
        return;

    if (arms)
        host.processor().parameters().arm().setValueNotifyingHost (1);

    hasBegun = true;
    std::printf ("%s\n", startText().c_str());
    std::fflush (stdout);

    if (const auto warning = host.silentCeramics(); warning.isNotEmpty())
        complain (warning.toStdString());

    if (const auto sentence = unplayableNotes (progress, now->playback.sampleRate); ! sentence.empty())
        complain (sentence);

    host.callback().startSchedule();
}

std::string HeadlessRun::startText() const
{
    const auto audio = openedAudio (host.devices());
    const auto model = host.processor().session().snapshot()->model;
    const auto progress = host.processor().session().progress();
    const auto designs = progress.isDone()
                             ? std::string()
                             : "; " + std::to_string (progress.designed) + " of " + std::to_string (progress.wanted)
                                   + " positions are designed, the others follow";
    return "playing on " + audio.type + " device '" + audio.device
           + "': " + std::to_string (std::lround (audio.sampleRate)) + " Hz, " + counted (audio.blockSize, "sample")
           + " per block, " + counted (std::ssize (audio.outputs), "output") + "; '" + model->name + "' with "
           + counted (model->actuators(), "ceramic") + ", "
           + (arms ? "armed" : "disarmed: use --arm to drive the outputs") + designs;
}

std::string HeadlessRun::endText() const
{
    auto& meters = host.processor().session().meters();
    auto& outputs = host.router().meters();
    std::int64_t clamped = 0;
    float peak = 0;

    for (int i = 0; i < OutputRouting::maximumOutputs; ++i)
        clamped += outputs.clampedSamples (i);

    for (int i = 0; i < LevelMeters::ceramics; ++i)
        peak = std::max (peak, meters.takePeak (i));

    char volts[32];
    std::snprintf (volts, sizeof volts, "%.1f", static_cast<double> (peak));
    return "ended: " + counted (meters.triggered(), "trigger") + ", at most " + volts + " V, "
           + counted (clamped, "clamped sample") + ", " + counted (outputs.badNumbers(), "block")
           + " with invalid samples, " + counted (xruns, "xrun") + touchText();
}

/** Nothing if no touch came in. */
std::string HeadlessRun::touchText() const
{
    const auto counters = host.touch().counters();
    const auto unplayed = host.touch().unplayed();
    const auto dropped = counters.limited + unplayed.notAccepted + unplayed.withoutKind
                         + std::accumulate (counters.faults.begin(), counters.faults.end(), std::int64_t());

    if (counters.packets == 0)
        return {};

    return "; of " + counted (counters.packets, "touch packet") + ": " + std::to_string (unplayed.outsideSurface)
           + " outside the surface, " + std::to_string (dropped) + " dropped for other reasons";
}
} // namespace antinode
