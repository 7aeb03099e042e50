#pragma once

#include "DesignRequest.h"
#include "Documents.h"
#include "FocusSettings.h"
#include "InstrumentSession.h"

#include <antinode_fingers/Finger.h>
#include <antinode_model/ModalModel.h>

#include <array>
#include <atomic>
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
/** What a session plays at the moment, for displays. Immutable. */
struct SessionSnapshot
{
    std::uint64_t generation = 0;                 ///< Grows with every snapshot.
    std::shared_ptr<const DeviceDocument> device; ///< The requested device, also while it is being solved.
    std::shared_ptr<const FocusDocument> focusDocument;
    std::shared_ptr<const ModalModel> model; ///< None before the first device is solved.
    PlaySettings settings;                   ///< The settings of the focus below.
    FocusDescription focus;                  ///< As it is designed: the document as the parameters changed it.
    std::vector<std::pair<double, double>> notePlaces; ///< x, y in m of the notes 0 to 127; empty if all play the spot.
    Playback playback;
    bool isAsWritten = false; ///< Whether the focus plays a design that was written before.
    bool isSolving = false;   ///< Whether a device is being solved.
    std::string error;        ///< Why the requested device cannot be played: then the previous one continues.
    std::string fingerError;  ///< Why fingers are left out.
};

/** Takes over a focus in place of another one. @return  false where that one is not the present one any more */
using TakeFocus = std::function<bool (const std::shared_ptr<const FocusDocument>& chosen, const FocusDocument& before)>;

/** Foci of a device: solves it, designs them and lets notes and touches play them. A thread of its own looks at the
    parameters every few milliseconds, so that whoever changes them (a host does it on the audio thread) makes no
    callbacks. Solving a device and building a path happen there, designing on the path's worker. A new path is handed
    over by one atomic exchange after the old one has ramped to 0 V, and the old one is freed there. Nothing here waits
   for that work longer than a moment. SessionThread makes it, for it lasts as long as its thread. Docs/Architecture.md,
    Session. */
class Session : public InstrumentSession<SessionSnapshot, PlaySettings, double>
{
public:
    /** Middle C plays the focus at its own position, whatever the other notes play. */
    static constexpr int spotNote = antinode::spotNote;
    static constexpr int probes = 2; ///< Of the monitor.

    /** Starts with solving.
        @param readSettings, onChange  as DeviceRounds
        @param takeFocus  takes over the focus that was chosen for a device that came without one, on the session's
                          thread; none: the present focus stays
        [worker] */
    Session (DeviceDocument, FocusDocument, std::function<PlaySettings()> readSettings, std::function<void()> onChange,
             TakeFocus takeFocus = {});

    /** Another device, focus, or both (none: the present device stays; a device alone gets a focus that suits it).
       Returns at once; what plays ramps out when the new path is ready. [any but the audio thread] */
    void load (std::shared_ptr<const DeviceDocument>, std::shared_ptr<const FocusDocument>);

    /** Brings what plays to rest, and asks for the path of a sample rate. Waits until it is there and its focus
       designed, but only a moment: where a large device is being solved there is silence until it is. Nothing may be
       processing. [worker] */
    void prepare (double sampleRate);

    /** Plays by separate nodes, or by the fused ones, which are the same samples at less cost. What plays
       ramps out when the other path is ready. [any] */
    void setGraphOpen (bool shouldBeOpen) { wantsOpenGraph = shouldBeOpen; }
    bool isGraphOpen() const { return wantsOpenGraph; }

    /** What stands between the nodes of the open graph from the next path on, which is made at once.
        @param insert  called on the session's thread for every path; none: nothing is inserted [any but the audio
       thread] */
    void insertNodes (InsertNodes insert);

    /** Designs the places of these notes before those of the others, in this order; by default that of middle C.
        [any but the audio thread] */
    void designFirst (std::vector<int> notes);

    /** Fires the focus at its own position with the next block. @param amplitude  0 to 1 [any but the audio thread] */
    void fire (double amplitude);

    /** The outcome of firing a focus at another position. */
    enum class FireResult
    {
        taken,
        outsideSurface,
        notAccepted ///< No device is solved yet, or too many wait.
    };

    /** Designs and fires a focus at another position. @param x, y  m [any but the audio thread] */
    FireResult fireAt (double x, double y, double amplitude);

    /** The progress of the designs. [any but the audio thread] */
    DesignProgress progress() const;

    const ProbeTrace& probeTrace() { return played.trace; }

    /** Samples from a trigger to its focus if foci are delayed onto notes, else 0. [any] */
    std::int64_t latencySamples() const { return latency; }

    /** The tail after the last trigger, as the parameters are now: the focus with its brake, lags, and 60 dB of decay
       of the slowest mode. s [any but the audio thread] */
    double tailSeconds();

private:
    /** A focus that is to be fired at another position: m, and its amplitude from 0 to 1. */
    struct FiredFocus
    {
        double x = 0, y = 0, amplitude = 1;
        std::uint64_t askedAt = 0; ///< StopCount::now() then.
    };

    /** What a round is asked for, beside a device, a format and amplifiers. */
    struct Requests
    {
        bool hasDevice = false;
        std::shared_ptr<const FocusDocument> focus; ///< None: the present one stays.
        bool choosesFocus = false;                  ///< Whether the device came without a focus.
        InsertNodes insert;                         ///< Of the open graph.
        bool isInsertionNew = false, isOrderNew = false;
        std::vector<int> firstNotes { spotNote }; ///< Are designed before the others.
        std::vector<FiredFocus> fired;
    };

    bool isMoreAsked() const override { return asked.focus != nullptr || ! asked.fired.empty(); }
    bool isPlayable() const override { return designs.designed > 0 || designs.wanted == 0; }
    void endSolving() override { setProgress ({}); } // It belongs to the device before.
    void describe() override;
    std::shared_ptr<const FocusDocument> newestFocus() const;
    // What follows is of the session's thread.

    void work() override;
    void rest() override { tellOfEnd (progress().endSeconds); }
    Requests take();
    void step (const Requests&);
    void takeDocuments (const Requests&);
    void chooseFocus();
    void takeFingers();
    void takeGraphChoice (const Requests&);
    void buildPath();
    bool hasDrifted() const;
    void requestDesigns (const std::vector<int>& firstNotes);
    std::function<WideModel()> widen() const;
    void designFired (const std::vector<FiredFocus>&);
    void setProgress (const DesignProgress&);
    std::shared_ptr<const DesignDocument> written() const;
    std::vector<std::pair<double, double>> notePlaces() const;
    Eigen::MatrixXd probeShapes() const;

    TakeFocus takeFocus;
    std::atomic<bool> wantsOpenGraph { false };
    std::atomic<std::int64_t> latency { 0 }; ///< Samples.

    Requests asked;                              ///< So far, for the next round; under the lock, as the next lines.
    std::shared_ptr<const FocusDocument> newest; ///< Was loaded last.
    DesignProgress designs;

    std::shared_ptr<const FocusDocument> focus; ///< Of the session's thread, as all below.
    std::shared_ptr<const ModalModel> loadedModel,
        designedModel;                               ///< Under all fingers, and under those that designs know.
    std::shared_ptr<const ModalModel> loadedModelOf; ///< What these were made of, with the next two lines.
    std::vector<Finger> fingers;
    std::vector<int> idle; ///< Ceramics that listen.
    double rate = 0;       ///< Hz, of the path.
    GraphChoice graph;
    bool isFocusNew = false, isGraphNew = false;
};
} // namespace antinode
