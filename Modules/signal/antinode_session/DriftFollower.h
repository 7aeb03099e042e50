#pragma once

#include "Following.h"
#include "KnownDrift.h"
#include "SensorTap.h"

#include <Eigen/Core>
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

/** The drift of a session's device, as the session's thread uses it: who listens, what is known, and whether designs
   are to be made again. All functions are of that thread. Docs/Design/session.md */
class DeviceFollowing
{
public:
    explicit DeviceFollowing (std::shared_ptr<FollowingRequests>);

    /** Takes what front ends ask for. @param model  of the device, without drift; none: it is not solved yet */
    void take (const ModalModel* model);

    /** Another device: what is known is of the one before. */
    void forget();

    /** Whether another sensor needs a path that listens, which is to be built now. */
    bool isSensorNew() const { return hasOtherSensor; }

    /** Ceramics that listen and are not driven, from 1. One that is not there is left to the follower, which says so.
     */
    std::vector<int> idleCeramics (const ModalModel*) const;

    /** Ends what listens, and listens to a new path. @param followed  without drift, with all ceramics */
    Listening listen (std::shared_ptr<const ModalModel> followed, double sampleRate);

    /** Nothing is learnt while there is a reason, a sentence; what is known stays. */
    void setHindrance (const std::string& reason);

    /** Reads the follower, and publishes what is new. */
    void read (const ModalModel*);

    /** Ends what listens. */
    void stop() { follower.reset(); }

    /** Whether frequencies have moved since the designs were made; by more where these are still being made.
        @param areMade  whether they are ready */
    bool needsDesigns (bool areMade) const { return designed.isOutdated (shifted, areMade); }

    /** Designs are made for the device as it is now. */
    void noteDesigned();

    /** The device as it is now. */
    DriftedDevice device (const ModalModel* model) const { return { drift, idleCeramics (model) }; }

    /** A model as designs are to know it now. @param model  as described */
    std::shared_ptr<const ModalModel> driven (const std::shared_ptr<const ModalModel>& model) const
    {
        return device (model.get()).asDriven (model);
    }

    /** Of all frequencies of the model. */
    const FrequencyShift& shift() const { return shifted; }

private:
    std::shared_ptr<FollowingRequests> requests;
    FollowingSettings settings;
    std::string hindrance;
    std::unique_ptr<DriftFollower> follower;
    std::shared_ptr<const KnownDrift> drift;
    std::shared_ptr<const KnownDrift> seenDrift;       ///< That was published, as the next line.
    std::shared_ptr<const FollowingStatus> seenStatus; ///< Of the follower, or the next line.
    const std::shared_ptr<const FollowingStatus> notFollowed = std::make_shared<const FollowingStatus>();
    FrequencyShift shifted;
    DesignedDrift designed;
    int redesigns = 0;
    bool hasOtherSensor = false;
};
} // namespace antinode
