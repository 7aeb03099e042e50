#include "TouchRun.h"

#include <antinode_base/InputError.h>
#include <antinode_base/NumberText.h>
#include <antinode_base/Prefixes.h>

#include <algorithm>
#include <cmath>

namespace antinode
{
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

void TouchRun::tick()
{
    if (const auto rate = touch.callback().sampleRate(); rate > 0)
        following.print (*touch.processor().session().following().status(),
                         static_cast<double> (touch.callback().samplesPlayed() - begun) / rate);
}

std::string TouchRun::outcomeText()
{
    return following.ending();
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
