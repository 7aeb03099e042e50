#pragma once

#include "AudioHost.h"

#include <cstdint>
#include <string>

namespace antinode
{
/** Plays without windows until its duration is over, the user interrupts it, or the device fails. */
class HeadlessRun : private juce::Timer
{
public:
    ~HeadlessRun() override = default;

    /** Waits until what is to play is designed, plays, prints what it does in one line at the start and one at the end.
        @throws InputError  where the device or its focus cannot be played, or the audio device fails
        [message thread] runs the message loop */
    void run();

protected:
    static constexpr double armTime = 0.05; ///< s, for the ramp of arming to end before the first note

    /** @param hostToPlay  with its device open; outlives this
        @param seconds     how long, from the start on; 0: without end
        [message thread] */
    HeadlessRun (AudioHost& hostToPlay, double seconds, bool isArmed);

    /** "1 sample", "2 samples". [any] */
    static std::string counted (std::int64_t count, const std::string& what);

    /** A line on standard error. [any] */
    static void complain (const std::string& sentence);

private:
    /** Whether all is designed. @throws InputError  why nothing can play */
    virtual bool isReady() = 0;
    virtual std::string waitingFor() const = 0;      ///< A line for the meantime.
    virtual std::string designsText() const = 0;     ///< What else there is to say when it starts.
    virtual void begin() {}                          ///< When it starts.
    virtual void tick() {}                           ///< Again and again while it plays.
    virtual std::string playedText() = 0;            ///< What was played, for the end.
    virtual std::string outcomeText() { return {}; } ///< What else there is to say when it ends.

    void timerCallback() override;
    void beginWhenReady();
    void end (const std::string& failure);
    std::string startText() const;
    std::string endText();
    std::string clampedText();
    std::string touchText();

    AudioHost& host;
    double duration;
    bool arms, hasBegun = false;
    std::int64_t beginSamples = 0;
    std::string failureText, ending; ///< When it ended.
};
} // namespace antinode
