#pragma once

#include "KnownDrift.h"
#include "SensorTap.h"
#include "TrackingSettings.h"
#include "TrackingStatus.h"

#include <antinode_base/BackgroundThread.h>
#include <antinode_model/ModalModel.h>

#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** Follows the drift of a device that plays, window by window, on a thread of its own. It reads what the audio thread
   writes to a tap; whoever plays asks for what is known and designs again. Docs/Decisions/0153. */
class DriftTracker
{
public:
    /** What is tracked, and by what. */
    struct Setup
    {
        std::shared_ptr<const ModalModel> model; ///< As it is without drift, with all ceramics.
        TrackingSettings settings;
        std::shared_ptr<SensorTap> tap;
        std::shared_ptr<const KnownDrift> known; ///< From before, of the same device; none: the model.
        std::vector<TrackedMoment> trace;        ///< From before.
    };

    /** Starts. A device or sensor that cannot be tracked becomes a status. [worker] */
    explicit DriftTracker (Setup);

    /** Does not wait for a window that is under way. [any but the audio thread] */
    ~DriftTracker();
    DriftTracker (const DriftTracker&) = delete;
    DriftTracker& operator= (const DriftTracker&) = delete;

    /** Stops learning, and goes on. [any but the audio thread] */
    void setFrozen (bool);

    /** Learns nothing while there is a reason. @param reason  a sentence; empty: none [any but the audio thread] */
    void setHindrance (const std::string& reason);

    /** Goes on from another drift. @param known  none: the model, and the sensor is searched for [any but the audio
        thread] */
    void setKnown (std::shared_ptr<const KnownDrift> known);

    /** What is known; none: nothing beside the model. [any but the audio thread] */
    std::shared_ptr<const KnownDrift> known() const;

    /** [any but the audio thread] */
    std::shared_ptr<const TrackingStatus> status() const;

private:
    struct Work;
    class Follower;

    static void follow (Work&);

    std::shared_ptr<Work> work;
    BackgroundThread thread;
};
} // namespace antinode
