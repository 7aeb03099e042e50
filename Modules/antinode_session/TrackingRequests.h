#pragma once

#include "KnownDrift.h"
#include "TrackingSettings.h"
#include "TrackingStatus.h"

#include <memory>
#include <mutex>

namespace antinode
{
/** What is new of tracking in a round of a session's thread. */
struct TrackingRound
{
    TrackingSettings settings;
    bool isDriftNew = false; ///< Whether it goes on from the next line; none: the model.
    std::shared_ptr<const KnownDrift> drift;
};

/** What a session's thread is asked of tracking, and what it answers, under one lock. */
class TrackingRequests
{
public:
    /** [any but the audio thread] */
    void setSettings (const TrackingSettings&);
    TrackingSettings settings() const;

    /** Goes on from another drift. @param known  of the device that plays; none: as the model [any but the audio
        thread] */
    void setDrift (std::shared_ptr<const KnownDrift> known);

    /** What is known of the drift; none: nothing. [any but the audio thread] */
    std::shared_ptr<const KnownDrift> drift() const;

    /** [any but the audio thread] */
    std::shared_ptr<const TrackingStatus> status() const;

    /** What was asked for since the last call. [session's thread] */
    TrackingRound take();

    /** What is tracked so far. [session's thread] */
    void publish (std::shared_ptr<const TrackingStatus>, std::shared_ptr<const KnownDrift>);

private:
    mutable std::mutex mutex; ///< For all that follows.
    TrackingRound asked;
    std::shared_ptr<const TrackingStatus> statusNow = std::make_shared<const TrackingStatus>();
    std::shared_ptr<const KnownDrift> driftNow;
};
} // namespace antinode
