#pragma once

#include "DesignedDrift.h"
#include "DriftFollower.h"
#include "FollowingRequests.h"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace antinode
{
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
