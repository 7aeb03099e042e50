#pragma once

#include "FollowingSettings.h"
#include "FollowingStatus.h"
#include "KnownDrift.h"
#include "SensorTap.h"

#include <antinode_base/BackgroundThread.h>
#include <antinode_model/ModalModel.h>

#include <memory>
#include <string>
#include <vector>

namespace antinode
{
/** Follows the drift of a device that plays, window by window, on a thread of its own. It reads what the audio thread
   writes to a tap; whoever plays asks for what is known and designs again. Docs/Design/session.md. */
class DriftFollower
{
public:
    /** What is followed, and by what. */
    struct Setup
    {
        std::shared_ptr<const ModalModel> model; ///< As it is without drift, with all ceramics.
        FollowingSettings settings;
        std::shared_ptr<SensorTap> tap;
        std::shared_ptr<const KnownDrift> known; ///< From before, of the same device; none: the model.
        std::vector<FollowedMoment> trace;       ///< From before.
    };

    /** Starts. A device or sensor that cannot be followed becomes a status. [worker] */
    explicit DriftFollower (Setup);

    /** Does not wait for a window that is under way. [any but the audio thread] */
    ~DriftFollower();
    DriftFollower (const DriftFollower&) = delete;
    DriftFollower& operator= (const DriftFollower&) = delete;

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
    std::shared_ptr<const FollowingStatus> status() const;

private:
    struct Work;
    class Follower;

    static void follow (Work&);

    std::shared_ptr<Work> work;
    BackgroundThread thread;
};
} // namespace antinode
