#pragma once

#include "StandaloneHost.h"

#include <string>

namespace antinode
{
/** Plays without windows until its duration is over, the user interrupts it, or the device fails. */
class HeadlessRun : private juce::Timer
{
public:
    /** @param hostToPlay  with its device open; outlives this
        @param seconds     how long, from the start of the schedule on; 0: without end
        [message thread] */
    HeadlessRun (StandaloneHost& hostToPlay, std::vector<TimedNote> notes, double seconds, bool isArmed);

    /** Waits for the designs of the schedule's notes, plays, prints what it does in one line at the start and one at
       the end.
        @throws InputError  where the device or its focus cannot be played, or the audio device fails
        [message thread] runs the message loop */
    void run();

private:
    void timerCallback() override;
    void beginWhenDesigned();
    void checkDevice();
    void end (const std::string& failure);
    std::string startText() const;
    std::string endText() const;
    std::string touchText() const;

    StandaloneHost& host;
    double duration;
    bool arms, hasBegun = false;
    std::int64_t seenSamples = 0;
    juce::uint32 seenAt = 0; ///< ms, when the device called last.
    std::string failureText;
    int xruns = 0; ///< When it ended.
};
} // namespace antinode
