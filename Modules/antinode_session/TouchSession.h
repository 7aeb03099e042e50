#pragma once

#include "Documents.h"
#include "FollowingRequests.h"
#include "SessionOwner.h"
#include "StopCount.h"
#include "TouchDesigner.h"
#include "TouchFoci.h"
#include "TouchPath.h"

#include <antinode_base/BackgroundThread.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** What a touch session plays just now, for those who look on. Never changed once it is given. */
struct TouchSnapshot
{
    std::shared_ptr<const DeviceDocument> device; ///< What was asked for, also while it is being solved.
    std::shared_ptr<const ModalModel> model;      ///< None before the first device is solved.
    bool isSolving = false;
    std::string error; ///< Why the device that was asked for cannot be played: then the one before plays on.

    std::string formatError; ///< Why nothing can play at the host's rate.

    bool isDesigning = false;    ///< Whether filters for the present places are being designed.
    double progress = 0;         ///< Of them, 0 to 1.
    std::string designError;     ///< Why there are none: then those before play on.
    TouchSettings playedFingers; ///< Where the fingers were when the filters that play were designed.
    std::array<std::shared_ptr<const TouchDesign>, touchLatencies.size()>
        designs; ///< Of the present places, by latency; none: not made yet.
};

class TouchWorker;

/** A device as an effect on the inputs of fingers: solves it, designs filters and lets inputs play through them. As
   with Session, a thread of its own looks at the parameters every few milliseconds, solves, builds and designs; paths
   and filters go to the audio thread by one atomic exchange each; and nothing here waits longer than a moment for that
    thread, which may end after the session. */
class TouchSession
{
public:
    using ReadSettings = std::function<TouchSettings()>;

    /** Starts solving.
        @param readSettings  gives what the parameters say; called on the session's thread, must not block
        @param onChange      called on the session's thread after the snapshot has changed
        [worker] starts a thread */
    TouchSession (DeviceDocument, ReadSettings readSettings, std::function<void()> onChange);
    ~TouchSession();
    TouchSession (const TouchSession&) = delete;
    TouchSession& operator= (const TouchSession&) = delete;

    /** Another device. Returns at once; the present one plays on until the other is solved. [any but the audio thread]
     */
    void load (std::shared_ptr<const DeviceDocument>);

    /** Forgets what has come in, and asks for the path of a sample rate. Waits for it, but only a moment. Nothing may
       be processing. @param inputs  1 to mostFingers [worker] */
    void prepare (double sampleRate, int inputs);

    /** Plays a block, or silence where there is no path yet. [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const TouchBlock<Sample>&, const TouchControls&);

    /** Fades the foci of notes out with the next block, and voids those that wait for their time. Inputs play on.
        [any] */
    void stopAll();

    /** The stops so far: by stopAll() and by prepare(). [any] */
    StopCount& stops() const;

    /** Waits until all that was loaded is taken up, and filters are designed for what the parameters say, and the focus
        at its own place and at those of these notes. One caller at a time. [any but a real-time audio thread] */
    void waitUntilSettled (std::span<const FocusEvent> notes = {});

    /** What notes play on top of the tracks, TouchFoci; none: nothing. Returns at once. [any but the audio thread] */
    void loadFocus (std::shared_ptr<const FocusDocument>);
    std::shared_ptr<const FocusDocument> focus() const;

    /** Of the foci's designs. [any but the audio thread] */
    DesignProgress focusProgress() const;

    /** What foci know of the fingers. [any but the audio thread] */
    FociUnderFingers fociUnderFingers() const;

    /** Whether somebody wants to know the volts of all latencies: then designs are made for them too, when there is
        nothing else to do. [any] */
    void setComparing (bool shouldCompare);

    /** What amplifiers limit, as withAmplifiers has it; a change of a limit ramps to 0 V and back. [any but the audio
        thread] */
    void setAmplifiers (std::vector<double> volts);

    /** What follows the drift of the device, and what is known: another sensor makes another path, and filters and foci
        are designed for the device as it is. Docs/Decisions/0158-following-in-touch.md [any but the audio thread] */
    FollowingRequests& following() const;

    /** [any but the audio thread] */
    std::shared_ptr<const TouchSnapshot> snapshot() const;

    /** The voltage of a sample of 1.0 in the last block, V; 0 before the first one that plays. [any] */
    double fullScaleVolts() const;

    LevelMeters& meters();
    FingerMeters& fingerMeters();

    /** By how many samples motions lag their inputs; that of 48 kHz before the first preparation. [any] */
    std::int64_t latencySamples (std::size_t latency) const;

    /** Of what is heard after an input or a note: the filter's length or the focus with its brake, whichever ends
       later, and 60 dB of the slowest mode's decay, s. [any but the audio thread] */
    double tailSeconds (std::size_t latency) const;

private:
    std::shared_ptr<SessionOwner<TouchSettings>> owner;
    std::shared_ptr<TouchWorker> worker;
    BackgroundThread thread;
};
} // namespace antinode
