#pragma once

#include "FollowingReport.h"
#include "HeadlessRun.h"
#include "StandaloneHost.h"

#include <vector>

namespace antinode
{
/** Foci without windows: the notes of a schedule, once those are designed. */
class FociRun : public HeadlessRun
{
public:
    /** As HeadlessRun. [message thread] */
    FociRun (StandaloneHost& hostToPlay, std::vector<TimedNote> notes, double seconds, bool isArmed);

private:
    bool isReady() override;
    std::string waitingFor() const override;
    std::string designsText() const override;
    void begin() override;
    void tick() override;
    std::string playedText() override;
    std::string outcomeText() override;

    StandaloneHost& foci;
    FollowingReport following;
};
} // namespace antinode
