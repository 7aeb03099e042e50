#pragma once

#include "AudioPath.h"
#include "PathExchange.h"
#include "SessionSnapshot.h"
#include "TriggerQueue.h"

#include <array>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

namespace antinode
{
/** Everything between the front ends and the kernels: turns a device, a focus and parameters into an audio path. The plug-in
    and the standalone program each have one; neither solves, designs or swaps anything by itself.

    A thread of its own looks at the parameters every few milliseconds, so that whoever changes them (a host does it on the audio
    thread) makes no callbacks. Solving a device and building a path happen there, designing on the path's worker. A new path is handed
    over by one atomic exchange after the old one has ramped to 0 V, and the old one is freed here. Docs/Architecture.md, Session. */
class Session
{
public:
    /** Middle C plays the focus at its own position, whatever the other notes play. */
    static constexpr int spotNote = 60;

    using ReadSettings = std::function<PlaySettings()>;

    /** Starts solving the device.
        @param readSettings  gives what the parameters say; called on the session's thread, must not block
        @param onChange      called on the session's thread after latency, tail or a snapshot have changed
        [worker] starts threads */
    Session (DeviceDocument, FocusDocument, ReadSettings readSettings, std::function<void()> onChange);
    ~Session();
    Session (const Session&) = delete;
    Session& operator= (const Session&) = delete;

    /** Another device, focus, or both (none: the present one stays). Returns at once; what plays ramps out when the new path is
        ready. [any but the audio thread] */
    void load (std::shared_ptr<const DeviceDocument>, std::shared_ptr<const FocusDocument>);

    /** Brings what plays to rest, and asks for the path of a sample rate. Waits until it is there and its focus designed, but only a
        moment: where a large device is being solved there is silence until it is. Nothing may be processing. [worker]
        @param isOffline  waits until all is designed */
    void prepare (double sampleRate, bool isOffline);

    /** Plays a block, or silence while there is no path. [audio thread] allocates nothing, locks nothing
        @param events  what came with the block; a note's place is its number */
    template <typename Sample>
    void process (const OutputBlock<Sample>&, std::span<const FocusEvent> events, const PlayControls&);

    /** Waits until all that was loaded is taken up, with what the parameters say, and the foci are designed that these events
        trigger: for offline rendering. One caller at a time. [any but a real-time audio thread] */
    void waitUntilSettled (std::span<const FocusEvent> events = {});

    /** Plays by separate nodes (openGraph), or by the fused ones, which are the same samples at less cost. What plays ramps out when
        the other path is ready. [any] */
    void setGraphOpen (bool shouldBeOpen) { wantsOpenGraph = shouldBeOpen; }
    bool isGraphOpen() const { return wantsOpenGraph; }

    /** What stands between the nodes of the open graph from the next path on, which is made at once.
        @param insert  called on the session's thread for every path; none: nothing is inserted [any but the audio thread] */
    void insertNodes (InsertNodes insert);

    /** Designs the places of these notes before those of the others, in this order; by default that of middle C.
        [any but the audio thread] */
    void designFirst (std::vector<int> notes);

    /** Fires the focus at its own position with the next block. @param amplitude  0 to 1 [any but the audio thread] */
    void fire (double amplitude);

    /** The outcome of firing a focus at another position. */
    enum class TouchResult
    {
        taken,
        besideSurface,
        notTaken ///< No device is solved yet, or too many wait.
    };

    /** Designs and fires a focus at another position. @param x, y  m [any but the audio thread] */
    TouchResult fireAt (double x, double y, double amplitude);

    /** Fades all voices out with the next block. [any] */
    void stopAll();

    /** [any but the audio thread] */
    std::shared_ptr<const SessionSnapshot> snapshot() const;

    /** The progress of the designs. [any but the audio thread] */
    DesignProgress progress() const;

    LevelMeters& meters() { return levels; }
    const ProbeTrace& probeTrace() const { return trace; }

    /** Samples from a trigger to its focus if foci are delayed onto notes, else 0. [any] */
    std::int64_t latencySamples() const { return latency; }

    /** The voltage of a sample of 1.0 in the last block, V; 0 before the first block. [any] */
    double fullScaleVolts() const { return fullScale; }

    /** The tail after the last trigger: the focus, and 60 dB of decay of the slowest mode. s [any] */
    double tailSeconds() const { return tail; }

private:
    void run();
    void step();
    void takeDocuments();
    void solve (const DeviceDocument&);
    void buildPath (double sampleRate);
    bool takeGraphChoice();
    void requestDesigns();
    void forwardTouches();
    void publish();
    std::vector<std::pair<double, double>> notePlaces() const;
    Eigen::MatrixXd probeShapes() const;
    std::vector<int> wantedFirst() const;
    double wantedSampleRate() const;
    int placeOf (const FocusEvent&) const;
    std::span<const FocusEvent> gather (std::span<const FocusEvent> events);

    struct Touch
    {
        double x = 0, y = 0, amplitude = 1;
    };

    ReadSettings readSettings;
    std::function<void()> onChange;

    mutable std::mutex mutex; ///< For the next lines.
    std::condition_variable wake, settled;
    std::shared_ptr<const DeviceDocument> nextDevice;
    std::shared_ptr<const FocusDocument> nextFocus;
    std::vector<Touch> touches;
    double wantedRate = 0;                                          ///< Hz; 0 before the first prepare.
    std::uint64_t roundsAsked = 0, settleAsked = 0, roundsDone = 0; ///< Rounds of the thread that others wait for.
    DesignProgress designs;
    std::vector<int> settlePlaces; ///< Of the bank: what is waited for.
    std::vector<int> firstNotes { spotNote };
    bool isStopping = false, isSolving = false, isFirstNew = false, isInsertionNew = false;
    InsertNodes insertion;
    std::shared_ptr<const SessionSnapshot> published;

    std::shared_ptr<const DeviceDocument> device; ///< Of the session's thread, as the next lines.
    std::shared_ptr<const FocusDocument> focus;
    std::shared_ptr<const ModalModel> model;
    PlaySettings settings;
    double rate = 0;
    AudioPath* path = nullptr; ///< The newest one, which `paths` owns.
    GraphChoice graph;
    bool isModelNew = false, isFocusNew = false;
    std::string deviceError;

    std::atomic<bool> wantsOpenGraph { false };
    std::atomic<bool> isStopAsked { false };
    TriggerQueue triggers; ///< Workers of paths push to it: so it outlives them.
    PathExchange<AudioPath> paths;
    std::array<FocusEvent, 1024> blockEvents {}; ///< Of the audio thread.
    LevelMeters levels;
    ProbeTrace trace;
    std::atomic<double> preparedRate { 0 };
    std::atomic<bool> playsSpotOnly { false }; ///< Whether every note plays the focus at its own place.
    std::atomic<std::int64_t> latency { 0 };
    std::atomic<double> tail { 1 }, fullScale { 0 };
    std::thread thread;
};
} // namespace antinode
