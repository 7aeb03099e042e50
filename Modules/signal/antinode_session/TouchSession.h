#pragma once

#include "FilterDesigner.h"
#include "InstrumentSession.h"
#include "NoteFoci.h"

#include <antinode_fingers/Sensation.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
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
    std::array<std::shared_ptr<const FilterDesign>, touchLatencies.size()>
        designs; ///< Of the present places, by latency; none: not made yet.
};

/** What the host plays: a path is for one of these. */
struct TouchFormat
{
    double sampleRate = 0; ///< Hz; 0 before the first preparation.
    int inputs = 0;        ///< 1 to mostFingers.

    bool operator== (const TouchFormat&) const = default;
};

/** A device as an effect on the inputs of fingers: solves it, designs filters and lets inputs play through them. A
   thread of its own looks at the parameters every few milliseconds, solves, builds and designs; paths and filters go to
   the audio thread by one atomic exchange each; and nothing here waits longer than a moment for that thread.
   SessionThread makes it, for it lasts as long as its thread. */
class TouchSession : public InstrumentSession<TouchSnapshot, TouchSettings, TouchFormat>
{
public:
    /** Starts with solving. @param readSettings, onChange  as DeviceRounds [worker] */
    TouchSession (DeviceDocument, std::function<TouchSettings()> readSettings, std::function<void()> onChange);

    /** Forgets what has come in, and asks for the path of a sample rate. Waits for it, but only a moment. Nothing may
       be processing. [worker] */
    void prepare (const TouchFormat&);

    /** What notes play on top of the tracks, NoteFoci; none: nothing. Returns at once. [any but the audio thread] */
    void loadFocus (std::shared_ptr<const FocusDocument> focus) { foci.load (std::move (focus)); }
    std::shared_ptr<const FocusDocument> focus() const { return foci.focus(); }

    /** Of the foci's designs. [any but the audio thread] */
    DesignProgress focusProgress() const { return foci.progress(); }

    /** What foci know of the fingers. [any but the audio thread] */
    FociUnderFingers fociUnderFingers() const { return foci.underFingers(); }

    /** Whether somebody wants to know the volts of all latencies: then designs are made for them too, when there is
        nothing else to do. [any] */
    void setComparing (bool shouldCompare) { isComparing = shouldCompare; }

    FingerMeters& fingerMeters() { return played.fingers; }

    /** By how many samples motions lag their inputs; that of 48 kHz before the first preparation. [any] */
    std::int64_t latencySamples (std::size_t latency) const;

    /** Of what is heard after an input or a note: the filter's length or the focus with its brake, whichever ends
       later, and 60 dB of the slowest mode's decay, s. [any but the audio thread] */
    double tailSeconds (std::size_t latency) const;

private:
    void work() override;
    void rest() override { compare(); }
    ModalModel solvedModel (const DeviceDescription&) const override;
    TouchSettings look();
    void step();
    void serveFoci();
    void takeFollowing();
    void takeDrift();
    void buildPath();
    void makeDesigner();
    bool isSettled() const;
    void design();
    bool playQuickly();
    bool areFingersResting();
    bool isAwaited() const;
    void makeDesign();
    void play (std::unique_ptr<const FilterBank>, const TouchSettings& places);
    void compare();
    bool hasOtherPath();
    bool hasNews();

    std::atomic<bool> isComparing { false };
    std::shared_ptr<const DeviceDocument> playedDevice; ///< The model's: what was asked for may have no model. Of the
                                                        ///< session's thread, as the next lines.
    std::optional<TouchSettings> designedFor; ///< Also where that failed: nobody shall try it again and again.
    TouchFormat format;
    SkinThreshold threshold;
    std::unique_ptr<FilterDesigner> designer;
    bool isRetuned = false; ///< Whether it is for a device that has drifted since the filters that play were made.
    FingerMovement movement;
    FingerMovement::Clock::duration quickTime = std::chrono::milliseconds (10); ///< That quick filters last took.
    NoteFoci foci;
    bool isPathNew = false;               ///< Whether no focus was asked for it yet.
    std::atomic<std::int64_t> late { 0 }; ///< Samples by which outputs come later where lags of ceramics are undone.
};
} // namespace antinode
