#pragma once

#include "NewestQuestion.h"

#include <antinode_focus/FocusDescription.h>
#include <antinode_model/VoltageProgram.h>
#include <antinode_session/Documents.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace antinode
{
/** A search of better places for the ceramics of a drawn device. */
struct PlaceQuestion
{
    std::shared_ptr<const DeviceDocument> device;
    FocusDescription focus; ///< Whose voltage counts.
    Playback playback;      ///< With a rate of more than 0.
};

/** How far a search is. */
struct PlaceProgress
{
    std::shared_ptr<const DeviceDocument> device; ///< Whose ceramics are placed; none: nothing was asked for.
    bool isRunning = false;
    double share = 0;                         ///< 0 to 1
    std::vector<CeramicDescription> ceramics; ///< At the best places, once it has ended; empty: none.
    double voltsNow = 0, voltsThere = 0;      ///< V that the focus needs, on coarse modes.
    std::string error;                        ///< Why there are no better places.
};

/** Searches places for ceramics on a thread that runs it: by the controllability of the lowest modes, then by the
   voltage of the present focus. The editor may go before the thread: both share it. */
class PlaceSearch
{
public:
    /** Searches until it is stopped. [worker] */
    void run();

    /** Returns at once. [message thread, as all below] */
    void leave() { questions.leave(); }

    void ask (PlaceQuestion);

    /** Ends the search that goes on; it finds nothing. */
    void stop();

    PlaceProgress progress() const;

private:
    void search (const PlaceQuestion&);
    void set (const std::function<void (PlaceProgress&)>&);

    NewestQuestion<PlaceQuestion> questions; ///< Those of a search that is stopped are given up.
    mutable std::mutex mutex;
    PlaceProgress known; ///< Under the mutex.
};
} // namespace antinode
