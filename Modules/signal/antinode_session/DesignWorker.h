#pragma once

#include "DesignRequest.h"
#include "NoteBank.h"

#include <antinode_engine/FocusBank.h>
#include <antinode_focus/FocusDesign.h>
#include <antinode_focus/SpillOver.h>

#include <array>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace antinode
{
/** Designs the places of a bank one after the other, and keeps what they share: the modes beyond the device's own,
   which only waveforms of samples need, and how many of these the first place had to guard. One thread at a time. */
class PlaceDesigner
{
public:
    /** The places that come belong to another request. Where only its voltage limit is another one, guards stay.
     * [worker] */
    void begin (const DesignRequest& request);

    /** A focus of the request, at one of its places or another one.
        @throws InputError, LimitError  as designFocus
        [worker] */
    FocusDesign design (const DesignRequest& request, const FocusDescription&);

private:
    FocusDesign designSamples (const DesignRequest&, const FocusDescription&);
    FocusDesign designKeepingGuards (const FocusDescription&, Playback);
    FocusDesign withAllGuards (FocusDesign, double share, const FocusDescription&, Playback) const;

    std::shared_ptr<const ModalModel> known; ///< What the wide model was made of.
    std::optional<WideModel> wide;
    std::string guardedFocus;          ///< As text, without its limit.
    std::optional<ModalModel> guarded; ///< With what the first place guards beyond; none: no place is designed yet.
    bool areGuardsSure = false;        ///< False: limits moved since they were found.
};

/** What a prepared place plays. */
struct PreparedDesign
{
    VoltageProgram program;
    double peakVoltage = 0;       ///< V, at an amplitude of 1.
    double captured = 1;          ///< Of the wanted field by the controlled modes, 0 to 1.
    std::pair<double, double> at; ///< x, y in m: where it is to be felt.
};

/** Designs one for a device. @throws InputError  why there is none [worker] */
using PrepareDesign = std::function<PreparedDesign (const ModalModel&, Playback)>;

/** What designs a focus. [any] */
PrepareDesign preparesFocus (FocusDescription);

/** What a prepared place needs and gives. */
struct PreparedFocus
{
    std::string error;         ///< Why there is none; empty: there is one, and the next lines say what it is.
    double peakVoltage = 0;    ///< V, at an amplitude of 1.
    double captured = 0;       ///< Of the wanted field by the controlled modes, 0 to 1.
    double sensationLevel = 0; ///< dB SL at the target, without a finger on it.
    double focusSeconds = 0, endSeconds = 0; ///< After the trigger.
};

/** Designs banks on a thread of its own and hands them over: the focus at its own place first, then the wanted notes'
   places one by one, then the others in parts (BankOrder). A newer request replaces one that has not been finished:
   rapid changes of a parameter coalesce, and a design that takes long is given up. Until a place is designed again it
   keeps the focus that it had. A touched place is designed between two others. */
class DesignWorker
{
public:
    /** @param handOver  outlives this. [worker] starts the thread */
    explicit DesignWorker (BankHandOver& handOver);

    /** Abandons what is not finished and joins the thread. [worker] */
    ~DesignWorker();
    DesignWorker (const DesignWorker&) = delete;
    DesignWorker& operator= (const DesignWorker&) = delete;

    /** Asks for a bank. Returns at once. [any but the audio thread] */
    void request (DesignRequest);

    /** Gives up what is not finished of the newest request: the foci that were handed over play on, its own and those
        of the requests before. Touched places are designed all the same. Returns at once. [any but the audio thread] */
    void abandon();

    /** Designs the newest request's focus at another place; calls back, on the worker's thread, when it has been handed
       over. The last 16 touched places are kept. More than 16 that wait are not taken.
        @param x, y      m
        @param ready     gets the place of the bank, or -1 where no focus could be designed there
        @param isWanted  none: always. Once it says no the touch is forgotten and its design given up; called on several
            threads
        @return          whether it was taken
        [any but the audio thread] */
    bool touch (double x, double y, std::function<void (int place)> ready, std::function<bool()> isWanted = {});

    /** Designs a focus for a prepared place, after what is under way, and again whenever another request comes with
        another model or playback; of each model once. @param place  from FocusBank::firstPreparedPlace on
        @param ready  called on the worker's thread each time [any but the audio thread] */
    void prepare (int place, PrepareDesign, std::function<void (const PreparedFocus&)> ready);

    /** Waits until the newest request is designed and handed over at these places, which come before all others.
        @throws Cancelled  where a watch of this thread says no
        [any but a real-time audio thread] */
    void waitFor (std::span<const int> places);

    /** [any but the audio thread] */
    DesignProgress progress() const;

private:
    using Clock = std::chrono::steady_clock;

    using Places = std::array<bool, FocusBank::places>;

    struct Touch
    {
        double x = 0, y = 0;
        std::function<void (int)> ready;
        std::function<bool()> isWanted;

        bool isVoid() const { return isWanted && ! isWanted(); }
    };

    struct Prepared
    {
        PrepareDesign design;
        std::function<void (const PreparedFocus&)> ready;
        bool isDesigned = false; ///< For what is accepted.
    };

    void run();
    bool isAnyUnprepared() const;
    void designPrepared();
    std::optional<PreparedFocus> designPreparedPlace (int place, const PrepareDesign&);
    void designBank (const DesignRequest&, Clock::time_point asked);
    bool designPlace (const DesignRequest&, int place, const FocusDescription&);
    bool mayContinue (int place, Clock::time_point begin) const;
    void designTouches();
    void designTouch (const Touch&);
    bool isOutdated() const;
    void handOverBank();
    void noteReady (const DesignRequest&, const Places& isDone, Clock::time_point asked);
    BankOrder::Next nextPlace (BankOrder&) const;

    BankHandOver& handOver;
    mutable std::mutex mutex;
    mutable std::condition_variable changed;
    std::optional<DesignRequest> next; ///< Under the mutex, as all that follows.
    std::vector<Touch> touches;
    std::map<int, Prepared> prepared;
    std::vector<int> urgent; ///< Urgent places.
    Places isReady {};       ///< The places of the newest request that were handed over.
    Clock::time_point nextRequestTime;
    DesignProgress state;
    bool isStopping = false, isWorking = false, isAbandoned = false;
    FocusBank bank;                        ///< Of the thread only: what was designed so far.
    std::optional<DesignRequest> accepted; ///< Of the thread only: what touches are designed by.
    PlaceDesigner designer;                ///< Of the thread only.
    int nextTouchPlace = 0;                ///< Of the thread only.
    std::thread thread;
};
} // namespace antinode
