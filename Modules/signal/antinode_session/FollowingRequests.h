#pragma once

#include "FollowingSettings.h"
#include "FollowingStatus.h"
#include "KnownDrift.h"

#include <memory>
#include <mutex>

namespace antinode
{
/** What is new of following in a round of a session's thread. */
struct FollowingRound
{
    FollowingSettings settings;
    bool isDriftNew = false; ///< Whether it goes on from the next line; none: the model.
    std::shared_ptr<const KnownDrift> drift;
};

/** What a session's thread is asked of following, and what it answers, under one lock. */
class FollowingRequests
{
public:
    /** [any but the audio thread] */
    void setSettings (const FollowingSettings&);
    FollowingSettings settings() const;

    /** Goes on from another drift. @param known  of the device that plays; none: as the model [any but the audio
        thread] */
    void setDrift (std::shared_ptr<const KnownDrift> known);

    /** What is known of the drift; none: nothing. [any but the audio thread] */
    std::shared_ptr<const KnownDrift> drift() const;

    /** [any but the audio thread] */
    std::shared_ptr<const FollowingStatus> status() const;

    /** What was asked for since the last call. [session's thread] */
    FollowingRound take();

    /** What is followed so far. [session's thread] */
    void publish (std::shared_ptr<const FollowingStatus>, std::shared_ptr<const KnownDrift>);

private:
    mutable std::mutex mutex; ///< For all that follows.
    FollowingRound asked;
    std::shared_ptr<const FollowingStatus> statusNow = std::make_shared<const FollowingStatus>();
    std::shared_ptr<const KnownDrift> driftNow;
};
} // namespace antinode
