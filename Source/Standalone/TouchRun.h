#pragma once

#include "FollowingReport.h"
#include "HeadlessRun.h"
#include "TouchHost.h"

namespace antinode
{
/** Antinode Touch without windows, from when its filters are designed. */
class TouchRun : public HeadlessRun
{
public:
    /** As HeadlessRun. [message thread] */
    TouchRun (TouchHost& hostToPlay, double seconds, bool isArmed)
        : HeadlessRun (hostToPlay, seconds, isArmed), touch (hostToPlay)
    {
    }

private:
    bool isReady() override;
    std::string waitingFor() const override;
    std::string designsText() const override;
    void begin() override { begun = touch.callback().samplesPlayed(); }
    void tick() override;
    std::string playedText() override;
    std::string outcomeText() override;

    TouchHost& touch;
    FollowingReport following;
    std::int64_t begun = 0; ///< Samples that the program had played when it began.
};
} // namespace antinode
