#pragma once

#include "AudioEntry.h"
#include "FollowingRequests.h"
#include "NoteBank.h"
#include "SessionOwner.h"
#include "SessionRequests.h"

#include <antinode_base/BackgroundThread.h>

#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace antinode
{
/** Everything between the front ends and the kernels: turns a device, a focus and parameters into an audio path. The
   plug-in and the standalone program each have one; neither solves, designs or swaps anything by itself.

    It is three things: requests and answers under a lock (SessionRequests), the work of a thread of its own
   (SessionWorker), and what the audio thread enters (AudioEntry). The thread looks at the parameters every few
   milliseconds, so that whoever changes them (a host does it on the audio thread) makes no callbacks. Solving a device
   and building a path happen there, designing on the path's worker. A new path is handed over by one atomic exchange
   after the old one has ramped to 0 V, and the old one is freed there. Nothing here waits for that work longer than a
   moment, the destructor neither: then the thread ends later. Docs/Architecture.md, Session. */
class Session
{
public:
    /** Middle C plays the focus at its own position, whatever the other notes play. */
    static constexpr int spotNote = antinode::spotNote;

    using ReadSettings = std::function<PlaySettings()>;

    /** Starts solving the device.
        @param readSettings  gives what the parameters say; called on the session's thread, must not block
        @param onChange      called on the session's thread after latency, tail or a snapshot have changed
        @param takeFocus     takes over the focus that was chosen for a device that came without one, on the session's
       thread; none: the present focus stays
        [worker] starts threads */
    Session (DeviceDocument, FocusDocument, ReadSettings readSettings, std::function<void()> onChange,
             TakeFocus takeFocus = {});
    ~Session();
    Session (const Session&) = delete;
    Session& operator= (const Session&) = delete;

    /** Another device, focus, or both (none: the present device stays; a device alone gets a focus that suits it).
       Returns at once; what plays ramps out when the new path is ready. [any but the audio thread] */
    void load (std::shared_ptr<const DeviceDocument>, std::shared_ptr<const FocusDocument>);

    /** Brings what plays to rest, and asks for the path of a sample rate. Waits until it is there and its focus
       designed, but only a moment: where a large device is being solved there is silence until it is. Nothing may be
       processing. [worker] */
    void prepare (double sampleRate);

    /** Plays a block, or silence while there is no path. [audio thread] allocates nothing, locks nothing */
    template <typename Sample>
    void process (const AudioBlock<Sample>& block, const PlayControls& controls)
    {
        entry->process (block, controls);
    }

    /** Waits until all that was loaded is taken up, with what the parameters say, and the focus at its own place is
       designed, and those that these events trigger: for offline rendering. One caller at a time. [any but a real-time
       audio thread] */
    void waitUntilSettled (std::span<const FocusEvent> events = {});

    /** Plays by separate nodes (openGraph), or by the fused ones, which are the same samples at less cost. What plays
       ramps out when the other path is ready. [any] */
    void setGraphOpen (bool shouldBeOpen) { requests->setGraphOpen (shouldBeOpen); }
    bool isGraphOpen() const { return requests->isGraphOpen(); }

    /** What stands between the nodes of the open graph from the next path on, which is made at once.
        @param insert  called on the session's thread for every path; none: nothing is inserted [any but the audio
       thread] */
    void insertNodes (InsertNodes insert);

    /** What the outputs behind the ceramics give, if they differ from the device's full scale: a limit of all foci.
        @param volts  of a full-scale sample, for each ceramic; 0 or missing: the device's full scale
        [any but the audio thread] */
    void setAmplifiers (std::vector<double> volts) { requests->setAmplifiers (std::move (volts)); }

    /** What follows the drift of the device, and what is known: foci are designed for the device as it is. Another
       sensor makes another path; one that cannot be had becomes a status. [any but the audio thread] */
    FollowingRequests& following() const { return *followingRequests; }

    /** Designs the places of these notes before those of the others, in this order; by default that of middle C.
        [any but the audio thread] */
    void designFirst (std::vector<int> notes);

    /** Fires the focus at its own position with the next block. @param amplitude  0 to 1 [any but the audio thread] */
    void fire (double amplitude);

    /** The outcome of firing a focus at another position. */
    enum class TouchResult
    {
        taken,
        outsideSurface,
        notAccepted ///< No device is solved yet, or too many wait.
    };

    /** Designs and fires a focus at another position. @param x, y  m [any but the audio thread] */
    TouchResult fireAt (double x, double y, double amplitude);

    /** Fades all voices out with the next block, and voids what was asked for before and waits: touches, their designs,
        triggers. [any] */
    void stopAll();

    /** The stops so far: by stopAll(), by prepare(), by all notes off among the events of a block. [any] */
    StopCount& stops() { return entry->stops(); }

    /** [any but the audio thread] */
    std::shared_ptr<const SessionSnapshot> snapshot() const;

    /** The progress of the designs. [any but the audio thread] */
    DesignProgress progress() const;

    LevelMeters& meters() { return entry->meters(); }
    const ProbeTrace& probeTrace() const { return entry->probeTrace(); }

    /** Samples from a trigger to its focus if foci are delayed onto notes, else 0. [any] */
    std::int64_t latencySamples() const { return requests->latencySamples(); }

    /** The voltage of a sample of 1.0 in the last block, V; 0 before the first block. [any] */
    double fullScaleVolts() const { return entry->fullScaleVolts(); }

    /** The tail after the last trigger, as the parameters are now: the focus with its brake, lags, and 60 dB of decay
       of the slowest mode. s [any but the audio thread] */
    double tailSeconds() const;

private:
    std::shared_ptr<SessionOwner<PlaySettings>> owner;
    std::shared_ptr<SessionRequests> requests;
    std::shared_ptr<FollowingRequests> followingRequests = std::make_shared<FollowingRequests>();
    std::shared_ptr<AudioEntry> entry;
    BackgroundThread thread;
};
} // namespace antinode
