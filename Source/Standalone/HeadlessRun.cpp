#include "HeadlessRun.h"

#include <antinode_audio/Interruption.h>
#include <antinode_base/InputError.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace antinode
{
namespace
{
constexpr int tickMilliseconds = 10;
constexpr juce::uint32 devicePatience = 3000; // ms without a call
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
        beginWhenReady();

    if (isTimerRunning() && hasBegun)
        tick();

    const auto rate = host.callback().sampleRate(); // 0 where the device has gone
    const auto played = static_cast<double> (host.callback().samplesPlayed() - beginSamples);
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
    std::printf ("%s\n", startText().c_str());
    std::fflush (stdout);

    if (const auto warning = host.silentCeramics(); warning.isNotEmpty())
        complain (warning.toStdString());

    begin();
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
    auto& outputs = host.router().meters();
    std::int64_t clamped = 0;

    for (int i = 0; i < OutputRouting::maximumOutputs; ++i)
        clamped += outputs.clampedSamples (i);

    char volts[32];
    std::snprintf (volts, sizeof volts, "%.1f", static_cast<double> (host.takePeakVolts()));
    return "ended: " + playedText() + ", at most " + volts + " V, " + counted (clamped, "clamped sample") + ", "
           + counted (outputs.badNumbers(), "block") + " with invalid samples, " + counted (xruns, "xrun")
           + outcomeText() + touchText();
}

/** Nothing if no touch came in. */
std::string HeadlessRun::touchText()
{
    const auto outcome = host.touchOutcome();
    return outcome.empty() ? std::string() : "; of " + counted (host.touchPackets(), "touch packet") + ": " + outcome;
}
} // namespace antinode
