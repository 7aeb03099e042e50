#pragma once

#include "AudioHost.h"
#include "StandaloneHost.h"
#include "TouchHost.h"

#include <antinode_session/Following.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace antinode
{
/** What a program without windows says of a followed drift. */
class FollowingReport
{
public:
    /** What is new since the last call: another state, or a jump; else empty. [any] */
    std::string news (const FollowingStatus&);

    /** Prints what is new with its time. [message thread] */
    void print (const FollowingStatus&, double seconds);

    /** "drift +0.42 %, following", as of the last call; empty where nothing is followed. [any] */
    std::string summary() const;

    /** The same as the end of a line: "; drift +0.42 %, following". [any] */
    std::string ending() const;

private:
    FollowingState state = FollowingState::off;
    std::string reason;
    std::optional<double> drift; ///< None: no window was heard yet.
};

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
    virtual std::string waitingFor() const = 0;  ///< A line for the meantime.
    virtual std::string designsText() const = 0; ///< What else there is to say when it starts.
    virtual void begin() {}                      ///< When it starts.
    virtual FollowingRequests& followed() = 0;
    virtual double secondsPlayed (double rate) const; ///< The time of what following says.
    virtual std::string playedText() = 0;             ///< What was played, for the end.

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
    FollowingReport following;
    std::string failureText, ending; ///< When it ended.
};

/** Foci without windows: the notes of a schedule, once those are designed. */
class FociRun final : public HeadlessRun
{
public:
    /** As HeadlessRun. [message thread] */
    FociRun (StandaloneHost& hostToPlay, std::vector<TimedNote> notes, double seconds, bool isArmed);

private:
    bool isReady() override;
    std::string waitingFor() const override;
    std::string designsText() const override;
    void begin() override;
    FollowingRequests& followed() override { return foci.processor().session().following(); }
    double secondsPlayed (double rate) const override;
    std::string playedText() override;

    StandaloneHost& foci;
};

/** Antinode Touch without windows, from when its filters are designed. */
class TouchRun final : public HeadlessRun
{
public:
    /** As HeadlessRun. [message thread] */
    TouchRun (TouchHost& hostToPlay, double seconds, bool isArmed)
        : HeadlessRun (hostToPlay, seconds, isArmed), touch (hostToPlay)
    {
    }

private:
    bool isReady() override;
    std::string waitingFor() const override;
    std::string designsText() const override;
    FollowingRequests& followed() override { return touch.processor().session().following(); }
    std::string playedText() override;

    TouchHost& touch;
};
} // namespace antinode
